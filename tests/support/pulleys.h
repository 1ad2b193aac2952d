#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/pulley.h"

// Cords around wheels, whose motion is known.

namespace test_support {

/// A cord with a mass at each end over one wheel, at rest: Atwood's machine, or with friction and a motor a capstan.
struct Atwood {
  double left = 10.0;             ///< kg, at the first point
  double right = 12.0;            ///< kg, at the last point
  double mass_per_length = 1e-4;  ///< kg/m
  int points = 61;                ///< of the cord
  double depth = 3.5;             ///< m, of the masses below the axle
  ribbon::PulleyDef wheel{.center = {0.0, 5.0}, .radius = 0.2, .counterclockwise = false, .inertia = 0.5};
  ribbon::Accuracy accuracy{};

  ribbon::Cord cord() const;
};

/// Atwood's machine, whose wheel a wall carries, in steps of 1/60 s.
struct Machine {
  explicit Machine(const Atwood& of) : atwood(of), cord(of.cord()) { wall.position = of.wheel.center; }

  void step(int times = 1) {
    const ribbon::Axle axle{0, {}};
    ribbon::Surroundings surroundings;
    surroundings.bodies = {&wall, 1};
    surroundings.axles = {&axle, static_cast<std::size_t>(pulleys_of(cord).empty() ? 0 : 1)};
    for (int k = 0; k < times; ++k) {
      const ribbon::IslandReport report = cord.step(1.0 / 60.0, {0.0, -9.81}, surroundings);
      unconverged += report.unconverged;
      iterations = std::max(iterations, report.iterations);
    }
  }
  /// Returns how far the last point has fallen, m.
  double fall() const { return atwood.wheel.center.y - atwood.depth - cord.positions().back().y; }
  const ribbon::Pulley& pulley() const { return pulleys_of(cord)[0]; }

  Atwood atwood;
  ribbon::RigidBody wall;
  ribbon::Cord cord;
  int unconverged = 0;
  int iterations = 0;
};

/// A tackle with two wheels at a fixed block, at y = 6 m, and two at a block that moves, at y = 2 m: the load hangs on
/// four parts of the cord. Its first point is the hand's, and its last one is pinned.
ribbon::ReevedCord reeve_tackle(int points);
/// Returns a light cord of this tackle, pinned at its end, and without its pulleys; and with them.
ribbon::CordDef tackle_def(int points, const ribbon::Accuracy& accuracy = {});
ribbon::Cord tackle_cord(const ribbon::CordDef& def);
/// Returns its blocks, with a load [kg] at the one that moves.
std::vector<ribbon::RigidBody> tackle_blocks(double load);
/// Returns the places of its axles, m from the middle of their blocks, in their order. The blocks are 0 and 1.
std::vector<ribbon::Axle> axles_of_tackle();
inline constexpr ribbon::Vec2 moving_block{0.4, 2.0};  ///< m, middle of the block that moves
inline constexpr ribbon::Vec2 fixed_block{0.2, 6.0};   ///< m, middle of the other one

}  // namespace test_support
