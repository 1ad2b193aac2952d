#include "ribbon/system/stretch.h"

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace ribbon {
namespace {

using test_support::Dice;

/// The largest strain takes roots, became_stretched() mostly takes none.
TEST(Stretch, RootsDoNotDecide) {
  Dice dice(3);
  int stretched = 0;
  for (int run = 0; run < 2000; ++run) {
    CordDef def;
    def.points = 6;
    def.tension_only = run % 2 == 0;
    CordParts cord(def);
    IslandState state;
    Member& member = state.members.emplace_back();
    member.cord = &cord;
    member.points = cord.size();
    state.points = cord.size();
    const double size = dice(0.0, 3e-3) * cord.state.rest[0];
    for (const Vec2 x : cord.state.positions) {
      state.positions.push_back(x + size * Vec2{dice(-1.0, 1.0), dice(-1.0, 1.0)});
    }
    state.start.positions = cord.state.positions;
    const double now = largest_strain(member, state.positions);
    for (const double strain : {1e-3, (1.0 - 1e-9) * now, now, (1.0 + 1e-9) * now}) {
      EXPECT_EQ(became_stretched(state, strain), now > strain && now > largest_strain(member, cord.state.positions))
          << run << ": " << now << " of " << strain;
    }
    stretched += became_stretched(state, 1e-3) ? 1 : 0;
  }
  EXPECT_GT(stretched, 300);
  EXPECT_LT(stretched, 1700);
}

}  // namespace
}  // namespace ribbon
