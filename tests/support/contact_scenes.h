#pragma once

#include <numbers>
#include <vector>

#include "tests/support/coupled_world.h"

// Initial states of scenes with contacts; the caller steps the world.

namespace test_support {

/// A cord of 31 points, 1 kg and 3 m hangs straight down without stretch, as cord 0, with a body of `ratio` kg at its
/// end. EA is `stiffness` times the total weight, infinity for an inextensible cord. Returns the body.
b2Body& hang_load(CoupledWorld& world, double ratio, double stiffness);

/// A level cord of 50 points and 5 m, and below it 20 static circles at different heights.
void lay_over_circles(CoupledWorld& world, double friction);

/// A cord of 41 points, 4.2 m and 0.42 kg between pins 4 m apart, and a ball of 0.25 m radius and `ratio` times the
/// cord's mass on its middle, both at rest after `settling` damped ticks. Returns the ball.
b2Body& hang_bridge(CoupledWorld& world, double ratio, int settling = 1800);

/// A cord around a static circle of 0.5 m radius at the origin, with 20 points per half turn. It comes from below at
/// the left and leaves the circle after `angle`, π or 2π; 0.5 m at both ends are free. For a world without gravity.
void wind_around_post(CoupledWorld& world, double angle, double friction);

/// 10 × 10 cords of 50 points in a hall with walls: alternately 0.8 m that hang by one end, and 1.5 m by both. 200
/// balls of 0.08 m between them, in random places by `seed`, fall and roll from cord to cord.
void hang_hall(CoupledWorld& world, unsigned seed = 1);

/// Returns the points of a spiral with links of equal length. The middle line begins at `radius` and is `pitch` further
/// out after each turn.
std::vector<ribbon::Vec2> wound(int points, double link, double radius, double pitch);
/// A cord with four loose counter-clockwise turns around a static circle of 0.3 m radius at the origin, and 1 m more.
/// Its inner end is pinned. With two `rows` it is a ribbon 3 cm wide. The turns are `looseness` times as far apart as
/// turns that touch.
void wind_coil(CoupledWorld& world, int rows, double friction, double looseness = 1.3);
/// Sets the force that pulls the coil's end, N.
void pull_coil(CoupledWorld& world, double force);
/// A kinematic body hauls the coil's end straight away, at a speed [m/s].
void haul_coil(CoupledWorld& world, double speed);

/// 5 m of cord, upright and almost straight in a bucket 1 m wide. With two `rows` it is a ribbon 3 cm wide.
void stand_in_bucket(CoupledWorld& world, int rows, double friction);

/// `count` ribbons of 33 × 2 points, 1.6 m long and 5 cm wide, ten per row, above a lattice of static circles in a
/// shaft with a floor. With `strip_contact` they collide with each other and themselves, otherwise only with circles.
void drop_strips(CoupledWorld& world, int count = 150, bool strip_contact = true);

}  // namespace test_support
