#include "tests/study/by_cord.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ribbon/box2d/coupling.h"
#include "tests/study/cord_search.h"
#include "tests/study/level_study.h"
#include "tests/study/level_study_fixture.h"

namespace study {
namespace {

const Setting fast{"direct", "implicit_euler", 1, 1e-2};
const Setting middle{"direct", "implicit_euler", 4, 5e-4};
const Setting exact{"direct", "tr_bdf2", 4, 1e-4};

/// Each cord has work and an error of its own: with `exact` 100 and 0, with the others as a test defines.
struct Cord {
  double work = 0.0;
  double error = 0.0;
};
using Cords = std::map<std::pair<int, std::string>, Cord>;

Outcome outcome_of(const Cords& cords, const CordSettings& settings, int count) {
  Outcome outcome;
  for (int id = 1; id <= count; ++id) {
    const auto own = settings.own.find(id);
    const auto cord = own == settings.own.end() ? cords.end() : cords.find({id, name_of(own->second)});
    outcome.work += cord == cords.end() ? 100.0 : cord->second.work;
    outcome.error_m += cord == cords.end() ? 0.0 : cord->second.error;
  }
  return outcome;
}

CordSearch search(int count) {
  CordSearch search;
  for (int id = 1; id <= count; ++id) search.cords.push_back(id);
  search.cheaper = {fast, middle};
  search.max_error_m = 8e-3;
  search.common = exact;
  search.of_common = {0.0, 100.0 * count, {}};
  return search;
}

/// The second cord cannot be fast; the third one saves most; with it and the first one there is no error left for it.
TEST(ByCord, GivesEachCordTheCheapestThatTheErrorAllows) {
  const Cords cords = {{{1, name_of(fast)}, {10.0, 1e-3}},
                       {{2, name_of(fast)}, {10.0, 9e-3}},
                       {{2, name_of(middle)}, {40.0, 4e-3}},
                       {{3, name_of(fast)}, {5.0, 6e-3}},
                       {{3, name_of(middle)}, {50.0, 1e-3}}};
  const CordSearchResult result =
      find_by_cord(search(3), [&](const CordSettings& settings) { return outcome_of(cords, settings, 3); });
  const std::optional<ByCord>& found = result.found;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->settings.common, exact);
  ASSERT_EQ(found->settings.own.size(), 2U);
  EXPECT_EQ(found->settings.own.at(1), fast);
  EXPECT_EQ(found->settings.own.at(3), fast);
  EXPECT_EQ(found->outcome.work, 115.0);
  EXPECT_EQ(found->outcome.error_m, 7e-3);
  EXPECT_EQ(found->common_work, 300.0);
  EXPECT_LE(found->tried, 12);                      // of the 27 products
  EXPECT_EQ(result.least_work, 10.0 + 40.0 + 5.0);  // what each of them could have alone
}

TEST(ByCord, TakesAllAtOnceIfTheErrorAllowsIt) {
  const Cords cords = {{{1, name_of(fast)}, {10.0, 3e-3}}, {{2, name_of(fast)}, {20.0, 5e-3}}};
  const CordSearchResult result =
      find_by_cord(search(2), [&](const CordSettings& settings) { return outcome_of(cords, settings, 2); });
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.found->outcome.work, 30.0);
  EXPECT_EQ(result.least_work, 30.0);
  EXPECT_EQ(result.found->tried, 5);  // each alone, both, and without each
}

/// Both cannot be fast, but the second one can have the next setting.
TEST(ByCord, ACordThatCannotHaveItsCheapestHasTheNextOne) {
  const Cords cords = {
      {{1, name_of(fast)}, {10.0, 5e-3}}, {{2, name_of(fast)}, {20.0, 4e-3}}, {{2, name_of(middle)}, {60.0, 1e-3}}};
  const CordSearchResult result =
      find_by_cord(search(2), [&](const CordSettings& settings) { return outcome_of(cords, settings, 2); });
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.found->settings.own.at(1), fast);
  EXPECT_EQ(result.found->settings.own.at(2), middle);
  EXPECT_EQ(result.found->outcome.work, 70.0);
}

/// Returns the outcome where the first two of four cords are one island.
Outcome outcome_of_island(const CordSettings& settings) {
  const auto has = [&](int cord) { return settings.own.count(cord) > 0; };
  Outcome outcome;
  outcome.work = (has(1) && has(2) ? 20.0 : 200.0) + (has(3) ? 10.0 : 100.0) + (has(4) ? 10.0 : 100.0);
  outcome.error_m = (has(1) && has(2) ? 5e-3 : 0.0) + (has(3) ? 4e-3 : 0.0) + (has(4) ? 7e-3 : 0.0);
  return outcome;
}

TEST(ByCord, CordsOfAnIslandSaveTogetherWhatNoneSavesAlone) {
  CordSearch four = search(4);
  const CordSearchResult small = find_by_cord(four, outcome_of_island);
  ASSERT_TRUE(small.found);
  EXPECT_EQ(small.least_work, 20.0 + 10.0 + 10.0);
  EXPECT_EQ(small.found->settings.own, (std::map<int, Setting>{{3, fast}}));  // it saves alone, and comes first
  EXPECT_EQ(small.found->outcome.work, 310.0);
  four.max_error_m = 1e-2;
  const CordSearchResult large = find_by_cord(four, outcome_of_island);
  ASSERT_TRUE(large.found);
  EXPECT_EQ(large.found->settings.own, (std::map<int, Setting>{{1, fast}, {2, fast}, {3, fast}}));
  EXPECT_EQ(large.found->outcome.work, 20.0 + 10.0 + 100.0);
}

