#include "tests/study/players.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/study/level_study.h"
#include "tests/study/level_study_fixture.h"
#include "tests/study/results.h"

namespace study {
namespace {

std::vector<std::uint16_t> buttons_of(const Inputs& inputs) {
  std::vector<std::uint16_t> buttons;
  for (const engine::TickInput& input : inputs) buttons.push_back(input.buttons);
  return buttons;
}

Inputs start_of(const std::string& level, std::size_t ticks) {
  Inputs inputs = inputs_of(engine::load_replay(TEST_ASSETS "/replays/" + level + ".replay"));
  inputs.resize(std::min(inputs.size(), ticks));
  return inputs;
}

/// In curtains a player that runs to the right touches them; in this level many random ones do.
TEST(Players, AreThoseThatMeetTheMostCords) {
  const game::Level level = LevelFile(TEST_ASSETS "/levels/curtains.tmj").level();
  const std::vector<Inputs> chosen = players_that_meet_cords(level, 0, 3);
  ASSERT_EQ(chosen.size(), 3U);
  std::set<int> met;
  std::size_t first = 0;
  for (const Inputs& inputs : chosen) {
    const Meetings meetings = meetings_of(level, inputs);
    const std::size_t before = met.size();
    met.insert(meetings.touched.begin(), meetings.touched.end());
    if (before == 0) first = met.size();
  }
  EXPECT_GT(first, 0U);
  for (unsigned seed = 0; seed < 5; ++seed) {  // players of the same kind
    EXPECT_LE(meetings_of(level, random_inputs(seed, 120)).touched.size(), met.size());
  }
}

TEST(Players, AreTheSameForTheSameSeedAndNoneThatTests) {
  const game::Level level = LevelFile(TEST_ASSETS "/levels/first_swing.tmj").level();
  const std::vector<Inputs> chosen = players_that_meet_cords(level, 1, 2);
  const std::vector<Inputs> again = players_that_meet_cords(level, 1, 2);
  const std::vector<Inputs> others = players_that_meet_cords(level, 2, 2);
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(buttons_of(chosen[0]), buttons_of(again[0]));
  EXPECT_EQ(buttons_of(chosen[1]), buttons_of(again[1]));
  EXPECT_NE(buttons_of(chosen[0]), buttons_of(chosen[1]));
  EXPECT_NE(buttons_of(chosen[0]), buttons_of(others[0]));
  for (unsigned seed = 0; seed < 1000; ++seed) {
    EXPECT_NE(buttons_of(chosen[0]), buttons_of(random_inputs(seed, 120))) << seed;
  }
}

TEST(Players, MeetWhatTheyHoldAndTouch) {
  const game::Level level = LevelFile(TEST_ASSETS "/levels/first_swing.tmj").level();
  const Meetings winner = meetings_of(level, start_of("first_swing", 10000));
  EXPECT_TRUE(winner.any_cord);
  EXPECT_GT(winner.held.size(), 1U);
  const Meetings idle = meetings_of(level, Inputs(10));
  EXPECT_TRUE(idle.any_cord);
  EXPECT_TRUE(idle.held.empty());
  EXPECT_TRUE(idle.touched.empty());
}

/// Without a ring no line can be thrown: there is nothing to judge by.
TEST(Players, WithoutACordThereAreNone) {
  game::Level level = LevelFile(TEST_ASSETS "/levels/slingshot.tmj").level();
  EXPECT_FALSE(players_that_meet_cords(level, 0, 2).empty());
  level.hooks.clear();
  EXPECT_TRUE(players_that_meet_cords(level, 0, 2).empty());
}

class WithOtherPlayers : public LevelStudy {
 protected:
  static StudyOptions quick() {
    StudyOptions options;
    options.quick = true;
    options.repeats = 1;
    options.windows = 3;
    options.grid = {{"direct", "implicit_euler", 1, 1e-2}, {"direct", "tr_bdf2", 4, 1e-4}};
    return options;
  }
};

/// The recorded player stands still; the other one swings.
TEST_F(WithOtherPlayers, TheErrorIsThatOfTheWorst) {
  const LevelFile file(TEST_ASSETS "/levels/first_swing.tmj");
  const Inputs still(60);
  const Inputs swings = start_of("first_swing", 200);
  StudyOptions options = quick();
  const std::vector<Point> alone = applicable(measure(file, still, options));
  const std::vector<Point> swinging = applicable(measure(file, swings, options));
  options.others = {Inputs(30), swings};
  const Study study = measure(file, still, options);
  EXPECT_EQ(study.others, 2U);
  const std::vector<Point> both = applicable(study);
  for (std::size_t k = 0; k < both.size(); ++k) {
    EXPECT_LT(alone[k].error_m, swinging[k].error_m) << k;
    EXPECT_EQ(both[k].error_m, swinging[k].error_m) << k;
    EXPECT_EQ(study.settings[k].others.error_m, swinging[k].error_m) << k;
    EXPECT_GT(study.settings[k].others.work.most, study.settings[k].tick_work.most) << k;
  }
}

TEST_F(WithOtherPlayers, TheirResultsAreSaved) {
  const auto save = [this](const WithOthers& others) {
    Measured measured;
    measured.others = others;
    Results(home + "/saved", 1, replay_path, false).add(measured);
    return Results(home + "/saved", 1, replay_path, false).find({})->others;
  };
  const WithOthers known = save({0.2, {51.0, 52.0, 53.0}, "blew up in tick 3"});
  EXPECT_EQ(known.error_m, 0.2);
  EXPECT_EQ(known.work.mean, 51.0);
  EXPECT_EQ(known.work.p99, 52.0);
  EXPECT_EQ(known.work.most, 53.0);
  EXPECT_EQ(known.failure, "blew up in tick 3");
  fs::remove_all(home + "/saved");
  EXPECT_TRUE(std::isnan(save({}).error_m));
}

/// A study that was interrupted continues without their runs, if all settings are known.
TEST_F(WithOtherPlayers, AKnownStudyNeedsNoRunOfThem) {
  StudyOptions options = quick();
  options.folder = home + "/report";
  options.others = {start_of("first_swing", 100)};
  const Study first = measure(LevelFile(level_path), replay_path, options);
  const Study again = measure(LevelFile(level_path), replay_path, options);
  for (std::size_t k = 0; k < first.settings.size(); ++k) {
    EXPECT_GT(first.settings[k].others.error_m, 0.0);
    EXPECT_EQ(again.settings[k].others.error_m, first.settings[k].others.error_m);
  }
}

/// The level has no cord until a line arrives.
TEST(Players, ARandomPlayerThrowsALineWhereNothingElseIsACord) {
  const game::Level level = game::load_level("long_line");
  int with_cords = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Inputs inputs = random_inputs_with_cords(level, seed, 120);
    EXPECT_EQ(inputs.size(), 120U);
    with_cords += meetings_of(level, inputs).any_cord ? 1 : 0;
  }
  EXPECT_EQ(with_cords, 3);
  const game::Level with_ropes = game::load_level("first_swing");
  EXPECT_EQ(random_inputs_with_cords(with_ropes, 5, 30).front().buttons, random_inputs(5, 30).front().buttons);
}

}  // namespace
}  // namespace study
