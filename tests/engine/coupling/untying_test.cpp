#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <vector>

#include "tests/engine/coupling/grip_world.h"

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::box2d::CordId;
using ribbon::box2d::TieId;

constexpr int tied_ticks = 60;
constexpr int free_ticks = 140;
constexpr int max_systems = 64;  // in a tick; while tied points were stuck in each other, each took 90 and more

/// How a loose rope of 2 m begins at a hanging one of 10 m.
struct Laid {
  int point;        ///< of the hanging rope
  int other_point;  ///< of the loose one, tied to it
  Vec2 start;       ///< m, of the loose rope
  Vec2 link;        ///< m
};

/// Two ropes that meet each other, tied at a point of each.
struct TiedRopes : GripWorld {
  TiedRopes(const Laid& laid, const Accuracy& accuracy,
            double breaking_force = std::numeric_limits<double>::infinity()) {
    CordDef def = hanging();
    def.cord_contact = true;
    def.radius = 0.03;
    def.accuracy = accuracy;
    const CordId held = coupling.add(Cord(def));
    def.pins.clear();
    def.points = 21;
    def.length = 2.0;
    def.positions = test_support::equally_spaced(21, laid.start, laid.link);
    loose = coupling.add(Cord(def));
    tie = coupling.tie({held, laid.point, loose, laid.other_point, breaking_force});
  }
  /// Ticks in which nothing is tied; each has to be solved, and to be cheap.
  void untie_and_tick() {
    tick(tied_ticks);
    ASSERT_TRUE(coupling.tie(tie).untie());
    for (int k = 0; k < free_ticks; ++k) {
      tick();
      ASSERT_EQ(coupling.last_step().report().unconverged, 0) << "tick " << k;
      ASSERT_LE(coupling.last_step().report().iterations, max_systems) << "tick " << k;
    }
  }
  Vec2 loose_point(std::size_t k) const { return coupling.cord(loose).positions()[k]; }

  CordId loose;
  TieId tie;
};

const std::array<Accuracy, 3> presets = {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()};

class Untying : public testing::TestWithParam<std::tuple<Laid, Accuracy>> {};

/// Points that were tied coincide, and a contact of two that coincide has no direction of its own.
TEST_P(Untying, LetsCordsThatMeetFallApart) {
  const auto& [laid, accuracy] = GetParam();
  TiedRopes scene(laid, accuracy);
  scene.untie_and_tick();
  EXPECT_LT(scene.loose_point(10).y, -25.0) << "in free fall it would be 26.7 m lower than where it was tied";
}

INSTANTIATE_TEST_SUITE_P(, Untying,
                         testing::Combine(testing::Values(Laid{20, 0, {0.0, -4.0}, {0.1, 0.0}},       // by its end
                                                          Laid{20, 20, {-2.0, -4.0}, {0.1, 0.0}},     // by the other
                                                          Laid{20, 0, {0.0, -4.0}, {0.02, 0.09798}},  // along the rope
                                                          Laid{50, 0, {0.0, -10.0}, {0.0, -0.1}},     // end to end
                                                          Laid{50, 10, {-1.0, -10.0}, {0.1, 0.0}}),   // below it
                                          testing::ValuesIn(presets)));

TEST(BreakingTie, LetsCordsThatMeetFallApart) {
  for (const Accuracy& accuracy : presets) {
    TiedRopes scene({20, 0, {0.0, -4.0}, {0.1, 0.0}}, accuracy, 0.5);  // N, a quarter of the loose rope's weight
    for (int k = 0; k < free_ticks; ++k) {
      scene.tick();
      ASSERT_EQ(scene.coupling.last_step().report().unconverged, 0) << "tick " << k;
      ASSERT_LE(scene.coupling.last_step().report().iterations, max_systems) << "tick " << k;
    }
    EXPECT_FALSE(scene.coupling.tie(scene.tie).is_valid());
    EXPECT_LT(scene.loose_point(10).y, -25.0);
  }
}

/// A rope across another one stays across it, because neither can pass.
TEST(UntyingAcross, IsCheap) {
  for (const Accuracy& accuracy : presets) {
    TiedRopes scene({20, 10, {-1.0, -4.0}, {0.1, 0.0}}, accuracy);
    scene.untie_and_tick();
  }
}

/// A point on the edge of a ribbon leaves it outwards.
TEST(UntyingFromARibbon, LeavesItOnTheSideOfTheRope) {
  for (const int row : {0, 2}) {
    GripWorld scene;
    CordDef def;
    def.points = 11;
    def.rows = 3;
    def.length = 2.0;
    def.width = 0.4;
    def.radius = 0.02;
    def.stretch_stiffness = 1e5;
    def.bending_stiffness = 100.0;
    def.cord_contact = true;
    for (int column = 0; column < 11; ++column) {
      for (int k = 0; k < 3; ++k) def.positions.push_back({0.2 * k, -0.2 * column});
    }
    def.pins = {0, 1, 2};
    const CordId ribbon = scene.coupling.add(Cord(def));
    const double outwards = row == 0 ? -1.0 : 1.0;
    CordDef rope;
    rope.points = 11;
    rope.length = 1.0;
    rope.radius = 0.02;
    rope.cord_contact = true;
    rope.positions = test_support::equally_spaced(11, {0.2 * row, -1.0}, {0.1 * outwards, 0.0});
    const CordId loose = scene.coupling.add(Cord(rope));
    const TieId tie = scene.coupling.tie({ribbon, 3 * 5 + row, loose, 0});
    scene.tick();
    ASSERT_TRUE(scene.coupling.tie(tie).untie());
    for (int k = 0; k < free_ticks; ++k) {
      scene.tick();
      ASSERT_EQ(scene.coupling.last_step().report().unconverged, 0) << "row " << row << ", tick " << k;
      ASSERT_LE(scene.coupling.last_step().report().iterations, max_systems) << "row " << row << ", tick " << k;
    }
    EXPECT_LT(scene.coupling.cord(loose).positions()[0].y, -20.0) << "row " << row;
  }
}

}  // namespace
}  // namespace engine
