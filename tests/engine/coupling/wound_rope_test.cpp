#include <gtest/gtest.h>
#include <algorithm>

#include "tests/support/contact_scenes.h"
#include "tests/support/points.h"

// A rope with four turns on itself around a post is pulled. Each point is coupled with one a turn further, so that
// elimination along the rope fills nearly all of the matrix. While the turns slide, most ticks (19 to 57 of 60, by a
// last digit of a matrix) end with a correction above the tolerance; what they give has to be sound all the same.

namespace {

using test_support::CordMethod;
using test_support::CoupledWorld;

struct Wound {
  int iterations = 0;    // the most of a tick
  double stretch = 0.0;  // the largest strain of the rope
  double way = 0.0;      // m, displacement of the pulled end
};

Wound wound(const ribbon::Accuracy& accuracy, int ticks) {
  CordMethod method;
  method.accuracy = accuracy;
  CoupledWorld world(method, {0.0, 0.0});
  test_support::wind_coil(world, 1, 0.3);
  test_support::pull_coil(world, 20.0);
  const ribbon::Vec2 end = world.points(0).back();
  const double before = test_support::path_length(world.points(0));
  Wound sum;
  for (int tick = 0; tick < ticks; ++tick) {
    world.tick();
    const ribbon::IslandReport report = world.coupling.last_step().report();
    sum.iterations = std::max(sum.iterations, report.iterations);
    sum.stretch = std::max(sum.stretch, test_support::path_length(world.points(0)) / before - 1.0);
  }
  sum.way = length(world.points(0).back() - end);
  return sum;
}

TEST(WoundRope, TightensWithinTheBudget) {
  const Wound sum = wound(ribbon::Accuracy::fast(), 60);
  EXPECT_LE(sum.iterations, 120);
  EXPECT_LE(sum.stretch, 1e-3);
  EXPECT_GT(sum.way, 0.05) << "it is drawn tight";
}

}  // namespace
