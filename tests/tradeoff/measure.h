#pragma once

#include <functional>
#include <vector>

namespace tradeoff {

/// Called once per tick.
using Tick = std::function<void()>;

/// A variant to time.
struct Timed {
  std::function<void()> reset;  ///< restores the start before every repeat, for equal work; empty: the run continues
  Tick tick;
  Tick rest = {};  ///< a part of the tick that is timed separately: b2World::Step after the cords; may be empty
};

struct Timing {
  double median_us = 0.0;  ///< a tick with its rest: median over the repeats of the mean; without a rest in processor
                           ///< time
  double least_us = 0.0;   ///< the same, but the least of the repeats: what the machine takes when nothing disturbs it
  double p99_us = 0.0;     ///< 99th percentile of single ticks of all repeats. Reading the clock after each adds some
                           ///< 0.03 µs
  double worst_us = 0.0;   ///< the most expensive tick without its rest; of each tick the median over the repeats
  // With a rest:
  double share_us = 0.0;      ///< part of the median: the tick without its rest
  double rest_us = 0.0;       ///< part of the median: the rest
  double share_p99_us = 0.0;  ///< 99th percentile of single ticks without their rest
};

/// Returns the value at place share · (n − 1), rounded down, of the n sorted values, from 0 on; `share` is 0 … 1.
/// Requires at least one value.
double quantile(std::vector<double> values, double share);

/// Times variants in turn, `ticks` at a time, `repeats` times, so that a slow moment of a shared machine affects all
/// of them alike. `progress` is called with the share done, 0 … 1.
std::vector<Timing> interleaved_timings(const std::vector<Timed>& variants, int ticks, int repeats,
                                        const std::function<void(double)>& progress);

}  // namespace tradeoff
