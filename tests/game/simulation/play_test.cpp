// Climbing, thrown lines, reeling, dropped loads, and respawning.

#include <gtest/gtest.h>

#include <algorithm>

#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"
#include "tests/game/simulation/press.h"
#include "tests/support/scripted_player.h"

namespace game {
namespace {

using ribbon::Vec2;
using test_support::Move;
using test_support::ScriptedPlayer;

/// Runs a script to its end.
void play(Simulation& simulation, std::vector<Move> moves) {
  ScriptedPlayer player(std::move(moves));
  while (true) {
    const engine::TickInput input = player.input(simulation);
    if (player.is_done()) return;
    ASSERT_FALSE(player.is_stuck()) << "in move " << player.move();
    simulation.tick(input);
  }
}

ribbon::box2d::CordPoint held(const Simulation& simulation) {
  return simulation.scene()
      .coupling()
      .body(simulation.player().body())
      .held_place()
      .value_or(ribbon::box2d::CordPoint{-1});
}

double held_arc(const Simulation& simulation) {
  const ribbon::box2d::CordPoint place = held(simulation);
  return simulation.scene().coupling().cord(place.cord).arc(place.point, place.along);
}

TEST(Climbing, GoesUpAndDownTheCordAtItsOwnSpeedsAndEndsBelowTheTop) {
  const Level level = load_level("pump_it_up");
  Simulation simulation(level);
  play(simulation, {test_support::run_past(7.0), test_support::jump_and_catch(button_right)});
  tick(simulation, button_grab, 30);
  const double caught = held_arc(simulation);
  tick(simulation, button_grab | button_up, 60);
  EXPECT_NEAR(held_arc(simulation), caught - simulation.player().tuning().climb_speed, 0.02);
  EXPECT_TRUE(simulation.player().is_climbing());
  tick(simulation, button_grab, 1);
  const double stopped = held_arc(simulation);
  tick(simulation, button_grab, 60);
  EXPECT_EQ(held_arc(simulation), stopped);
  tick(simulation, button_grab | button_down, 30);
  EXPECT_NEAR(held_arc(simulation), stopped + 0.5 * simulation.player().tuning().slide_speed, 0.02);
  tick(simulation, button_grab | button_up, 900);
  EXPECT_NEAR(held_arc(simulation), simulation.player().tuning().top_margin, 1e-6);
}

TEST(Climbing, LiftsTheClimber) {
  const Level level = load_level("pump_it_up");
  Simulation simulation(level);
  play(simulation, {test_support::run_past(7.0), test_support::jump_and_catch(button_right)});
  const double low = simulation.player().position().y;
  tick(simulation, button_grab | button_up, 300);
  EXPECT_GT(simulation.player().position().y, low + 5.0);
}

TEST(Catching, HoldsTheNearestPlaceOfACordBetweenItsPoints) {
  const Level level = load_level("pump_it_up");
  Simulation simulation(level);
  play(simulation, {test_support::run_past(7.0), test_support::jump_and_catch(button_right)});
  EXPECT_GT(held(simulation).along, 0.0);
}

TEST(LettingGo, ByJumpingHopsAndKeepsTheVelocityOfTheSwing) {
  const Level level = load_level("pump_it_up");
  Simulation simulation(level);
  play(simulation, {test_support::run_past(7.0), test_support::jump_and_catch(button_right)});
  tick(simulation, button_grab | button_right, 30);
  Simulation& jumps = simulation;
  const Vec2 before = jumps.scene().coupling().body(jumps.player().body()).velocity();
  tick(jumps, button_jump);
  const Vec2 after = ribbon::box2d::to_double(jumps.player().body().GetLinearVelocity());
  EXPECT_NEAR(after.x, before.x, 0.05);
  EXPECT_NEAR(after.y, before.y + jumps.player().tuning().hop_speed - 9.81 / 60.0, 0.05);
}

TEST(LettingGo, AllowsAHopForAMoment) {
  const auto velocity_after = [](int wait) {
    const Level level = load_level("pump_it_up");
    Simulation simulation(level);
    play(simulation, {test_support::run_past(7.0), test_support::jump_and_catch(button_right)});
    tick(simulation, button_grab | button_right, 30);
    tick(simulation, 0, wait);
    const double before = static_cast<double>(simulation.player().body().GetLinearVelocity().y);
    tick(simulation, button_jump);
    return static_cast<double>(simulation.player().body().GetLinearVelocity().y) - before;
  };
  EXPECT_GT(velocity_after(3), 2.0);
  EXPECT_LT(velocity_after(10), 0.0);
}

/// Lets go of the rope while rising, and presses grab again after `pause` ticks, for `ticks`.
ribbon::box2d::CordPoint caught_again(int pause, int ticks) {
  const Level level = load_level("pump_it_up");
  Simulation simulation(level);
  play(simulation, {test_support::run_past(7.0), test_support::jump_and_catch(button_right)});
  const auto has_risen = [&] { return simulation.player().body().GetLinearVelocity().y > 1.0F; };
  while (!has_risen()) tick(simulation, button_grab);
  tick(simulation, 0, pause);
  for (int k = 0; k < ticks && held(simulation).cord < 0; ++k) tick(simulation, button_grab);
  return held(simulation);
}

/// The rope flies on beside the hand that has let go of it. It is there for another catch only after half a second.
TEST(LettingGo, LeavesTheRopeForHalfASecond) {
  EXPECT_EQ(caught_again(12, 1).cord, -1);
  EXPECT_EQ(caught_again(12, 17).cord, -1);
  EXPECT_EQ(caught_again(24, 5).cord, -1);
  EXPECT_EQ(caught_again(12, 40).cord, 0);
}

/// On a level with rings, standing near the first.
class ThrownLine : public testing::Test {
 protected:
  const Level level = load_level("long_line");
  Simulation simulation{level};
  const Vec2 ring = level.hooks.at(0);

