#include "game/simulation/simulation.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "engine/tick/tick.h"
#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "game/simulation/run_header.h"
#include "tests/game/simulation/press.h"
#include "tests/support/autopilot.h"
#include "tests/support/mixed_level.h"

namespace game {
namespace {

using test_support::first_swing_level;

/// Tests that hold for both solvers.
class EitherLevel : public testing::TestWithParam<bool> {
 protected:
  static const Level& level() {
    static const Level mixed = test_support::mixed_swing();
    return GetParam() ? mixed : first_swing_level();
  }
};
INSTANTIATE_TEST_SUITE_P(Simulation, EitherLevel, testing::Bool(),
                         [](const auto& mixed) { return mixed.param ? "mixed_swing" : "first_swing"; });

/// The inputs of the autopilot's winning run.
const std::vector<engine::TickInput>& winning_inputs() {
  static const std::vector<engine::TickInput> inputs = [] {
    Simulation simulation(first_swing_level());
    test_support::Autopilot autopilot;
    std::vector<engine::TickInput> recorded;
    while (!simulation.goal_ticks() && recorded.size() < 3600) {
      recorded.push_back(press(autopilot.buttons(simulation)));
      simulation.tick(recorded.back());
    }
    EXPECT_TRUE(simulation.goal_ticks());
    return recorded;
  }();
  return inputs;
}

TEST(Level, FirstSwingHasThreeCordsAndThreeLooseCircles) {
  const Simulation simulation(first_swing_level());
  EXPECT_GE(simulation.scene().coupling().size(), 3);
  int circles = 0;
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    const bool circle = body->GetFixtureList()->GetType() == b2Shape::e_circle;
    if (body->GetType() == b2_dynamicBody && circle) ++circles;
  }
  EXPECT_GE(circles, 3);
}

TEST(Level, ThePlayerIsAsHeavyAsTheMapSays) {
  const std::string path = testing::TempDir() + "heavy_player.tmj";
  std::ofstream(path) << test_support::mixed_swing_map();
  const Level level = load_level(path);
  EXPECT_EQ(Simulation(level).player().body().GetMass(), 5.0F);
  EXPECT_EQ(Simulation(first_swing_level()).player().body().GetMass(), 60.0F);
}

TEST_P(EitherLevel, CanBeWon) {
  Simulation simulation(level());
  test_support::Autopilot autopilot;
  while (!simulation.goal_ticks() && simulation.ticks() < 2400) simulation.tick(press(autopilot.buttons(simulation)));
  EXPECT_TRUE(simulation.goal_ticks());
}

TEST_P(EitherLevel, SameBitsOfTheSameInputsDraggingAndRestartIncluded) {
  Simulation one(level());
  Simulation other(level());
  test_support::Autopilot autopilot;
  for (int k = 0; k < 400; ++k) {
    engine::TickInput input = press(autopilot.buttons(one));
    if (k % 100 > 60) input.buttons |= button_drag;
    if (k == 300) input.buttons |= button_restart;
    engine::set_pointer(input, one.player().hand() + ribbon::Vec2{0.002 * (k % 100), 0.1});
    one.tick(input);
    other.tick(input);
    ASSERT_EQ(one.hash(), other.hash()) << "tick " << k;
  }
}

TEST(Level, BallsRollFallAndAreCaughtByTheHammock) {
  Simulation simulation(first_swing_level());
  for (int k = 0; k < 600; ++k) simulation.tick({});
  int caught = 0;
  for (std::size_t b = 0; b < simulation.current().bodies.size(); ++b) {
    const ribbon::Vec2 at = simulation.current().bodies[b].position;
    if (at.x > 32.4 && at.x < 39.2 && at.y > 5.5 && at.y < 9.0) ++caught;
  }
  EXPECT_GE(caught, 3);
}

struct AfterSomeTime {
  int ticks;
  std::uint64_t hash;
  bool operator==(const AfterSomeTime&) const = default;
};

/// Runs the game's loop for nine seconds at a given frame rate; the inputs follow the clock.
AfterSomeTime play_at(std::int64_t frames_per_second) {
  constexpr std::int64_t second = 1'000'000'000;  // ns
  Simulation simulation(first_swing_level());
  engine::FixedTick clock(ticks_per_second);
  for (std::int64_t frame = 0; frame < 9 * frames_per_second; ++frame) {
    int due = clock.advance((frame + 1) * second / frames_per_second - frame * second / frames_per_second);
    for (; due > 0; --due) {
      const auto next = static_cast<std::size_t>(simulation.ticks());
      simulation.tick(next < winning_inputs().size() ? winning_inputs()[next] : engine::TickInput{});
    }
    interpolate(simulation.previous(), simulation.current(), clock.alpha());  // drawing must not change anything
  }
  return {simulation.ticks(), simulation.hash().combined()};
}

TEST(SimulationSameBits, At20And60And144FramesASecond) {
  const AfterSomeTime at_60 = play_at(60);
  EXPECT_EQ(at_60.ticks, 540);
  EXPECT_EQ(play_at(20), at_60);
  EXPECT_EQ(play_at(144), at_60);
}

TEST(SimulationSameBits, RestartBeginsTheVerySameRun) {
  Simulation fresh(first_swing_level());
  Simulation restarted(first_swing_level());
  for (int k = 0; k < 100; ++k) restarted.tick(press(button_right));
  restarted.tick(press(button_restart | button_right));
  fresh.tick(press(button_right));
  for (int k = 0; k < 200; ++k) {
    fresh.tick(winning_inputs()[static_cast<std::size_t>(k)]);
    restarted.tick(winning_inputs()[static_cast<std::size_t>(k)]);
  }
  // All but the game's own counters, which include the first run.
  const auto a = fresh.hash().parts();
  const auto b = restarted.hash().parts();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 1; k < a.size(); ++k) EXPECT_EQ(a[k], b[k]);
  EXPECT_EQ(restarted.run_ticks(), 201);
}

