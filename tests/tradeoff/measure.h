#pragma once

#include <functional>
#include <vector>

namespace tradeoff {

/// One thing to time: called once a tick.
using Tick = std::function<void()>;

/// Median microseconds a tick of each contestant. They take turns, `ticks` at a time, `repeats` times over, so that a
/// slow moment of a shared machine strikes all of them alike. `progress` is told the share done, 0 … 1.
std::vector<double> interleaved_medians(const std::vector<Tick>& contestants, int ticks, int repeats,
                                        const std::function<void(double)>& progress);

}  // namespace tradeoff
