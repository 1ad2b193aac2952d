#pragma once

#include <numbers>
#include <vector>

#include "tests/support/coupled_world.h"

// Cords that touch: what stands, hangs and falls in a world, for whoever steps it.

namespace test_support {

/// 31 points of 1 kg and 3 m hang straight down, their links not stretched, with a body of `ratio` kg at the end, which
/// the world's cord 0 holds. With EA = `stiffness` times the weight of all, infinity for a cord that does not stretch.
/// Returns the body.
b2Body& hang_load(CoupledWorld& world, double ratio, double stiffness);

/// 50 points on 5 m, level, and below it 20 static circles at different heights.
void lay_over_circles(CoupledWorld& world, double friction);

/// A cord of 41 points, 4.2 m and 0.42 kg between pins at 4 m, and a ball of 0.25 m and `ratio` times its mass on its
/// middle, both at rest after `settling` ticks. Returns the ball.
b2Body& hang_bridge(CoupledWorld& world, double ratio, int settling = 1800);

/// Around a static circle of 0.5 m at the origin, without gravity, friction as given: a cord that comes up from below
/// at its left and leaves it after `angle`, π or 2π, with 0.5 m free at both ends. 20 points a half turn.
void wind_around_post(CoupledWorld& world, double angle, double friction);

/// 10 × 10 cords of 50 points in a hall with walls: in turn 0.8 m hung up by one end, and 1.5 m by both. 200 balls of
/// 0.08 m in random places between them, which fall and roll from cord to cord. `seed` says where.
void hang_hall(CoupledWorld& world, unsigned seed = 1);

/// Where the points of a cord are that is wound around a circle from a point of it on, link after link of equal
/// length. `radius` is where the cord's middle begins, and `pitch` how much further out it is a turn later.
std::vector<ribbon::Vec2> wound(int points, double link, double radius, double pitch);
/// A cord wound four turns, counter-clockwise and loosely, around a static circle of 0.3 m at the origin, its inner end
/// pinned, and 1 m more of it. `rows` of two make a ribbon 3 cm wide.
void wind_coil(CoupledWorld& world, int rows, double friction);
/// The force that pulls the coil's end on, N.
void pull_coil(CoupledWorld& world, double force);

/// 5 m of cord, standing on end in a bucket 1 m wide, not quite straight; `rows` of two make a ribbon 3 cm wide.
void stand_in_bucket(CoupledWorld& world, int rows, double friction);

/// `count` ribbons of 33 × 2 points, 1.6 m long and 5 cm wide, ten a row, above a lattice of static circles in a shaft
/// with a floor. `meeting` each other and themselves, or circles alone.
void drop_strips(CoupledWorld& world, int count = 150, bool meeting = true);

}  // namespace test_support
