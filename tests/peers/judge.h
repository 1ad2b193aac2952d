#pragma once

#include <limits>

#include "tests/peers/plan.h"
#include "tests/peers/recording.h"

namespace peers {

/// What a recording came to, by the same measures whichever engine made it. What a scene does not have is no number.
struct Figures {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  int blew_up = 0;            ///< the tick, from 1, in which something was no number or 10 km away; 0: none
  double stretch = none;      ///< of the rope that stretches most, after any tick, as a share of its length
  double stretch_m = none;    ///< the same, as a length
  double penetration = none;  ///< m, the deepest that a cord is in a circle or an edge after any tick
  double drift = none;        ///< m, the furthest that the last mover is from where it was in the first frame
  double jitter = none;       ///< m, the most that it moves in any of the last 60 ticks
  bool let_through = false;   ///< it is below every point of the first cord in the end
  int crossings = 0;          ///< of ribbons, with themselves and each other, after the last tick
};

/// All of it, for any scene. `set_up` is that of the plan.
Figures judge(const SetUp& set_up, const Plan& plan, const Recording& recording);

/// m, the root of the mean square of the distances of the last mover from a path. Infinite if the recording is shorter.
double path_error(const Recording& recording, const std::vector<ribbon::Vec2>& path);

}  // namespace peers
