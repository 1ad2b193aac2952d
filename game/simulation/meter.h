#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/simulation/simulation.h"

namespace game {

/// What the debug view tells of the cost of ticks and of what they lost. It measures and remembers; no run depends on
/// it.
class Meter {
 public:
  /// Whether the next tick is one of those whose error is to be estimated (ribbon::box2d::Coupling::estimate_errors):
  /// ten a second, for it costs more than the tick.
  bool wants_estimate() const { return ticks_ % ticks_an_estimate == 0; }
  /// After a tick that took so long. One with an estimate tells nothing of what others cost.
  void add(const Simulation& simulation, std::int64_t nanoseconds);

  /// µs, of the last second's ticks: the median, and the dearest. 0 before the first.
  double median_us() const;
  double worst_us() const;
  /// µs, of the last second's ticks, oldest first.
  std::vector<float> recent_us() const;
  /// By cord: how much longer than at rest it was, the most since the last restart, as a share.
  double peak_stretch(ribbon::box2d::CordId cord) const;
  /// m, by cord: the errors that the ticks of the last second made, estimated, summed up. They may heal, and what they
  /// set going may grow.
  double error_a_second(ribbon::box2d::CordId cord) const;

 private:
  static constexpr std::size_t remembered = ticks_per_second;
  static constexpr std::size_t ticks_an_estimate = 6;
  static constexpr std::size_t estimates = remembered / ticks_an_estimate;
  struct OfCord {
    double peak_stretch = 0.0;
    std::array<double, estimates> errors{};  // m, of a tick
  };

  std::array<double, remembered> recent_us_{};
  std::size_t ticks_ = 0;
  std::size_t timed_ = 0;
  std::size_t estimated_ = 0;
  std::vector<OfCord> cords_;
  int last_run_tick_ = 0;
};

}  // namespace game
