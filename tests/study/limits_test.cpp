#include "tests/study/limits.h"

#include <gtest/gtest.h>

#include <array>

namespace study {
namespace {

Measured setting(int substeps, double error_m, double us, WorkFigures work) {
  Measured m;
  m.setting.substeps = substeps;
  m.error.position_m = error_m;
  m.cost_us = m.least_us = us;
  m.tick_work = work;
  return m;
}

/// Three settings: a tick takes 5 us and 0.1 us per unit of work.
Study three() {
  Study study;
  study.settings = {setting(1, 8e-3, 15.0, {100.0, 1000.0, 9000.0}), setting(2, 4e-3, 25.0, {200.0, 400.0, 500.0}),
                    setting(4, 1e-3, 45.0, {400.0, 800.0, 1000.0})};
  return study;
}

TEST(Limits, ACalibrationTurnsWorkIntoTime) {
  const Calibration calibration = calibrate(three());
  EXPECT_NEAR(calibration.base_us, 5.0, 1e-9);
  EXPECT_NEAR(calibration.us_per_work, 0.1, 1e-12);
  EXPECT_NEAR(calibration.us(9000.0), 905.0, 1e-6);
  EXPECT_NEAR(calibration.rank_correlation, 1.0, 1e-12);
  const std::array<Sample, 3> wrong = {{{1.0, 3.0}, {2.0, 2.0}, {3.0, 1.0}}};
  EXPECT_NEAR(calibrate(wrong).rank_correlation, -1.0, 1e-12);
  EXPECT_EQ(calibrate(wrong).base_us, 0.0);  // a cost does not fall with work
  EXPECT_GT(calibrate(wrong).us_per_work, 0.0);
  const std::array<Sample, 1> one = {{{10.0, 5.0}}};
  EXPECT_NEAR(calibrate(one).us_per_work, 0.5, 1e-12);
  EXPECT_EQ(calibrate(std::span<const Sample>()).us_per_work, 0.0);
}

/// Settings that take the same steps differ only by the noise of the clock.
TEST(Limits, SettingsOfEqualWorkCountAsOneInTheRankCorrelation) {
  const std::array<Sample, 5> equal = {
      {{1000.0, 30.0}, {1009.0, 10.0}, {2000.0, 25.0}, {3000.0, 40.0}, {3001.0, 35.0}}};
  EXPECT_NEAR(calibrate(equal).rank_correlation, 1.0, 1e-12);
  const std::array<Sample, 4> apart = {{{1000.0, 30.0}, {1020.0, 10.0}, {2000.0, 25.0}, {3000.0, 40.0}}};
  EXPECT_NEAR(calibrate(apart).rank_correlation, 0.4, 1e-12);
}

TEST(Limits, TheFitIsThatOfTheLeastDisturbedRepeats) {
  Study study = three();
  for (Measured& m : study.settings) m.cost_us *= 3.0;
  EXPECT_NEAR(calibrate(study).us(9000.0), 905.0, 1e-6);
}

TEST(Limits, AnErrorLimitChoosesTheCheapestWithinTheBudgets) {
  const Study study = three();
  const Calibration calibration = calibrate(study);
  Limits limits;
  limits.max_error_m = 1e-2;
  EXPECT_EQ(choose(study, limits, calibration).setting, 0U);
  limits.p99_us = 120.0;  // of which 90 may be used; the first setting takes 105
  EXPECT_EQ(choose(study, limits, calibration).setting, 1U);
  limits.p99_us.reset();
  limits.most_us = 1000.0;  // it takes 905
  EXPECT_EQ(choose(study, limits, calibration).setting, 1U);
  limits.most_us = 1250.0;
  EXPECT_EQ(choose(study, limits, calibration).setting, 0U);
  limits.most_work = 1000.0;
  EXPECT_EQ(choose(study, limits, calibration).setting, 1U);
}

TEST(Limits, ABudgetChoosesTheMostExact) {
  const Study study = three();
  const Calibration calibration = calibrate(study);
  Limits limits;
  limits.most_work = 1400.0;
  EXPECT_EQ(choose(study, limits, calibration).setting, 2U);
  limits.most_work = 1300.0;  // of which 975 may be used
  EXPECT_EQ(choose(study, limits, calibration).setting, 1U);
  limits.median_us = 20.0;  // of which 15 may be used
  limits.most_work.reset();
  EXPECT_EQ(choose(study, limits, calibration).setting, 0U);
}

TEST(Limits, WhatNothingMeetsNamesTheNearest) {
  const Study study = three();
  Limits limits;
  limits.max_error_m = 5e-4;
  limits.most_work = 800.0;
  const Choice choice = choose(study, limits, calibrate(study));
  EXPECT_FALSE(choice.setting);
  ASSERT_TRUE(choice.nearest);
  EXPECT_EQ(*choice.nearest, 2U);
  EXPECT_NEAR(choice.excess, 1e-3 / (0.8 * 5e-4), 1e-12);
  EXPECT_EQ(in_words(limits), "an error of 0.0005 m and a greatest tick of 800 units of work");
  EXPECT_NE(
      in_words(study, 2, calibrate(study), {}).find("the greatest tick 105 us (1000 units of work), error 0.001 m"),
      std::string::npos);
}

TEST(Limits, TheErrorIsThatOfSomething) {
  Study study = three();
  Measured& m = study.settings[2];
  const auto words = [&] { return in_words(study, 2, calibrate(study), {}); };
  m.windows.body_m = 2e-3;
  EXPECT_NE(words().find("error 0.002 m (of a body, in a quarter of a second)"), std::string::npos) << words();
  m.error.player_m = 3e-3;
  EXPECT_NE(words().find("error 0.003 m (of the player, from the start on)"), std::string::npos) << words();
  m.resolution_m = 5e-3;  // more than all of them
  EXPECT_EQ(words().substr(words().size() - 13), "error 0.005 m") << words();
}

/// The recorded player may meet no cord.
TEST(Limits, AnotherPlayerRulesASettingOut) {
  Limits limits;
  limits.max_error_m = 1e-2;
  Study study = three();
  WithOthers& others = study.settings[0].others;
  others.error_m = 9e-3;  // 8 mm may be used
  EXPECT_EQ(choose(study, limits, calibrate(study)).setting, 1U);
  others.error_m = 7e-3;
  EXPECT_EQ(choose(study, limits, calibrate(study)).setting, 0U);
  others.failure = "3 ticks not converged";
  EXPECT_EQ(choose(study, limits, calibrate(study)).setting, 1U);
  EXPECT_EQ(applicable(study)[0].failure, "with another player: 3 ticks not converged");
}

TEST(Limits, AnotherPlayerNeedsItsWork) {
  Study study = three();
  const Calibration calibration = calibrate(study);
  const auto choice = [&](const Limits& limits) { return choose(study, limits, calibration).setting; };
  study.settings[2].others.work = {900.0, 2000.0, 3000.0};
  EXPECT_EQ(choice({.median_us = 100.0}), 1U);  // it takes 95
  EXPECT_EQ(choice({.median_us = 130.0}), 2U);
  EXPECT_EQ(choice({.p99_us = 200.0}), 1U);  // it takes 205
  EXPECT_EQ(choice({.most_us = 400.0}), 1U);
  EXPECT_EQ(choice({.most_work = 3000.0}), 1U);
  EXPECT_EQ(choice({.most_work = 4000.0}), 2U);
  study.settings[2].others.error_m = 5e-3;
  const std::string words = in_words(study, 2, calibration, {});
  EXPECT_NE(in_words(study, 0, {5.0, 1.0}, {}).find("the greatest tick 9.01 ms (9000"), std::string::npos);
  EXPECT_NE(words.find("greatest tick 305 us (3000 units of work), error 0.005 m (with another player)"),
            std::string::npos)
      << words;
}

/// A tick that spends its budget may be off by any length with the next player.
TEST(Limits, WhatSpendsItsBudgetOfWorkIsTheLastChoiceForAnError) {
  for (int where = 0; where < 3; ++where) {
    Study study = three();
    Measured& cheapest = study.settings[0];
    if (where == 0) cheapest.work.posed = 1;
    if (where == 1) cheapest.windows.spends_budget = true;
    if (where == 2) cheapest.others.spends_budget = true;
    EXPECT_EQ(choose(study, {.max_error_m = 1e-2}, calibrate(study)).setting, 1U) << where;
    EXPECT_EQ(choose(study, {.median_us = 20.0}, calibrate(study)).setting, 0U) << where;
    study.settings[1].failure = study.settings[2].failure = "1 tick not converged";
    EXPECT_EQ(choose(study, {.max_error_m = 1e-2}, calibrate(study)).setting, 0U) << where;
  }
}

TEST(Limits, OfSettingsThatSpendTheirBudgetsAnAmpleOneIsBetterForAnError) {
  Study study = three();
  for (Measured& m : study.settings) m.work.posed = 1;
  EXPECT_EQ(choose(study, {.max_error_m = 1e-2}, calibrate(study)).setting, 0U);
  study.settings[1].setting.max_work = ample_work;
  EXPECT_EQ(choose(study, {.max_error_m = 1e-2}, calibrate(study)).setting, 1U);
  EXPECT_EQ(choose(study, {.median_us = 20.0}, calibrate(study)).setting, 0U) << "one for a budget alone";
}

TEST(Limits, WhatIsRecommendedForAnErrorHasAnAmpleBudgetOfWork) {
  Measured chosen;
  EXPECT_EQ(recommended_for({.max_error_m = 1e-2}, chosen).max_work, ample_work);
  EXPECT_EQ(recommended_for({.most_us = 500.0}, chosen), chosen.setting);
  chosen.work.posed = 1;
  EXPECT_EQ(recommended_for({.max_error_m = 1e-2}, chosen), chosen.setting);
  EXPECT_EQ(with_ample_work(present()), present());
  Setting large;
  large.max_work = 50'000;
  EXPECT_EQ(with_ample_work(large), large);
  Study study = three();
  const std::string words = in_words(study, 0, calibrate(study), {.max_error_m = 1e-2});
  EXPECT_NE(words.find(" max_work=20000: "), std::string::npos) << words;
}

TEST(Limits, FailuresAndOtherMeshesAreNotChosen) {
  Study study = three();
  study.settings[0].failure = "blew up in tick 3";
  study.settings[1].setting.points = 2.0;
  Limits limits;
  limits.max_error_m = 1.0;
  EXPECT_EQ(choose(study, limits, calibrate(study)).setting, 2U);
}

}  // namespace
}  // namespace study
