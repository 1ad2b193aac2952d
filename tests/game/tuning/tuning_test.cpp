#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/replay/replay.h"
#include "engine/window/sdl_canvas.h"
#include "game/simulation/buttons.h"
#include "game/tuning/parameters.h"
#include "game/tuning/tables.h"
#include "game/tuning/tuned_level.h"
#include "game/tuning/tuning_panel.h"
#include "tests/game/program.h"
#include "tests/game/simulation/press.h"
#include "tests/support/mixed_level.h"

namespace game {
namespace {

using test_support::bytes_of;
using test_support::scratch;
using test_support::write_bytes;

/// A level of this test, with cords of both solvers.
std::string own_level() {
  std::string path = scratch("tuned.tmj");
  write_bytes(path, test_support::mixed_swing_map());
  return path;
}

RunOptions play(const std::string& level, const std::string& record = "") {
  RunOptions options;
  options.level = level;
  options.record = record;
  return options;
}

TEST(Parameters, EachChangesWhatItShows) {
  const Level level = load_level(own_level());
  Simulation simulation(level);
  TunedLevel tuned(level);
  engine::Scene& scene = simulation.scene();
  int tried = 0;
  for (ribbon::box2d::CordId cord = 0; cord < scene.coupling().size(); ++cord) {
    for (const Parameter& parameter : parameters_of(scene.coupling(), cord)) {
      const double wanted = parameter.whole            ? 3.0
                            : parameter.on_value > 0.0 ? parameter.on_value
                                                       : 0.5 * (parameter.min + parameter.max);
      engine::Properties::Value value = wanted;
      if (parameter.whole) value = std::int64_t{3};
      const engine::Properties::Value before = parameter.value(scene.coupling(), cord);
      tuned.set(scene.cord_object(cord), parameter.property, value, scene);
      EXPECT_NEAR(parameter.value(scene.coupling(), cord), wanted, 1e-9 * wanted) << parameter.property;
      simulation.tick({});
      if (!parameter.is_term) continue;
      const auto off = off_value(parameter);
      if (off) {
        tuned.set(scene.cord_object(cord), parameter.property, *off, scene);
      } else {
        tuned.remove(scene.cord_object(cord), parameter.property, scene);
      }
      const double now = parameter.value(scene.coupling(), cord);
      EXPECT_TRUE(now == 0.0 || std::isinf(now)) << parameter.property;
      simulation.tick({});
      ++tried;
    }
    for (const Switch& option : switches_of(scene.coupling(), cord)) {
      const bool was = option.value(scene.coupling(), cord);
      tuned.set(scene.cord_object(cord), option.property, !was, scene);
      EXPECT_EQ(option.value(scene.coupling(), cord), !was) << option.property;
      simulation.tick({});
    }
  }
  EXPECT_GT(tried, 8);
}

TEST(TunedLevel, GravityChangesAtOnceAndWithTheLevel) {
  const Level level = load_level(own_level());
  Simulation simulation(level);
  TunedLevel tuned(level);
  EXPECT_FALSE(tuned.is_changed());
  tuned.set(engine::map_itself, "gravity_y", -3.5, simulation.scene());
  EXPECT_TRUE(tuned.is_changed());
  EXPECT_EQ(simulation.scene().world().GetGravity().y, -3.5F);
  EXPECT_EQ(tuned.level().make_scene()->world().GetGravity().y, -3.5F);
}

TEST(TunedLevel, AnInvalidSettingChangesNothing) {
  const Level level = load_level(own_level());
  Simulation simulation(level);
  TunedLevel tuned(level);
  const int object = simulation.scene().cord_object(0);
  EXPECT_THROW(tuned.set(object, "mass", -1.0, simulation.scene()), engine::MapError);
  EXPECT_THROW(tuned.set(object, "nonsense", 1.0, simulation.scene()), engine::MapError);
  EXPECT_THROW(tuned.set(engine::map_itself, "gravity_y", 1e9, simulation.scene()), engine::MapError);
  EXPECT_FALSE(tuned.is_changed());
  EXPECT_EQ(tuned.level().map.content_hash, level.map.content_hash);
}

TEST(TunedLevel, WritesOnlyTheTunedValuesAndOnlyOverTheFileItRead) {
  const std::string path = own_level();
  const std::string before = bytes_of(path);
  const Level level = load_level(path);
  Simulation simulation(level);
  TunedLevel tuned(level);
  const int object = simulation.scene().cord_object(0);
  tuned.set(object, "drag", 0.125, simulation.scene());
  EXPECT_EQ(bytes_of(path), before) << "until it is asked for";
  tuned.write();
  EXPECT_FALSE(tuned.is_changed());
  EXPECT_EQ(bytes_of(path), engine::with_property(before, object, "drag", 0.125));
  EXPECT_EQ(load_level(path).map.content_hash, tuned.level().map.content_hash);

  write_bytes(path, before + "\n");
  tuned.set(object, "drag", 0.25, simulation.scene());
  EXPECT_THROW(tuned.write(), engine::MapError);
  EXPECT_EQ(bytes_of(path), before + "\n") << "another program has changed it";
  EXPECT_THROW(TunedLevel{level}, engine::MapError);
}

TEST(RecordedRun, ATunedRunIsMarkedAndItsRecordingEndsBeforeTheChange) {
  const std::string level = own_level();
  const std::string path = scratch("tuned.replay");
  RecordedRun run(play(level, path));
  run.start_recording();
  for (int k = 0; k < 20; ++k) run.tick({});
  EXPECT_FALSE(run.is_tuned());
  run.tune().scene().world().SetGravity({0.0F, -2.0F});
  EXPECT_TRUE(run.is_tuned());
  for (int k = 0; k < 20; ++k) run.tick({});
  run.finish();
  const engine::Replay left = engine::load_replay(path);
  EXPECT_TRUE(left.complete);
  EXPECT_EQ(left.ticks.size(), 20U);
  EXPECT_EQ(test_support::ropeswing("--headless --verify --level " + level + " --replay " + path).status, 0);
}

/// A fall takes cords back to the start of the level, but not what was tuned.
TEST(RecordedRun, AFallKeepsWhatWasTuned) {
  RecordedRun run(play(assets_folder() + "/levels/first_swing.tmj"));
  TunedLevel tuned(run.level());
  engine::Scene& scene = run.tune().scene();
  tuned.set(scene.cord_object(0), "mass", 9.0, scene);
  const std::vector<double> masses = scene.coupling().cord(0).direct().save().masses;
  while (run.simulation().falls() == 0 && run.simulation().ticks() < 1200) run.tick(press(button_right));
  ASSERT_EQ(run.simulation().falls(), 1);
  EXPECT_EQ(scene.coupling().cord(0).direct().save().masses, masses);
}

TEST(RecordedRun, ANewLevelStartsWithTheNextRun) {
  const std::string path = own_level();
  RecordedRun run(play(path));
  Simulation plain(run.level());
  run.tick({});
  const Level level = load_level(path);
  TunedLevel tuned(level);
  tuned.set(engine::map_itself, "gravity_y", -1.0, run.tune().scene());
  run.set_level(tuned.level(), true);
  run.begin("");
  EXPECT_TRUE(run.is_tuned());
  EXPECT_EQ(run.simulation().scene().world().GetGravity().y, -1.0F);
  run.set_level(level, false);
  run.begin("");
  EXPECT_FALSE(run.is_tuned());
  run.tick({});
  plain.tick({});
  EXPECT_EQ(run.simulation().hash(), plain.hash());
}

/// The panel over a run, without a window.
struct Panelled {
  std::string path = own_level();
  RecordedRun run;
  TuningPanel panel;
  Meter meter;
  FrameTimes times;
  engine::HeadlessCanvas canvas{1280, 720};

