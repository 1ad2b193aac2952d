#pragma once

#include <limits>

#include "tests/peers/plan.h"
#include "tests/peers/recording.h"

namespace peers {

/// The figures of a recording, computed in the same way for all engines; NaN for what the scene lacks.
struct Figures {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  int blew_up = 0;            ///< the first tick, from 1, with a value that is NaN or beyond 10 km; 0: none
  double stretch = none;      ///< of the rope that stretches most, maximum over ticks, relative to its length
  double stretch_m = none;    ///< the same, as a length
  double penetration = none;  ///< m, of a cord in a circle or an edge, maximum over ticks
  double drift = none;        ///< m, greatest distance of the last moving_body from its position in the first frame
  double jitter = none;       ///< m, its greatest motion in any of the last 60 ticks
  bool tunnelled = false;     ///< whether it ends below every point of the first cord
  int crossings = 0;          ///< of ribbons with themselves and each other, after the last tick
};

/// Returns the figures of any scene. `set_up` is that of the plan.
Figures figures_of(const SetUp& set_up, const Plan& plan, const Recording& recording);

/// Returns the RMS distance of the last moving_body from a path, m; infinite if the recording is shorter.
double path_error(const Recording& recording, const std::vector<ribbon::Vec2>& path);

}  // namespace peers