TEST(ByCord, ACordThatFailsOrSavesNothingKeepsTheCommonSetting) {
  const auto judge = [](const CordSettings& settings) {
    Outcome outcome{0.0, 200.0, {}};
    if (settings.own.count(1) > 0) outcome.failure = "3 ticks not converged";
    if (settings.own.count(1) > 0) outcome.work = 50.0;
    return outcome;
  };
  const CordSearchResult result = find_by_cord(search(2), judge);
  EXPECT_FALSE(result.found);
  EXPECT_EQ(result.least_work, 200.0);
}

Measured measured(const Setting& setting, double error_m, double work) {
  Measured m;
  m.setting = setting;
  m.error.position_m = error_m;
  m.tick_work = {work, work, work};
  return m;
}

TEST(ByCord, StartsFromTheCommonSettingWithTheLeastWork) {
  Study study;
  study.settings = {measured(exact, 1e-4, 400.0), measured(fast, 2e-2, 100.0), measured(middle, 5e-3, 300.0),
                    measured(present(), 9e-3, 200.0)};
  const auto start = search_of(study, 8e-3, {5, 6});
  ASSERT_TRUE(start);
  EXPECT_EQ(start->common.common, middle);
  EXPECT_EQ(start->of_common.work, 300.0);
  EXPECT_EQ(start->of_common.error_m, 5e-3);
  EXPECT_EQ(start->cheaper, std::vector<Setting>{fast});  // the present one is no setting of a cord
  EXPECT_EQ(start->cords, (std::vector<int>{5, 6}));
  EXPECT_EQ(least_work_within(study, 8e-3), 300.0);
  EXPECT_EQ(least_work_within(study, 9e-3), 200.0);  // the present one
  EXPECT_EQ(search_of(study, 9e-3, {5, 6})->common.common, middle);
  EXPECT_FALSE(search_of(study, 8e-3, {5}));
  EXPECT_FALSE(search_of(study, 5e-5, {5, 6}));
  EXPECT_FALSE(search_of(study, 3e-2, {5, 6}));  // the cheapest one is within it

  const CordBound bound = bound_of(study, 8e-3, 2);
  EXPECT_EQ(bound.common, name_of(middle));
  EXPECT_EQ(bound.common_work, 300.0);
  EXPECT_EQ(bound.most_gain, 300.0 / bound.least_work);
  study.least_work_by_cord = 150.0;
  EXPECT_EQ(bound_of(study, 8e-3, 2).most_gain, 2.0);  // by what the search has found
  study.least_work_by_cord = 50.0;
  EXPECT_EQ(bound_of(study, 8e-3, 2).most_gain, bound.most_gain);
  EXPECT_EQ(bound_of(study, 8e-3, 1).most_gain, 1.0);
  EXPECT_EQ(bound_of(study, 3e-2, 2).most_gain, 1.0);
  EXPECT_TRUE(std::isnan(bound_of(study, 5e-5, 2).most_gain));
}

TEST_F(LevelStudy, ACordHasItsOwnSettingInTheLevelAndInTheFile) {
  const LevelFile file(level_path);
  const std::vector<int> objects = cord_objects_of(file.level());
  ASSERT_GT(objects.size(), 1U);
  CordSettings settings = exact;
  settings.own[objects[1]] = fast;
  const auto check = [&](const game::Level& level) {
    const auto scene = level.make_scene();
    for (const ribbon::box2d::CordId c : scene->coupling().cords()) {
      EXPECT_EQ(scene->coupling().cord(c).direct().def().accuracy, accuracy_of(c == 1 ? fast : exact)) << c;
    }
  };
  check(file.with(settings));
  EXPECT_EQ(file.with(settings).line_accuracy, accuracy_of(exact));
  const auto by_id = accuracies_of(file.level(), settings);
  ASSERT_EQ(by_id.size(), 1U);
  EXPECT_EQ(by_id.at(1), accuracy_of(fast));
  file.apply(settings);
  check(LevelFile(level_path).level());
}

/// In windows, and with another player: a rope that is not held may be fast, and the error is that of the other one.
TEST_F(LevelStudy, SettingsByCordAreMeasured) {
  StudyOptions options = this->options();
  options.folder.clear();
  options.windows = 2;
  options.grid = {fast, exact};
  options.others = {Inputs(20)};
  const LevelFile file(level_path);
  const std::vector<Point> common = applicable(measure(file, replay_path, options));
  ASSERT_GT(common[0].error_m, 2.0 * common[1].error_m);
  options.by_cord_error_m = 0.99 * common[0].error_m / usable_error_share;  // not with all of them fast
  const Study study = measure(file, replay_path, options);
  ASSERT_TRUE(study.by_cord);
  EXPECT_TRUE(study.complete);
  EXPECT_GT(study.by_cord->settings.own.size(), 0U);
  EXPECT_LT(study.by_cord->settings.own.size(), cord_objects_of(file.level()).size());
  EXPECT_LT(study.by_cord->outcome.work, study.by_cord->common_work);
  EXPECT_LE(study.by_cord->outcome.error_m, 0.99 * common[0].error_m);
  EXPECT_GE(study.by_cord->outcome.error_m, common[1].error_m);
  const std::string words = in_words(*study.by_cord, file);
  EXPECT_NE(words.find("all others: tr_bdf2 substeps=4 tolerance=0.0001: work "), std::string::npos) << words;
  EXPECT_NE(words.find("times less than with one setting for all, error "), std::string::npos) << words;
}

}  // namespace
}  // namespace study
