// The last seconds of a run, beside the same with another preset.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "game/simulation/recorded_run.h"
#include "game/simulation/run_header.h"
#include "game/tuning/last_seconds.h"
#include "tests/game/program.h"
#include "tests/game/simulation/press.h"

namespace game {
namespace {

using ribbon::Accuracy;

std::vector<engine::TickInput> recorded(const char* level) {
  std::vector<engine::TickInput> inputs;
  const std::string path = assets_folder() + "/replays/" + level + ".replay";
  for (const engine::RecordedTick& tick : engine::load_replay(path).ticks) inputs.push_back(tick.input);
  return inputs;
}

/// Runs the last seconds to their end.
void finish(LastSeconds& runs) {
  while (!runs.approach(1)) {
  }
  while (!runs.is_over()) runs.tick();
}

/// All cords of this level, and the line, have the same accuracy.
TEST(LastSeconds, AreThoseOfTheRunIfTheAccuracyIsItsOwn) {
  const Level level = load_level("first_swing");
  const std::vector<engine::TickInput> inputs = recorded("first_swing");
  ASSERT_GT(inputs.size(), static_cast<std::size_t>(LastSeconds::max_ticks));
  Simulation run(level);
  for (const engine::TickInput& input : inputs) run.tick(input);

  LastSeconds runs(level, inputs, Accuracy::balanced());
  EXPECT_EQ(runs.progress(), 0.0);
  finish(runs);
  EXPECT_EQ(runs.progress(), 1.0);
  EXPECT_EQ(runs.played().hash(), run.hash());
  EXPECT_EQ(runs.other().hash(), run.hash());
  ASSERT_TRUE(runs.largest_gap());
  EXPECT_EQ(runs.largest_gap()->size(), 0.0);
}

TEST(LastSeconds, ShowWhereAnotherPresetDiffersMost) {
  LastSeconds runs(load_level("first_swing"), recorded("first_swing"), Accuracy::fast());
  double largest = 0.0;
  while (!runs.approach(100)) EXPECT_FALSE(runs.gap());
  for (int tick = 1; !runs.is_over(); ++tick) {
    runs.tick();
    ASSERT_TRUE(runs.gap());
    EXPECT_EQ(runs.gap()->tick, tick);
    largest = std::max(largest, runs.gap()->size());
    const double of_player = length(runs.other().player().position() - runs.played().player().position());
    EXPECT_GE(runs.gap()->size(), of_player);
  }
  EXPECT_GT(largest, 0.01) << "implicit Euler damps a swing";
  EXPECT_EQ(runs.largest_gap()->size(), largest);
}

/// A restart makes new cords, as a throw makes a new line.
TEST(LastSeconds, GiveTheAccuracyToCordsThatComeLater) {
  std::vector<engine::TickInput> inputs(800);
  inputs[500].buttons |= button_restart;
  LastSeconds runs(load_level("first_swing"), inputs, Accuracy::fast());
  finish(runs);
  EXPECT_EQ(runs.played().run_ticks(), 300);
  const ribbon::box2d::Coupling& cords = runs.other().scene().coupling();
  for (const ribbon::box2d::CordId id : cords.cords())
    EXPECT_EQ(cords.cord(id).direct().def().accuracy, Accuracy::fast()) << id;
  const ribbon::box2d::Coupling& played = runs.played().scene().coupling();
  for (const ribbon::box2d::CordId id : played.cords())
    EXPECT_EQ(played.cord(id).direct().def().accuracy, Accuracy::balanced()) << id;
}

TEST(LastSeconds, OfAShortRunAreAllOfIt) {
  LastSeconds runs(load_level("first_swing"), std::vector<engine::TickInput>(30), Accuracy::fast());
  EXPECT_EQ(runs.progress(), 1.0);
  ASSERT_TRUE(runs.approach(0));
  finish(runs);
  EXPECT_EQ(runs.played().ticks(), 30);
  EXPECT_EQ(runs.gap()->tick, 30);

  LastSeconds none(load_level("first_swing"), {}, Accuracy::fast());
  EXPECT_TRUE(none.approach(0));
  EXPECT_TRUE(none.is_over());
  EXPECT_FALSE(none.gap());
}

/// Cords that are cut, burnt, thrown and tied, ribbons, wheels, wind, water, two players.
TEST(LastSeconds, OfEveryRecordedRunAreThoseOfTheRunAndRepeatThemselves) {
  for (const std::string& name : level_names()) {
    const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/" + name + ".replay");
    Level level = load_level(name);
    take_settings(level, replay.header);
    const std::vector<engine::TickInput> inputs = recorded(name.c_str());
    Simulation run(level);
    for (const engine::TickInput& input : inputs) run.tick(input);

    LastSeconds runs(level, inputs, Accuracy::fast());
    finish(runs);
    EXPECT_EQ(runs.played().hash(), run.hash()) << name;
    ASSERT_TRUE(runs.gap()) << name;
    const ribbon::box2d::StateHash other = runs.other().hash();
    runs.rewind();
    EXPECT_FALSE(runs.gap()) << name;
    finish(runs);
    EXPECT_EQ(runs.other().hash(), other) << name;
  }
}

TEST(RecordedRunInputs, AreThoseSinceTheStartOrOfTheReplay) {
  RunOptions options;
  options.level = "first_swing";
  RecordedRun run(options);
  run.tick(press(button_right));
  run.tick(press(button_jump));
  ASSERT_EQ(run.inputs().size(), 2U);
  EXPECT_EQ(run.inputs()[1].buttons, button_jump);
  EXPECT_TRUE(run.can_be_repeated());
  run.begin("");
  EXPECT_TRUE(run.inputs().empty());
  run.tune();
  EXPECT_FALSE(run.can_be_repeated());
  run.begin("");
  EXPECT_TRUE(run.can_be_repeated());
  run.set_level(run.level(), false);
  EXPECT_FALSE(run.can_be_repeated());

  RunOptions replayed;
  replayed.replay = assets_folder() + "/replays/first_swing.replay";
  RecordedRun replay(replayed);
  replay.seek(40);
  replay.tick({});
  ASSERT_EQ(replay.inputs().size(), 41U);
  EXPECT_EQ(replay.inputs()[40], recorded("first_swing")[40]);
}

}  // namespace
}  // namespace game