  void SetUp() override {
    play(simulation, {test_support::run_past(7.2), test_support::stand()});
    tick(simulation, button_throw, 1, ring);
    ASSERT_EQ(simulation.player().line().state(), Line::State::flying);
    tick(simulation, 0, 20, ring);
  }
};

TEST_F(ThrownLine, CatchesTheRingAndIsAsLongAsTheDistance) {
  ASSERT_EQ(simulation.player().line().state(), Line::State::held);
  EXPECT_NEAR(simulation.player().line().length(), length(ring - simulation.player().hand()), 1e-3);
  const auto x = simulation.scene().coupling().cord(*simulation.player().line().cord()).positions();
  EXPECT_EQ(x.front(), ring);
}

TEST_F(ThrownLine, ReelsItsPlayerUp) {
  const double thrown = simulation.player().line().length();
  const double low = simulation.player().position().y;
  tick(simulation, button_reel_in, 150);
  EXPECT_GT(simulation.player().position().y, low + 3.0);
  EXPECT_FALSE(simulation.player().is_on_ground());
  EXPECT_NEAR(simulation.player().line().length(), thrown - 150.0 / 60.0 * 2.5, 1e-6);
  tick(simulation, button_reel_in, 600);
  EXPECT_EQ(simulation.player().line().length(), simulation.player().line().tuning().min_length);
  double sum = 0.0;  // the player swings, and the line is longer where it is fast
  for (int k = 0; k < 120; ++k) {
    tick(simulation, 0);
    sum += length(ring - simulation.player().hand());
  }
  EXPECT_LT(sum / 120.0, 1.5);
}

/// The line's elasticity stores the work of the reel: the player oscillates about the static stretch of the line.
TEST_F(ThrownLine, StretchesUnderItsBouncingPlayer) {
  tick(simulation, button_reel_in, 120);
  const double rest = simulation.player().line().length();
  double sum = 0.0;
  double least = 1.0;
  double most = 0.0;
  for (int k = 0; k < 600; ++k) {
    tick(simulation, 0);
    const double stretch = length(ring - simulation.player().hand()) / rest - 1.0;
    sum += stretch;
    least = std::min(least, stretch);
    most = std::max(most, stretch);
  }
  const double by_weight = 60.0 * 9.81 / simulation.player().line().tuning().stretch_stiffness;
  EXPECT_NEAR(sum / 600.0, by_weight, 0.5 * by_weight);
  EXPECT_GT(most - least, 0.5 * by_weight);
}

TEST_F(ThrownLine, IsReleasedByThrowingAndTheNextUsesTheSameCord) {
  tick(simulation, button_throw);
  EXPECT_EQ(simulation.player().line().state(), Line::State::released);
  EXPECT_FALSE(simulation.scene().coupling().body(simulation.player().body()).held_place());
  const int cords = simulation.scene().coupling().size();
  tick(simulation, 0);
  tick(simulation, button_throw, 1, ring);
  tick(simulation, 0, 30, ring);
  EXPECT_EQ(simulation.player().line().state(), Line::State::held);
  EXPECT_EQ(simulation.scene().coupling().size(), cords);  // the same cord is used again
}

TEST_F(ThrownLine, IsNotInterpolatedInItsFirstTick) {
  Simulation fresh(level);
  play(fresh, {test_support::run_past(7.2), test_support::stand()});
  tick(fresh, button_throw, 1, ring);
  while (fresh.player().line().state() == Line::State::flying) tick(fresh, 0, 1, ring);
  const Snapshot between = interpolate(fresh.previous(), fresh.current(), 0.5);
  EXPECT_EQ(between.cords.back(), fresh.current().cords.back());
}

/// The line snaps back with its stored energy, crumples, falls and comes to rest below its hook.
TEST(Line, ALineReleasedUnderTensionConvergesInEveryTickUntilItHangs) {
  Level level = load_level("long_line");
  level.assists.no_fall = true;  // after a fall the line stays
  Simulation simulation(level);
  ScriptedPlayer player(test_support::winning_script(level.name));
  while (simulation.player().line().state() != Line::State::released) {
    ASSERT_LT(simulation.ticks(), 1800);
    simulation.tick(player.input(simulation));
  }
  const ribbon::box2d::CordId cord = *simulation.player().line().cord();
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  tick(simulation, 0, 1200);
  EXPECT_EQ(coupling.cord(cord).island_total().unconverged, 0);
  const Vec2 hook = coupling.cord(cord).positions().front();
  const Vec2 end = coupling.cord(cord).positions().back();
  EXPECT_NEAR(hook.y - end.y, simulation.player().line().length(), 0.2);
  EXPECT_NEAR(end.x, hook.x, 0.5);
}

TEST(Aim, SelectsTheRingAtThePointerOrElseOneAhead) {
  const Level level = load_level("long_line");
  Simulation simulation(level);
  tick(simulation, 0);
  EXPECT_FALSE(simulation.target());  // none within the line's range
  play(simulation, {test_support::run_past(7.2), test_support::stand()});
  ASSERT_TRUE(simulation.target());
  EXPECT_EQ(simulation.target()->hook, 0U);
}

TEST(Load, FallsWhenItsHolderReleasesTheCord) {
  const Level level = load_level("heavy_load");
  Simulation simulation(level);
  const auto loads = simulation.scene().bodies();
  const auto load = std::find_if(loads.begin(), loads.end(),
                                 [](const engine::SceneBody& body) { return body.kind == engine::BodyKind::load; });
  ASSERT_NE(load, loads.end());
  const float hangs = load->body->GetPosition().y;
  tick(simulation, button_throw, 60);  // no effect without its cord in hand
  EXPECT_NEAR(static_cast<double>(load->body->GetPosition().y), static_cast<double>(hangs), 0.01);
  play(simulation, {test_support::run_past(4.3), test_support::jump(button_right, 30), test_support::run_past(8.0),
                    test_support::jump_and_catch(button_right)});
  tick(simulation, button_grab | button_throw);
  EXPECT_FALSE(simulation.scene().coupling().body(*load->body).held_place());
  EXPECT_TRUE(simulation.scene().coupling().body(simulation.player().body()).held_place());
  tick(simulation, button_grab, 60);
  EXPECT_LT(load->body->GetPosition().y, hangs - 0.8F);
}

TEST(Load, OfAThousandTimesItsCordsWeightDoesNotStretchIt) {
  const Level level = load_level("heavy_load");
  Simulation simulation(level);
  tick(simulation, 0, 300);
  const auto x = simulation.scene().coupling().cord(0).positions();
  double way = 0.0;
  for (std::size_t p = 1; p < x.size(); ++p) way += length(x[p] - x[p - 1]);
  EXPECT_NEAR(way, simulation.scene().coupling().cord(0).direct().def().length, 1e-6);
}

TEST(Checkpoint, IsTheStartAfterAFallAndARetry) {
  const Level level = load_level("round_the_pegs");
  Simulation simulation(level);
  tick(simulation, button_right, 30);
  tick(simulation, button_retry);
  EXPECT_NEAR(simulation.player().position().x, level.player_start.x, 0.2);
  play(simulation, {test_support::run_past(7.4), test_support::jump_and_catch(button_right),
                    test_support::pump_and_let_go(button_right, 0.45, 2.0), test_support::jump(button_right),
                    test_support::run_past(21.0), test_support::stand()});
  ASSERT_EQ(simulation.checkpoint(), 0U);
  while (simulation.falls() == 0) tick(simulation, button_right);  // over the edge
  const Area& area = level.checkpoints[0];
  EXPECT_NEAR(simulation.player().position().x, area.center.x, 0.2);
  EXPECT_GT(simulation.player().position().y, area.center.y - 0.5 * area.size.y);
}

TEST(Bridge, CarriesAPlayerThatWalksAndJumps) {
  const Level level = load_level("rolling_bridge");
  Simulation simulation(level);
  play(simulation, {test_support::run_past(14.0), test_support::stand()});
  const double stands = simulation.player().position().y;
  EXPECT_GT(stands, 4.5);
  tick(simulation, 0, 60);
  EXPECT_TRUE(simulation.player().is_on_ground());
  tick(simulation, button_jump, 20);
  EXPECT_GT(simulation.player().position().y, stands + 1.0);
}

TEST(Trampoline, ThrowsThePlayerHigherWithEachWellTimedJump) {
  const Level level = load_level("trampoline");
  Simulation simulation(level);
  play(simulation, {test_support::run_past(6.2), test_support::jump(button_right, 20), test_support::bounce(12.0, 11.0),
                    test_support::wait(1)});
  const double first = simulation.player().position().y;
  play(simulation, {test_support::wait(60), test_support::bounce(12.0, 13.0)});
  EXPECT_GT(simulation.player().position().y, first);
}

}  // namespace
}  // namespace game