TEST(Simulation, HoldingRestartRestartsOnce) {
  Simulation simulation(first_swing_level());
  for (int k = 0; k < 10; ++k) simulation.tick(press(button_restart));
  EXPECT_EQ(simulation.run_ticks(), 10);
}

TEST(Simulation, AFallReturnsThePlayerToTheStart) {
  Simulation simulation(first_swing_level());
  for (int k = 0; k < 240 && simulation.falls() == 0; ++k) simulation.tick(press(button_right));
  EXPECT_EQ(simulation.falls(), 1);
  EXPECT_NEAR(simulation.player().position().x, first_swing_level().player_start.x, 0.2);
}

Level first_swing_without_falls() {
  Level level = first_swing_level();
  level.assists.no_fall = true;
  return level;
}

TEST(NoFall, AFallReturnsThePlayerToItsLastFooting) {
  const Level level = first_swing_without_falls();
  Simulation simulation(level);
  double edge = 0.0;
  double back_at = 0.0;
  for (int k = 0; k < 240 && back_at == 0.0; ++k) {
    const ribbon::Vec2 before = simulation.player().position();
    if (simulation.player().is_on_ground()) edge = before.x;
    simulation.tick(press(button_right));
    if (simulation.player().position().y > before.y + 2.0) back_at = simulation.player().position().x;
  }
  EXPECT_LT(back_at, edge);
  EXPECT_GT(back_at, edge - 3.5);
  EXPECT_GT(back_at, level.player_start.x + 1.0) << "not at the start";
  EXPECT_EQ(simulation.falls(), 0);
  for (int k = 0; k < 60; ++k) simulation.tick({});
  EXPECT_NEAR(simulation.player().position().x, back_at, 0.05) << "it stands there";
  EXPECT_TRUE(simulation.player().is_on_firm_ground());
}

TEST(NoFall, ARestartResetsTheLastFooting) {
  const Level level = first_swing_without_falls();
  Simulation simulation(level);
  for (int k = 0; k < 60; ++k) simulation.tick(press(button_right));
  simulation.tick(press(button_restart));
  simulation.player().put({-30.0, 0.0}, simulation.scene().coupling());
  for (int k = 0; k < 120; ++k) simulation.tick({});
  EXPECT_NEAR(simulation.player().position().x, level.player_start.x, 0.1);
}

