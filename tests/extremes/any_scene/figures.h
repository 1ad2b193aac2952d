#pragma once

#include "tests/extremes/any_scene/world.h"

namespace any_scene {

// Figures of a world that are looked at after each tick.

/// Energy that comes from nowhere, as a share of the greatest kinetic energy so far and the weight of all times the
/// range of heights so far.
class EnergyBalance {
 public:
  /// J, N, m: at the start.
  EnergyBalance(const World::Energy& start, double weight, ribbon::Vec2 heights);

  struct Gain {
    double in_tick = 0.0;
    double since_lowest = 0.0;  ///< since energy was the least
  };
  /// After a tick.
  Gain take(const World::Energy& now, ribbon::Vec2 heights);

 private:
  double weight_;
  ribbon::Vec2 heights_;
  double kinetic_;
  double lowest_;
  double before_;
};

/// Of inextensible ropes the furthest that a link is off its length, relative; of the others the greatest strain.
struct Lengths {
  double stretch = 0.0;
  double strain = 0.0;
};
Lengths lengths(const ribbon::box2d::Coupling& coupling);
/// Corners of cells that are inside out, of ribbons with area stiffness.
int inverted(const ribbon::box2d::Coupling& coupling);

/// Returns the Newton steps of the last tick. Each island counts once, if islands can be distinguished.
int work(const ribbon::box2d::Coupling& coupling);
/// Substeps of the last tick, of all islands.
int unconverged(const ribbon::box2d::Coupling& coupling);

}  // namespace any_scene