  explicit Panelled(const RunOptions& options) : run(options) {}
  void frame(const engine::WindowInput& input = {}) {
    panel.update(input, canvas, 1.0, 1.0 / 60.0, run, meter, times);
    if (!run.is_over()) run.tick({});
    meter.add(run.simulation(), 1'000'000);
  }
};

TEST(TuningPanel, ChangesNothingWithoutInput) {
  Panelled shown(play(own_level()));
  Panelled hidden(play(own_level()));
  shown.panel.toggle();
  for (int k = 0; k < 60; ++k) {
    shown.frame();
    hidden.frame();
    ASSERT_EQ(shown.run.simulation().hash(), hidden.run.simulation().hash());
  }
  EXPECT_FALSE(shown.run.is_tuned());
  hidden.panel.draw(hidden.canvas);
  EXPECT_EQ(hidden.canvas.raster().pixels(), engine::HeadlessCanvas(1280, 720).raster().pixels());
  shown.panel.draw(shown.canvas);
  EXPECT_NE(shown.canvas.raster().pixels(), hidden.canvas.raster().pixels());
}

/// Presses, drags and releases in three hundred places of the panel, so that every element is operated.
TEST(TuningPanel, TheRunContinuesAfterAnyClick) {
  Panelled panelled(play(own_level()));
  panelled.panel.toggle();
  panelled.frame();
  std::mt19937 random(3);
  const auto place = [&random] {
    return ribbon::Vec2{840.0 + static_cast<double>(random() % 420), 64.0 + static_cast<double>(random() % 630)};
  };
  int tuned = 0;
  for (int click = 0; click < 300; ++click) {
    engine::WindowInput input;
    input.mouse = place();
    panelled.frame(input);
    input.buttons_held.set(0);
    input.buttons_pressed.set(0);
    panelled.frame(input);
    input.buttons_pressed.reset();
    input.mouse.x += static_cast<double>(random() % 60);
    panelled.frame(input);
    panelled.frame();
    tuned += panelled.run.is_tuned();
    if (panelled.panel.takes_restart()) panelled.run.begin("");
    if (!panelled.panel.is_shown()) panelled.panel.toggle();
  }
  EXPECT_GT(tuned, 0);
  EXPECT_NO_THROW(load_level(panelled.path)) << "if it was written to, with what can be loaded";
}

/// Presses a place of the panel and releases it.
void click(Panelled& panelled, ribbon::Vec2 at) {
  engine::WindowInput input;
  input.mouse = at;
  panelled.frame(input);
  input.buttons_held.set(0);
  input.buttons_pressed.set(0);
  panelled.frame(input);
  input.buttons_held.reset();
  input.buttons_pressed.reset();
  panelled.frame(input);
}

/// Clicks on all of the panel's upper part. Returns the presets that were asked for.
std::set<std::string> presets_asked_for(Panelled& panelled) {
  std::set<std::string> names;
  for (int y = 70; y < 400; y += 8) {
    for (int x = 850; x < 1250; x += 30) {
      click(panelled, {1.0 * x, 1.0 * y});
      if (const Preset* const preset = panelled.panel.takes_comparison()) names.insert(preset->name);
      EXPECT_EQ(panelled.panel.takes_comparison(), nullptr) << "once";
      if (!panelled.panel.is_shown()) panelled.panel.toggle();
    }
  }
  return names;
}

TEST(TuningPanel, AsksForTheLastSecondsOfARunThatCanBeRepeated) {
  RunOptions options;
  options.replay = test_support::golden();
  Panelled panelled(options);
  panelled.panel.toggle();
  EXPECT_EQ(presets_asked_for(panelled), (std::set<std::string>{"fast", "balanced", "accurate"}));

  Panelled tuned(play(own_level()));
  tuned.run.tune();
  tuned.panel.toggle();
  EXPECT_EQ(presets_asked_for(tuned), std::set<std::string>{});
}

TEST(TuningPanel, CannotTuneAReplay) {
  RunOptions options;
  options.replay = test_support::golden();
  Panelled panelled(options);
  panelled.panel.toggle();
  for (int y = 70; y < 700; y += 9) {
    engine::WindowInput input;
    input.mouse = {900.0, 1.0 * y};
    panelled.frame(input);
    input.buttons_held.set(0);
    panelled.frame(input);
    panelled.frame();
    if (!panelled.panel.is_shown()) panelled.panel.toggle();
  }
  EXPECT_FALSE(panelled.run.is_tuned());
  RecordedRun plain(options);
  while (plain.simulation().ticks() < panelled.run.simulation().ticks()) plain.tick({});
  EXPECT_EQ(panelled.run.simulation().hash(), plain.simulation().hash());
}

TEST(Tables, InvertedCellsAreCounted) {
  const Level level = load_level(own_level());
  Simulation simulation(level);
  ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  for (int c = 0; c < coupling.size(); ++c) {
    EXPECT_EQ(inverted_cells(coupling, c), 0);
    if (coupling.cord(c).solver() != ribbon::box2d::Solver::thesis) continue;
    ribbon::ThesisCord::State state = coupling.cord(c).thesis().save();
    for (std::size_t p = 0; p + 1 < state.positions.size(); p += 2)
      std::swap(state.positions[p], state.positions[p + 1]);
    coupling.cord(c).thesis().restore(state);
    const ribbon::box2d::CordShape shape = coupling.cord(c).shape();
    if (shape.rows == 2) {
      EXPECT_EQ(inverted_cells(coupling, c), shape.columns - 1);
    }
  }
}

}  // namespace
}  // namespace game
