#pragma once

#include "tests/extremes/any_scene/world.h"

namespace any_scene {

// Figures of a world, evaluated after each tick.

/// Measures the energy that the solver adds, divided by the greatest kinetic energy so far + the total weight times the
/// range of heights so far.
class EnergyBalance {
 public:
  /// Takes the start's energy [J], the total weight [N] and the lowest and highest place [m].
  EnergyBalance(const World::Energy& start, double weight, ribbon::Vec2 heights);

  struct Gain {
    double in_tick = 0.0;
    double since_lowest = 0.0;  ///< since the lowest energy so far
  };
  /// Leaves out what has happened to the energy since the last call: things are gone.
  void leave_out(const World::Energy& now);
  /// Updates the balance after a tick, and returns the gains.
  Gain take(const World::Energy& now, ribbon::Vec2 heights);

 private:
  double weight_;
  ribbon::Vec2 heights_;
  double kinetic_;
  double lowest_;
  double before_;
};

/// Holds the greatest relative length error of inextensible ropes, and the greatest strain of all other cords. What is
/// at a wheel, from the point before it to the one behind it, counts as one link along the tangents and the arc.
struct Lengths {
  double stretch = 0.0;
  double strain = 0.0;
};
Lengths lengths(const World& world);
/// Mass and momentum of all cords.
struct Inertia {
  double mass = 0.0;  ///< kg
  ribbon::Vec2 momentum;
};
Inertia inertia(const ribbon::box2d::Coupling& coupling);
/// Returns the difference of mass and momentum, relative to the mass and to the mass times the speed [m/s].
double difference(const Inertia& before, const Inertia& after, double speed);
/// Returns the number of inverted corners of cells, of ribbons with area stiffness.
int inverted(const ribbon::box2d::Coupling& coupling);

/// Returns the Newton steps of the last tick. Each island counts once, if islands can be distinguished.
int work(const ribbon::box2d::Coupling& coupling);
/// Returns the number of unconverged substeps of the last tick, of all islands.
int unconverged(const ribbon::box2d::Coupling& coupling);

}  // namespace any_scene
