#include "ribbon/box2d/coupling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/engine/coupling/thesis_coupling.h"
#include "tests/support/dice.h"
#include "tests/support/shape_world.h"

// The nearest point, and the nearest place between points, of all cords.

namespace engine {
namespace {

using ribbon::ThesisCord;
using test_support::step_cords;

TEST(Coupling, NothingIsNearNaN) {
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(coupling.nearest_point({nan, 0.0}, 10.0));
  EXPECT_FALSE(coupling.nearest_point({0.0, 0.0}, nan));
}

/// Returns the distance to the nearest point by a search of all points, or to the nearest place on the links between
/// points of the direct solver.
double nearest_distance(const ribbon::box2d::Coupling& coupling, Vec2 position, bool between_points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (ribbon::box2d::CordId c = 0; c < coupling.size(); ++c) {
    const auto x = coupling.cord(c).positions();
    const int rows = coupling.cord(c).shape().rows;
    for (int p = 0; p < static_cast<int>(x.size()); ++p) {
      const auto place_at = [&](double along) { return coupling.cord(c).position(p, along); };
      nearest = std::min(nearest, length(place_at(0.0) - position));
      if (!between_points || p + rows >= static_cast<int>(x.size()) ||
          coupling.cord(c).solver() == ribbon::box2d::Solver::thesis)
        continue;
      const Vec2 link = place_at(1.0) - place_at(0.0);
      const double along = std::clamp(dot(position - place_at(0.0), link) / dot(link, link), 0.0, 1.0);
      nearest = std::min(nearest, length(place_at(along) - position));
    }
  }
  return nearest;
}

TEST(Coupling, FindsTheSameAsASearchOfAllPoints) {
  ribbon::box2d::Coupling coupling;
  test_support::Dice dice(7);
  for (int k = 0; k < 40; ++k) {
    ribbon::CordDef def;
    def.points = 9;
    def.length = 2.0;
    def.pins = {0};
    def.allow_sleep = true;
    const Vec2 from{dice(-5.0, 5.0), dice(-5.0, 5.0)};
    const double turn = dice(0.0, 6.0);
    for (int p = 0; p < def.points; ++p)
      def.positions.push_back(from + 0.25 * p * Vec2{std::cos(turn), std::sin(turn)});
    coupling.add(ribbon::Cord(def));
  }
  coupling.add(ThesisCord(cord_def()));
  b2World world({0.0F, -9.81F});
  for (int tick = 0; tick < 60; ++tick) {
    step_cords(coupling, world, dt);
    if (tick % 4 == 0) {  // changes between two ticks
      coupling.cord(tick % 40).drag(0, {dice(-6.0, 6.0), dice(-6.0, 6.0)});
      coupling.cord(tick % 39).direct().restore(coupling.cord(tick % 39 + 1).direct().save());
    }
    for (int k = 0; k < 20; ++k) {
      const Vec2 position{dice(-8.0, 8.0), dice(-8.0, 8.0)};
      const double point = nearest_distance(coupling, position, false);
      const double place = nearest_distance(coupling, position, true);
      ASSERT_NEAR(coupling.nearest_point(position, 20.0)->distance, point, 1e-12);
      ASSERT_NEAR(coupling.nearest_place(position, 20.0)->distance, place, 1e-12);
      EXPECT_FALSE(coupling.nearest_point(position, 0.999 * point));
      EXPECT_FALSE(coupling.nearest_place(position, 0.999 * place));
    }
  }
}

TEST(Coupling, FindsTheNearestPointWithinADistance) {
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  coupling.add(ThesisCord(cord_def({0.0, 2.0})));
  const auto nearest = coupling.nearest_point({1.0, 1.8}, 0.5);
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->cord, 1);
  EXPECT_EQ(nearest->point, 10);
  EXPECT_NEAR(nearest->distance, 0.1, 1e-12);
  EXPECT_FALSE(coupling.nearest_point({1.0, 1.0}, 0.5));
}

}  // namespace
}  // namespace engine
