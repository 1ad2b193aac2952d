#pragma once

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "ribbon/cut.h"

namespace test_support {

/// Mass [kg], momentum [N·s], angular momentum about the origin [N·m·s] and energy [J] of cords.
struct Sums {
  double mass = 0.0;
  ribbon::Vec2 momentum;
  double turning = 0.0;
  double energy = 0.0;

  void add(const ribbon::Cord& cord, ribbon::Vec2 gravity) {
    for (int p = 0; p < cord.size(); ++p) {
      const ribbon::Vec2 x = cord.positions()[static_cast<std::size_t>(p)];
      const ribbon::Vec2 v = cord.velocities()[static_cast<std::size_t>(p)];
      mass += cord.mass(p);
      momentum += cord.mass(p) * v;
      turning += cord.mass(p) * cross(x, v);
    }
    energy += energy_of(cord, gravity).total();
  }
};

inline Sums sums_of(const ribbon::Cord& cord, ribbon::Vec2 gravity) {
  Sums sums;
  sums.add(cord, gravity);
  return sums;
}

inline Sums sums_of(const ribbon::CutPieces& pieces, ribbon::Vec2 gravity) {
  Sums sums;
  if (pieces.first) sums.add(*pieces.first, gravity);
  if (pieces.second) sums.add(*pieces.second, gravity);
  return sums;
}

}  // namespace test_support
