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
  Tick rest = {};  ///< a part of the tick that is timed separately: b2World::Step after our part; may be empty
};

struct Timing {
  double median_us = 0.0;  ///< a tick and its rest: the median over the repeats of a repeat's mean; without a rest of
                           ///< the time that the program itself was running
  double p99_us = 0.0;  ///< that 99 of 100 single ticks of all repeats stay below. The clock is read after each, which
                        ///< costs it some 0.03 µs
  // If there is a rest:
  double share_us = 0.0;      ///< of the median's: the tick without its rest
  double rest_us = 0.0;       ///< and the rest
  double share_p99_us = 0.0;  ///< that 99 of 100 single ticks without their rest stay below
  double worst_us = 0.0;      ///< the most expensive tick without its rest; of each tick the median over the repeats
};

/// Returns the smallest value that `share` (0 … 1) of the values do not exceed. Requires at least one value.
double quantile(std::vector<double> values, double share);

/// They take turns, `ticks` at a time, `repeats` times over, so that a slow moment of a shared machine strikes all of
/// them alike. `progress` is called with the share done, 0 … 1.
std::vector<Timing> interleaved_timings(const std::vector<Timed>& contestants, int ticks, int repeats,
                                        const std::function<void(double)>& progress);

}  // namespace tradeoff
