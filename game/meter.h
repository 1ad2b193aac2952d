#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/simulation.h"

namespace game {

/// What the debug view tells of the cost of ticks and of what they lost. It measures and remembers; no run depends on
/// it.
class Meter {
 public:
  /// After a tick that took so long.
  void add(const Simulation& simulation, std::int64_t nanoseconds);

  /// µs, of the last second's ticks: the median, and the dearest. 0 before the first.
  double median_us() const;
  double worst_us() const;
  /// By cord: how much longer than at rest it was, the most since the last restart, as a share.
  double peak_stretch(engine::CordIndex cord) const;

 private:
  static constexpr std::size_t remembered = ticks_per_second;

  std::array<double, remembered> recent_us_{};
  std::size_t ticks_ = 0;
  std::vector<double> peaks_;
  int last_run_tick_ = 0;
};

}  // namespace game
