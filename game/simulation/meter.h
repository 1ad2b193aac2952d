#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/simulation/simulation.h"

namespace game {

/// Statistics of cost, stretch and error for the debug view. It does not influence the run.
class Meter {
 public:
  /// Returns whether the error of the next tick should be estimated (ribbon::box2d::Coupling::estimate_errors): ten
  /// times per second, since an estimate costs more than the tick.
  bool wants_estimate() const { return ticks_ % ticks_per_estimate == 0; }
  /// Adds a tick that took this long. The time of a tick with an estimate is ignored.
  void add(const Simulation& simulation, std::int64_t nanoseconds);

  /// The median and the maximum cost of the ticks of the last second in µs; 0 before the first.
  double median_us() const;
  double worst_us() const;
  /// The costs of the ticks of the last second in µs, oldest first.
  std::vector<float> recent_us() const;
  /// The largest strain of a cord since the last restart: length / rest length − 1.
  double peak_stretch(ribbon::box2d::CordId cord) const;
  /// The sum of the estimated errors of a cord in the ticks of the last second, in m. The true error can be smaller or
  /// larger, since later motion damps or amplifies errors.
  double error_per_second(ribbon::box2d::CordId cord) const;

 private:
  static constexpr std::size_t window_ticks = ticks_per_second;
  static constexpr std::size_t ticks_per_estimate = 6;
  static constexpr std::size_t estimates = window_ticks / ticks_per_estimate;
  struct CordFigures {
    double peak_stretch = 0.0;
    std::array<double, estimates> errors{};  // m, per tick
  };

  std::array<double, window_ticks> recent_us_{};
  std::size_t ticks_ = 0;
  std::size_t timed_ = 0;
  std::size_t estimated_ = 0;
  std::vector<CordFigures> cords_;
  int last_run_tick_ = 0;
};

}  // namespace game
