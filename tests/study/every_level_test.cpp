#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/replay/replay.h"
#include "tests/study/level_study.h"
#include "tests/study/level_study_fixture.h"

// Studies of levels with ribbons, thrown lines, ties, and cords that come and go.

namespace study {
namespace {

/// The first ticks of the recorded run of a level; those of the game are the ones with cords of every kind.
std::vector<engine::TickInput> recorded(const std::string& level, std::size_t ticks) {
  std::vector<engine::TickInput> inputs = inputs_of(engine::load_replay(TEST_ASSETS "/replays/" + level + ".replay"));
  inputs.resize(std::min(inputs.size(), ticks));
  return inputs;
}

StudyOptions two_settings() {
  StudyOptions options;
  options.quick = true;
  options.repeats = 1;
  options.grid = {present(), {"direct", "implicit_euler", 1, 5e-4}, {"direct", "tr_bdf2", 4, 1e-4}};
  options.ample_budgets = false;
  return options;
}

TEST_F(LevelStudy, AThrownLineHasTheSetting) {
  const LevelFile file(TEST_ASSETS "/levels/slingshot.tmj");
  const std::vector<engine::TickInput> inputs = recorded("slingshot", 400);
  const game::Level level = file.with(Setting{"direct", "implicit_euler", 2, 1e-3});
  LevelRun run(level, inputs);
  run.reset();
  for (std::size_t k = 0; k < inputs.size(); ++k) run.tick();
  const ribbon::box2d::Coupling& coupling = run.simulation().scene().coupling();
  ASSERT_GT(coupling.size(), 0);
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    EXPECT_EQ(coupling.cord(c).direct().def().accuracy, accuracy_of({"direct", "implicit_euler", 2, 1e-3}));
  }
  const Study study = measure(file, inputs, two_settings());
  ASSERT_EQ(study.settings.size(), 3U);
  EXPECT_GT(study.settings[1].point().error_m, study.settings[2].point().error_m);
  EXPECT_GT(study.settings[1].error.position_m, 0.0);
  EXPECT_GT(study.settings[2].tick_work.most, study.settings[1].tick_work.mean);
  EXPECT_DOUBLE_EQ(study.settings[0].tick_work.mean * static_cast<double>(inputs.size()),
                   static_cast<double>(study.settings[0].work.work));
}

TEST_F(LevelStudy, CordsThatAreCutOrBurntAreCompared) {
  for (const std::string level : {"before_it_burns", "cut_the_bridge"}) {
    const LevelFile file(TEST_ASSETS "/levels/" + level + ".tmj");
    const std::vector<engine::TickInput> inputs = recorded(level, 1000);
    const Trace own = run(file.level(), inputs);
    EXPECT_TRUE(std::any_of(own.cords.begin(), own.cords.end(), [&](const auto& cords) {
      return cords != own.cords.front();
    })) << level;  // or the test does not test it
    const Study study = measure(file, inputs, two_settings());
    ASSERT_EQ(study.settings.size(), 3U) << level;
    for (const Measured& m : study.settings) EXPECT_TRUE(std::isfinite(m.point().error_m)) << level;
  }
}

TEST_F(LevelStudy, ASettingThatTheLevelCannotHaveIsLeftOutWithItsReason) {
  const Setting thesis{"thesis", "", 8, 0.0};
  const auto reason = [](const char* level, const Setting& setting) {
    return LevelFile(TEST_ASSETS "/levels/" + std::string(level)).left_out_reason(setting);
  };
  EXPECT_EQ(reason("first_swing.tmj", thesis), "");
  EXPECT_NE(reason("open_the_gate.tmj", thesis).find("cord 1 is"), std::string::npos);
  EXPECT_EQ(reason("long_line.tmj", {"direct", "tr_bdf2", 1, 5e-4, 2.0}), "no cord of the map can have it");
  EXPECT_EQ(reason("long_line.tmj", {}), "");
  EXPECT_EQ(reason("trampoline.tmj", {"direct", "tr_bdf2", 1, 5e-4, 1.0, 0, 3}), "");
  EXPECT_EQ(reason("trampoline.tmj", {"direct", "tr_bdf2", 1, 5e-4, 1.0, 0, 2}), "no cord of the map can have it");
  StudyOptions options = two_settings();
  options.grid.push_back(thesis);
  const Study study =
      measure(LevelFile(TEST_ASSETS "/levels/open_the_gate.tmj"), recorded("open_the_gate", 5), options);
  EXPECT_EQ(study.settings.size(), 3U);
  ASSERT_EQ(study.left_out.size(), 1U);
  EXPECT_EQ(study.left_out[0].find("thesis substeps=8: "), 0U);
}

/// A ribbon with other rows has the width and the mass of the level's.
TEST_F(LevelStudy, RowsAndColumnsOfARibbonAreChanged) {
  const LevelFile file(TEST_ASSETS "/levels/trampoline.tmj");
  const auto own = file.level().make_scene();
  const auto changed = file.with(Setting{"direct", "tr_bdf2", 1, 5e-4, 2.0, 0, 3}).make_scene();
  for (const ribbon::box2d::CordId c : own->coupling().cords()) {
    const ribbon::CordDef& was = own->coupling().cord(c).direct().def();
    const ribbon::CordDef& is = changed->coupling().cord(c).direct().def();
    ASSERT_EQ(was.rows, 2);
    EXPECT_EQ(is.rows, 3);
    EXPECT_EQ(is.points - 1, 2 * (was.points - 1));
    EXPECT_EQ(is.width, was.width);
    EXPECT_NEAR(is.mass_per_length * is.length, was.mass_per_length * was.length, 1e-12);
  }
}

}  // namespace
}  // namespace study
