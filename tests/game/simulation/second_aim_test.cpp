// The second player aims its line with the stick of its gamepad.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "game/simulation/buttons.h"
#include "game/simulation/recorded_run.h"
#include "tests/game/program.h"
#include "tests/game/simulation/small_level.h"

namespace game {
namespace {

/// Two players below a ceiling; the second one at x = 10 m.
engine::TiledMap map_for_two() {
  MapObject second = point_of(5, "player_2", {10.0, 2.0});
  return small_map({sticky(ground({0.0, 8.0}, {40.0, 9.0})), second});
}

engine::TickInput aimed(int second, Vec2 at) {
  engine::TickInput input = press(0, second);
  engine::set_second_pointer(input, at);
  return input;
}

TEST(SecondAim, TheLineFliesToWhereItAims) {
  const Level level = level_of(map_for_two());
  for (const double x : {7.0, 13.0}) {
    Simulation simulation(level);
    simulation.tick(aimed(0, {x, 8.0}));
    ASSERT_TRUE(simulation.target(1));
    EXPECT_NEAR(simulation.target(1)->place().x, x, 0.1);
    simulation.tick(aimed(button_throw, {x, 8.0}));
    for (int k = 0; k < 20; ++k) simulation.tick(aimed(0, {10.0, 0.0}));
    ASSERT_TRUE(simulation.player(1).line().is_held());
    EXPECT_NEAR(simulation.player(1).line().end().x, x, 0.1);
    EXPECT_FALSE(simulation.player(0).line().is_held());
  }
}

TEST(SecondAim, WithoutAPointerItIsAhead) {
  const Level level = level_of(map_for_two());
  Simulation simulation(level);
  simulation.tick(press(0, 0));
  ASSERT_TRUE(simulation.target(1));
  EXPECT_GT(simulation.target(1)->place().x, simulation.player(1).hand().x + 1.0);
}

/// A level of 40 × 20 m with a ceiling at which lines stick, as a file.
std::string level_file() {
  std::string path = test_support::scratch("for_two.tmj");
  std::ofstream(path) << R"({"type": "map", "version": "1.10", "orientation": "orthogonal", "infinite": false,
    "width": 40, "height": 20, "tilewidth": 32, "tileheight": 32,
    "properties": [{"name": "pixels_per_metre", "type": "int", "value": 32}],
    "layers": [{"type": "objectgroup", "name": "objects", "visible": true, "objects": [
      {"id": 1, "name": "one", "type": "player", "point": true, "x": 96, "y": 576},
      {"id": 2, "name": "two", "type": "player_2", "point": true, "x": 320, "y": 576},
      {"id": 3, "name": "flag", "type": "goal", "x": 1200, "y": 512, "width": 32, "height": 64},
      {"id": 4, "name": "floor", "type": "ground", "x": 0, "y": 576, "width": 1280, "height": 64},
      {"id": 5, "name": "roof", "type": "ground", "x": 0, "y": 352, "width": 1280, "height": 32,
       "properties": [{"name": "sticky", "type": "bool", "value": true}]}]}]})";
  return path;
}

/// In tick 30 the second player throws its line at what it aims at, which moves, and then reels it in.
engine::TickInput thrown_at(int tick, double x) {
  const int buttons = tick == 30 ? button_throw : tick > 60 ? button_reel_in : 0;
  return aimed(buttons, {x + 0.5 * std::sin(0.1 * tick), 8.0});
}

TEST(SecondAim, IsRecordedAndVerified) {
  constexpr int ticks = 120;
  const std::string path = test_support::scratch("second_aim.replay");
  RunOptions options;
  options.level = level_file();
  options.record = path;
  {
    RecordedRun run(options);
    run.start_recording();
    for (int k = 0; k < ticks; ++k) run.tick(thrown_at(k, 7.0));
    run.finish();
    EXPECT_TRUE(run.simulation().player(1).line().is_held());
  }
  options.record.clear();
  options.replay = path;
  options.verify = true;
  RecordedRun again(options);
  while (!again.is_over()) again.tick({});
  EXPECT_EQ(again.exit_status(), 0) << again.closing_line();
  engine::Replay replay = engine::load_replay(path);
  ASSERT_EQ(replay.ticks.size(), static_cast<std::size_t>(ticks));
  for (int k = 0; k < ticks; ++k) EXPECT_EQ(replay.ticks[static_cast<std::size_t>(k)].input, thrown_at(k, 7.0)) << k;

  for (engine::RecordedTick& tick : replay.ticks) tick.input.second_has_pointer = false;
  const Level level = load_level(*options.level);
  Simulation simulation(level);
  engine::ReplayVerifier verifier(replay);
  while (!verifier.done()) {
    simulation.tick(verifier.input());
    verifier.check(simulation.hash());
  }
  EXPECT_EQ(verifier.result().outcome, engine::VerifyOutcome::diverged) << "without the pointer the line flies ahead";
}

}  // namespace
}  // namespace game