TEST(NoFall, IsTakenFromTheHeaderOfAReplay) {
  const Level level = first_swing_without_falls();
  const engine::ReplayHeader header = replay_header(level);
  Level other = first_swing_level();
  EXPECT_THROW(engine::check_header(header, replay_header(other)), engine::ReplayError);
  take_settings(other, header);
  EXPECT_TRUE(other.assists.no_fall);
  EXPECT_NO_THROW(engine::check_header(header, replay_header(other)));
  engine::ReplayHeader strange = header;
  strange.settings["no_fall"] = 0.5;
  take_settings(other, strange);
  EXPECT_FALSE(other.assists.no_fall);
  EXPECT_THROW(engine::check_header(strange, replay_header(other)), engine::ReplayError);
}

TEST_P(EitherLevel, ThePointerDragsACordPointAndReleasesIt) {
  Simulation simulation(level());
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const auto end = static_cast<int>(coupling.cord(0).positions().size()) - 1;
  engine::TickInput input = press(button_drag);
  engine::set_pointer(input, coupling.cord(0).positions()[static_cast<std::size_t>(end)]);
  simulation.tick(input);
  engine::set_pointer(input, {13.0, 12.0});
  for (int k = 0; k < 30; ++k) simulation.tick(input);
  int operated = -1;
  for (int p = 0; p <= end; ++p) {
    if (coupling.cord(0).kind(p) == ribbon::PointKind::operated) operated = p;
  }
  ASSERT_GE(operated, end - 1);
  EXPECT_EQ(coupling.cord(0).positions()[static_cast<std::size_t>(operated)], (ribbon::Vec2{13.0, 12.0}));
  simulation.tick({});
  EXPECT_EQ(coupling.cord(0).kind(operated), ribbon::PointKind::free);
}

TEST(Simulation, ThePointerDragsACordNoFurtherThanItsLength) {
  Simulation simulation(first_swing_level());
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const auto fastest = [&] {
    double most = 0.0;
    for (const ribbon::Vec2 v : coupling.cord(0).direct().velocities()) most = std::max(most, length(v));
    return most;
  };
  const ribbon::Vec2 pin = coupling.cord(0).positions().front();
  const double cord_length = coupling.cord(0).direct().def().length;
  engine::TickInput input = press(button_drag);
  engine::set_pointer(input, coupling.cord(0).positions().back());
  simulation.tick(input);
  engine::set_pointer(input, {40.0, 8.0});
  for (int k = 0; k < 60; ++k) {
    simulation.tick(input);
    EXPECT_LT(length(coupling.cord(0).positions().back() - pin), cord_length * 1.001) << "tick " << k;
    EXPECT_LT(fastest(), 40.0) << "tick " << k;  // m/s
  }
  EXPECT_EQ(coupling.cord(0).island_total().unconverged, 0);
  simulation.tick({});
  EXPECT_LT(fastest(), 5.0);
}

// --- the player
// --------------------------------------------------------------------------------------------------------

TEST(Player, RunsUpToTheMaximumSpeedAndStops) {
  Simulation simulation(first_swing_level());
  for (int k = 0; k < 40; ++k) simulation.tick(press(button_right));
  EXPECT_NEAR(static_cast<double>(simulation.player().body().GetLinearVelocity().x), 6.0, 1e-3);
  for (int k = 0; k < 20; ++k) simulation.tick({});
  EXPECT_NEAR(static_cast<double>(simulation.player().body().GetLinearVelocity().x), 0.0, 1e-3);
}

TEST(Player, JumpsOnceAPressAndOnlyFromTheGround) {
  Simulation simulation(first_swing_level());
  for (int k = 0; k < 10; ++k) simulation.tick({});
  const double ground = simulation.player().position().y;
  double highest = ground;
  int on_ground = 0;
  for (int k = 0; k < 200; ++k) {  // the button stays pressed
    simulation.tick(press(button_jump));
    highest = std::max(highest, simulation.player().position().y);
    if (k > 100) on_ground += simulation.player().is_on_ground() ? 1 : 0;
  }
  EXPECT_NEAR(highest - ground, 6.5 * 6.5 / (2.0 * 9.81), 0.1);
  EXPECT_EQ(on_ground, 99);
}

