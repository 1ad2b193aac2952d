#include <gtest/gtest.h>
#include "tests/support/contact_scenes.h"

// A rope with four turns on itself around a post is pulled. Each point is coupled with one a turn further, so that
// elimination along the rope fills nearly all of the matrix.

namespace {

using test_support::CordMethod;
using test_support::CoupledWorld;

struct Wound {
  int unconverged = 0;
  double way = 0.0;  // m, displacement of the pulled end
};

Wound wound(const ribbon::Accuracy& accuracy, int ticks) {
  CordMethod method;
  method.accuracy = accuracy;
  CoupledWorld world(method, {0.0, 0.0});
  test_support::wind_coil(world, 1, 0.3);
  test_support::pull_coil(world, 20.0);
  const ribbon::Vec2 end = world.points(0).back();
  Wound sum;
  for (int tick = 0; tick < ticks; ++tick) {
    world.tick();
    const ribbon::IslandReport report = world.coupling.tick_report();
    sum.unconverged += report.unconverged;
  }
  sum.way = length(world.points(0).back() - end);
  return sum;
}

TEST(WoundRope, TightensWithinTheBudget) {
  const Wound sum = wound(ribbon::Accuracy::fast(), 60);
  EXPECT_LE(sum.unconverged, 30) << "of 60 ticks, while its turns slide";
  EXPECT_GT(sum.way, 0.05) << "it is drawn tight";
}

}  // namespace
