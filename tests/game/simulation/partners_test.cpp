// What each of two players keeps: its keys over a return, and the line of the other from which it hangs.

#include <gtest/gtest.h>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "tests/game/simulation/press.h"
#include "tests/support/level_for_two.h"

namespace game {
namespace {

using ribbon::Vec2;
using test_support::level_for_two;

double y(const Simulation& simulation, int player) { return simulation.player(player).position().y; }

/// Player::put and the state at the start know nothing of the keys.
TEST(Partners, AKeyHeldOverAReturnIsNoNewPress) {
  const Level level = level_for_two({.tied = false});
  for (const int back : {static_cast<int>(button_retry), static_cast<int>(button_restart)}) {
    Simulation simulation(level);
    run(simulation, 30);
    run(simulation, 40, button_jump, button_jump);
    run(simulation, 1, button_jump | back, button_jump);
    for (int k = 0; k < 20; ++k) {
      simulation.tick(press(button_jump, button_jump));
      ASSERT_LT(y(simulation, 0), 4.8) << back;
      ASSERT_LT(y(simulation, 1), 4.8) << back;
    }
    run(simulation, 1);
    run(simulation, 10, button_jump, button_jump);
    EXPECT_GT(y(simulation, 0), 5.0);
    EXPECT_GT(y(simulation, 1), 5.0);
  }
}

/// The second player throws a line, and the first one hangs from it.
void hang_from_partners_line(Simulation& simulation) {
  run(simulation, 10);
  run(simulation, 1, 0, button_throw);
  run(simulation, 30);
  ASSERT_TRUE(simulation.player(1).line().is_held());
  const auto points = simulation.scene().coupling().cord(*simulation.player(1).line().cord()).positions();
  const Player& first = simulation.player();
  const Vec2 feet_to_hand = first.hand() - first.position() + Vec2{0.0, 0.5 * first.tuning().height};
  simulation.player().put(points[points.size() / 2] - feet_to_hand, simulation.scene().coupling());
  run(simulation, 1);
  run(simulation, 10, button_grab);
  const auto held = simulation.player().held_place(simulation.scene().coupling());
  ASSERT_TRUE(held);
  ASSERT_EQ(held->cord, *simulation.player(1).line().cord());
}

TEST(Partners, ALineThatIsLetGoStaysForAPartnerThatHangsFromIt) {
  Level level = level_for_two({.tied = false});
  level.hooks = {{11.0, 11.0}};
  Simulation simulation(level);
  ASSERT_NO_FATAL_FAILURE(hang_from_partners_line(simulation));
  const auto cord = *simulation.player(1).line().cord();
  for (const int buttons : {static_cast<int>(button_throw), 0, static_cast<int>(button_throw), 0}) {
    run(simulation, buttons != 0 ? 1 : 30, button_grab, buttons);
    const auto held = simulation.player().held_place(simulation.scene().coupling());
    ASSERT_TRUE(held) << buttons;
    EXPECT_EQ(held->cord, cord);
  }
  EXPECT_TRUE(simulation.player(1).line().is_held());  // a new one
  EXPECT_NE(*simulation.player(1).line().cord(), cord);
}

}  // namespace
}  // namespace game