/// Returns how high a jump is whose key is down for a number of ticks, m.
double height_of_jump(int ticks_down) {
  Simulation simulation(first_swing_level());
  for (int k = 0; k < 10; ++k) simulation.tick({});
  const double ground = simulation.player().position().y;
  double highest = ground;
  for (int k = 0; k < 60; ++k) {
    simulation.tick(press(k < ticks_down ? button_jump : 0));
    highest = std::max(highest, simulation.player().position().y);
  }
  return highest - ground;
}

TEST(Player, JumpsAsHighAsTheKeyIsHeld) {
  EXPECT_NEAR(height_of_jump(2), 0.5, 0.1);
  EXPECT_GT(height_of_jump(10), height_of_jump(2) + 0.5);
  EXPECT_GT(height_of_jump(40), height_of_jump(10) + 0.3);
  EXPECT_NEAR(height_of_jump(40), height_of_jump(60), 1e-6);
}

TEST_P(EitherLevel, ThePlayerCatchesHangsPumpsAndReleasesWithItsVelocity) {
  Simulation simulation(level());
  test_support::Autopilot autopilot;
  const auto held = [&] { return simulation.scene().coupling().body(simulation.player().body()).held_place(); };
  while (!held() && simulation.ticks() < 300) simulation.tick(press(autopilot.buttons(simulation)));
  ASSERT_TRUE(held());
  for (int k = 0; k < 30; ++k) simulation.tick(press(button_grab | button_right));
  ASSERT_TRUE(held());
  const ribbon::Vec2 point =
      simulation.current().cords[static_cast<std::size_t>(held()->cord)][static_cast<std::size_t>(held()->point)];
  EXPECT_LT(length(point - simulation.player().hand()), 0.1);  // the point is at the hand
  const ribbon::Vec2 before = simulation.scene().coupling().body(simulation.player().body()).velocity();
  simulation.tick(press(button_right));  // grab is released
  EXPECT_FALSE(held());
  const ribbon::Vec2 after = simulation.scene().coupling().body(simulation.player().body()).velocity();
  EXPECT_NEAR(length(after - before - ribbon::Vec2{0.0, -9.81 / 60.0}), 0.0, 1e-4);
}

/// Pumping in phase with the swing adds height; in antiphase it removes height.
TEST_P(EitherLevel, PumpingAtTheRightTimeRaisesTheSwing) {
  const auto height_after = [](int sign) {
    Simulation simulation(level());
    test_support::Autopilot autopilot;
    const auto held = [&] { return simulation.scene().coupling().body(simulation.player().body()).held_place(); };
    while (!held() && simulation.ticks() < 300) simulation.tick(press(autopilot.buttons(simulation)));
    double highest = 0.0;
    for (int k = 0; k < 600; ++k) {
      const float speed = simulation.player().body().GetLinearVelocity().x;
      const bool right = static_cast<double>(speed) * sign > 0.0;
      const int pump = sign == 0 ? 0 : (right ? button_right : button_left);
      simulation.tick(press(button_grab | pump));
      if (k > 300) highest = std::max(highest, simulation.player().position().y);
    }
    return highest;
  };
  const double idle = height_after(0);
  EXPECT_GT(height_after(1), idle + 0.5);
  EXPECT_LT(height_after(-1), idle);
}

/// A swing wants rhythm: each press pushes for half a second, and a key that is held pushes no more.
TEST_P(EitherLevel, AKeyThatIsHeldDoesNotPump) {
  const auto place_after = [](int last_buttons) {
    Simulation simulation(level());
    test_support::Autopilot autopilot;
    const auto held = [&] { return simulation.scene().coupling().body(simulation.player().body()).held_place(); };
    while (!held() && simulation.ticks() < 300) simulation.tick(press(autopilot.buttons(simulation)));
    const int push = simulation.player().tuning().pump_ticks + 2;
    for (int k = 0; k < push; ++k) simulation.tick(press(button_grab | button_left));
    for (int k = 0; k < 90; ++k) simulation.tick(press(button_grab | last_buttons));
    return simulation.player().position();
  };
  EXPECT_EQ(place_after(button_left), place_after(0));
  EXPECT_GT(length(place_after(button_right) - place_after(0)), 0.1);  // a press
}

}  // namespace
}  // namespace game
