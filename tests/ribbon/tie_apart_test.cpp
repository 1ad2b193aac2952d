#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ribbon/direct_solver.h"
#include "tests/ribbon/tied_cords.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"

// Ties of points that are apart.

namespace ribbon {
namespace {

using constants::dt;
using test_support::hanging;

TEST(TiedCords, ThatAreApartAreDrawnTogether) {
  TiedCords tied;
  tied.cords.emplace_back(hanging(11, 1.0));
  CordDef def = level_rope({0.3, -1.0});
  tied.cords.emplace_back(def);
  tied.ties = {{0, 10, 1, 0}};
  double before = tied.gap();
  for (int k = 0; k < 60 && tied.gap() > 0.0; ++k) {
    tied.step();
    EXPECT_LE(tied.gap(), before) << "tick " << k;
    before = tied.gap();
  }
  EXPECT_EQ(tied.gap(), 0.0);
  for (int k = 0; k < 120; ++k) {
    tied.step();
    for (const Cord& cord : tied.cords) {
      for (const Vec2 v : cord.velocities()) ASSERT_LT(length(v), 12.0) << "tick " << k;
    }
  }
  EXPECT_EQ(tied.unconverged, 0);
}

/// A rope that lies below a taut one is tied to its middle, across a distance that their lengths do not allow to close.
TiedCords taut_and_below(const Accuracy& accuracy, bool taut_first = false) {
  TiedCords tied;
  CordDef taut = level_rope({0.0, 0.0});
  taut.pins = {0, 10};
  taut.accuracy = accuracy;
  CordDef below = level_rope({0.5, -1.4});
  below.pins = {0};
  below.accuracy = accuracy;
  tied.cords.emplace_back(taut_first ? taut : below);
  tied.cords.emplace_back(taut_first ? below : taut);
  tied.ties = {taut_first ? Tie{0, 5, 1, 10} : Tie{0, 10, 1, 5}};
  return tied;
}

TEST(TiedCords, ThatCannotReachEachOtherDoNotStretch) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    for (const bool taut_first : {false, true}) {
      TiedCords tied = taut_and_below(accuracy, taut_first);
      double most = 0.0;
      for (int k = 0; k < 240; ++k) {
        tied.step();
        most = std::max(most, tied.strain());
      }
      EXPECT_LT(most, 6e-3);
      EXPECT_GT(tied.gap(), 0.4 - 0.02);  // the least that the lengths allow
      EXPECT_LT(tied.gap(), 0.5);         // 1.4 m when they were tied
      EXPECT_EQ(tied.unconverged, 0);
    }
  }
}

// A tie whose points are apart gives way to whatever else moves its cords, and draws them together again afterwards.

TEST(ApartTies, GiveWayToAReel) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    TiedCords tied = taut_and_below(accuracy);
    tied.step(60);
    const double before = tied.gap();
    tied.cords[0].reel(0, 10, 0.6, 0.5);
    for (int k = 0; k < 90; ++k) {
      tied.step();
      ASSERT_LT(tied.strain(), 6e-3) << "tick " << k;
    }
    EXPECT_NEAR(tied.cords[0].rest_length(3), 0.06, 1e-12);
    EXPECT_GT(tied.gap(), before + 0.2);
    EXPECT_EQ(tied.unconverged, 0);
    tied.cords[0].reel(0, 10, 1.4, 0.5);
    tied.step(180);
    EXPECT_LT(tied.gap(), 1e-6);
    EXPECT_LT(tied.strain(), 6e-3);
  }
}

TEST(ApartTies, GiveWayToADraggedPoint) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    TiedCords tied = taut_and_below(accuracy);
    for (int k = 0; k < 240; ++k) {
      const double lift = std::abs(0.02 * std::sin(0.1 * k));
      tied.cords[1].operate(0, {lift, 0.0});
      tied.cords[1].operate(5, {0.5, lift});
      tied.cords[1].operate(10, {1.0 - lift, 0.0});
      tied.step();
      ASSERT_LT(tied.strain(), 6e-3) << "tick " << k;
    }
    EXPECT_LT(tied.gap(), 0.6);
    EXPECT_LE(tied.unconverged, 2);
  }
}

TEST(ApartTies, GiveWayToABodyThatHoldsThem) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    TiedCords tied = taut_and_below(accuracy);
    std::vector<RigidBody> bodies(1);
    bodies[0].position = {1.5, -1.4};
    bodies[0].velocity = {-0.3, 0.0};
    bodies[0].inverse_mass = bodies[0].inverse_inertia = 0.0;
    const Grip hand{10, 0, {}};
    for (int k = 0; k < 120; ++k) {
      tied.step(1, bodies, {&hand, 1});
      bodies[0].position += dt * bodies[0].velocity;
      ASSERT_LT(tied.strain(), 6e-3) << "tick " << k;
      ASSERT_LT(length(tied.position(0, 10) - bodies[0].position), 1e-3) << "tick " << k;
    }
    EXPECT_EQ(tied.unconverged, 0);
  }
}

}  // namespace
}  // namespace ribbon
