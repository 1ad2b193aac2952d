#pragma once

#include <functional>
#include <vector>

namespace tradeoff {

/// Called once a tick.
using Tick = std::function<void()>;

/// One thing to time.
struct Timed {
  std::function<void()> reset;  ///< back to the start before every repeat, so that all do the same work; empty: goes on
  Tick tick;
};

struct Timing {
  double median_us = 0.0;  ///< a tick: the median over the repeats of a repeat's mean
  double p99_us = 0.0;  ///< that 99 of 100 single ticks of all repeats stay below. The clock is read after each, which
                        ///< costs it some 0.03 µs
};

/// They take turns, `ticks` at a time, `repeats` times over, so that a slow moment of a shared machine strikes all of
/// them alike. `progress` is told the share done, 0 … 1.
std::vector<Timing> interleaved_timings(const std::vector<Timed>& contestants, int ticks, int repeats,
                                        const std::function<void(double)>& progress);

}  // namespace tradeoff
