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
      ASSERT_LT(height_of(simulation, 0), 4.8) << back;
      ASSERT_LT(height_of(simulation, 1), 4.8) << back;
    }
    run(simulation, 1);
    run(simulation, 10, button_jump, button_jump);
    EXPECT_GT(height_of(simulation, 0), 5.0);
    EXPECT_GT(height_of(simulation, 1), 5.0);
  }
}

/// Puts the hand of the first player at the middle of a cord.
void put_first_at(Simulation& simulation, ribbon::box2d::CordId cord) {
  const auto points = simulation.scene().coupling().cord(cord).positions();
  const Player& first = simulation.player();
  const Vec2 feet_to_hand = first.hand() - first.position() + Vec2{0.0, 0.5 * first.tuning().height};
  simulation.player().put(points[points.size() / 2] - feet_to_hand, simulation.scene().coupling());
}

ribbon::box2d::CordId held_by_first(const Simulation& simulation) {
  const auto held = simulation.player().held_place(simulation.scene().coupling());
  return held ? held->cord : -1;
}

/// The second player throws a line, and the first one hangs from it.
void hang_from_partners_line(Simulation& simulation) {
  run(simulation, 10);
  run(simulation, 1, 0, button_throw);
  run(simulation, 30);
  ASSERT_TRUE(simulation.player(1).line().is_held());
  put_first_at(simulation, *simulation.player(1).line().cord());
  run(simulation, 1);
  run(simulation, 10, button_grab);
  ASSERT_EQ(held_by_first(simulation), *simulation.player(1).line().cord());
}

TEST(Partners, ALineThatIsLetGoStaysForAPartnerThatHangsFromIt) {
  Level level = level_for_two({.tied = false});
  level.hooks = {{11.0, 11.0}};
  Simulation simulation(level);
  ASSERT_NO_FATAL_FAILURE(hang_from_partners_line(simulation));
  const auto cord = *simulation.player(1).line().cord();
  for (const int buttons : {static_cast<int>(button_throw), 0, static_cast<int>(button_throw), 0}) {
    run(simulation, buttons != 0 ? 1 : 30, button_grab, buttons);
    EXPECT_EQ(held_by_first(simulation), cord) << buttons;
  }
  EXPECT_TRUE(simulation.player(1).line().is_held());  // a new one
  EXPECT_NE(*simulation.player(1).line().cord(), cord);
}

/// The first player catches the released line of the second while that throws a new one.
TEST(Partners, ALineThatIsCaughtDuringAThrowStays) {
  Level level = level_for_two({.tied = false});
  level.hooks = {{11.0, 11.0}};
  Simulation simulation(level);
  run(simulation, 10);
  run(simulation, 1, 0, button_throw);
  run(simulation, 30);
  run(simulation, 1, 0, button_throw);
  run(simulation, 60);
  ASSERT_EQ(simulation.player(1).line().state(), Line::State::released);
  const auto cord = *simulation.player(1).line().cord();
  put_first_at(simulation, cord);
  run(simulation, 1, 0, button_throw);
  run(simulation, 3, button_grab);
  ASSERT_EQ(held_by_first(simulation), cord);
  ASSERT_EQ(simulation.player(1).line().state(), Line::State::flying);
  run(simulation, 30, button_grab);
  ASSERT_TRUE(simulation.player(1).line().is_held());
  EXPECT_EQ(held_by_first(simulation), cord);
  EXPECT_NE(*simulation.player(1).line().cord(), cord);
  const auto points = simulation.scene().coupling().cord(cord).positions();
  EXPECT_LT(length(points.front() - level.hooks.front()), 0.01) << "it hangs where it was thrown at first";
  EXPECT_GT(length(points.back() - simulation.player(1).hand()), 0.5) << "and not from the hand that throws";
}

/// The second player ties more lines than stay. The first one hangs from the oldest.
TEST(Partners, TooManyKnotsLeaveTheOneThatAPartnerHangsFrom) {
  Level level = level_for_two({.tied = false});
  level.hooks = {{11.0, 11.0}};
  level.lines = 2;
  Simulation simulation(level);
  run(simulation, 10);
  const int both = button_throw | button_throw_second;
  const auto tie_two = [&](int first) {
    run(simulation, 1, first, both);
    run(simulation, 30, first);
    const auto lines = simulation.player(1).lines().all();
    ASSERT_TRUE(lines[0].is_held() && lines[1].is_held());
    run(simulation, 1, first, button_tie);
    run(simulation, 20, first);
  };
  run(simulation, 1, 0, both);
  run(simulation, 30);
  const auto oldest = *simulation.player(1).lines().all()[0].cord();
  const auto next = *simulation.player(1).lines().all()[1].cord();
  run(simulation, 1, 0, button_tie);
  run(simulation, 60);
  put_first_at(simulation, oldest);
  run(simulation, 1);
  run(simulation, 10, button_grab);
  const auto held = held_by_first(simulation);
  ASSERT_TRUE(held == oldest || held == next);
  for (std::size_t knots = 2; knots <= Lines::most_knots; knots += 2) ASSERT_NO_FATAL_FAILURE(tie_two(button_grab));
  EXPECT_EQ(held_by_first(simulation), held);
  EXPECT_FALSE(simulation.scene().coupling().cord(held == oldest ? next : oldest).is_valid());
}

}  // namespace
}  // namespace game
