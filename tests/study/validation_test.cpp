#include "tests/study/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace study {
namespace {

// --- arithmetic: a level whose settings have the results that the test defines
// ----------------------------------------------------

constexpr double found_at = 0.5;  // relative to the limit, in the first measurement: below each margin

/// Each setting of the grid has half of the cost and error limits; in the second measurement it has those of `again`.
Validation validation_of(int runs, const std::function<void(int k, Measured&)>& first,
                         const std::function<void(int k, Measured&)>& again) {
  int k = -1;
  const Measure measure = [&](const LevelFile&, const std::vector<engine::TickInput>&, const StudyOptions& options) {
    const bool is_first = options.grid.size() > 2;  // in a run; the recommended settings are one or two
    k += is_first ? 1 : 0;
    Study study;
    study.level = "some";
    for (const Setting& setting : options.grid) {
      Measured& m = study.settings.emplace_back();
      m.setting = setting;
      m.error.position_m = found_at * 1e-2;
      m.cost_us = found_at * 100.0;
      (is_first ? first : again)(k, m);
    }
    return study;
  };
  const std::vector<LevelFile> levels = {LevelFile(TEST_ASSETS "/levels/first_swing.tmj")};
  ValidationOptions options;
  options.runs = runs;
  return validate_recommendations(
      levels, options, [](double) {}, measure);
}

const auto original = [](int, Measured&) {};

TEST(Validation, CountsRunsWithinTheLimits) {
  const Validation validation = validation_of(4, original, [](int k, Measured& m) {
    m.error.position_m = k == 0 ? 1e-2 : k == 1 ? 1.01e-2 : 1e-3;
    m.cost_us = k == 2 ? 101.0 : 100.0;
  });
  EXPECT_EQ(validation.error.recommended, 4);
  EXPECT_EQ(validation.error.met, 3);
  EXPECT_EQ(validation.budget.recommended, 4);
  EXPECT_EQ(validation.budget.met, 3);
  ASSERT_EQ(validation.violations.size(), 2U);
  EXPECT_EQ(validation.violations[0].find("some, run 2, error [m]: "), 0U) << validation.violations[0];
  EXPECT_NE(validation.violations[0].find(": 0.0101"), std::string::npos);
  EXPECT_EQ(validation.violations[1].find("some, run 3, cost [us]: "), 0U) << validation.violations[1];
}

TEST(Validation, AFailedRunIsWithinNoLimit) {
  const Validation validation = validation_of(2, original, [](int k, Measured& m) {
    if (k == 1) m.failure = "blew up in tick 3";
  });
  EXPECT_EQ(validation.error.met, 1);
  EXPECT_EQ(validation.budget.met, 1);
  ASSERT_EQ(validation.violations.size(), 2U);
  EXPECT_NE(validation.violations[0].find("blew up in tick 3"), std::string::npos);
}

TEST(Validation, RunsWithoutARecommendationAreCountedSeparately) {
  const auto first = [](int k, Measured& m) {
    if (k == 0) m.failure = "blew up in tick 3";
    if (k == 1) m.cost_us = 99.0;           // within the budget, but not with its margin
    if (k == 2) m.error.position_m = 9e-3;  // within the error, but not with its margin
  };
  const Validation validation = validation_of(4, first, original);
  EXPECT_EQ(validation.error.not_found, 2);
  EXPECT_EQ(validation.error.recommended, 2);
  EXPECT_EQ(validation.error.met, 2);
  EXPECT_EQ(validation.budget.not_found, 2);
  EXPECT_EQ(validation.budget.recommended, 2);
  EXPECT_EQ(validation.budget.met, 2);
  EXPECT_TRUE(validation.violations.empty());
}

TEST(Validation, OnlyRecommendedSettingsAreMeasuredAgain) {
  std::vector<std::size_t> grids;
  const Measure measure = [&](const LevelFile&, const std::vector<engine::TickInput>&, const StudyOptions& options) {
    grids.push_back(options.grid.size());
    Study study;
    for (const Setting& setting : options.grid) {
      Measured& m = study.settings.emplace_back();
      m.setting = setting;
      EXPECT_EQ(setting.solver, "direct");
      EXPECT_EQ(setting.points, 1.0);
      m.error.position_m = 1e-3 / setting.substeps;
      m.cost_us = 10.0 * setting.substeps + (setting.integrator == "tr_bdf2" ? 1.0 : 0.0);
    }
    return study;
  };
  const std::vector<LevelFile> levels = {LevelFile(TEST_ASSETS "/levels/first_swing.tmj")};
  ValidationOptions options;
  options.runs = 1;
  const Validation validation = validate_recommendations(
      levels, options, [](double) {}, measure);
  ASSERT_EQ(grids.size(), 2U);
  EXPECT_GE(grids[0], 4U);
  EXPECT_EQ(grids[1], 2U);
  EXPECT_EQ(validation.error.met + validation.budget.met, 2);
}

TEST(Validation, LevelsAlternateAndEachRunDiffers) {
  std::vector<std::uint64_t> hashes;
  std::vector<std::vector<engine::TickInput>> inputs;
  const Measure measure = [&](const LevelFile& file, const auto& input, const StudyOptions& options) {
    hashes.push_back(file.hash());
    inputs.push_back(input);
    Study study;
    for (const Setting& setting : options.grid) study.settings.emplace_back().setting = setting;
    return study;
  };
  const LevelFile level(TEST_ASSETS "/levels/first_swing.tmj");
  const std::vector<LevelFile> levels = {level, level.varied(1000)};
  ValidationOptions options;
  options.runs = 3;
  validate_recommendations(
      levels, options, [](double) {}, measure);
  ASSERT_EQ(hashes.size(), 6U);
  EXPECT_EQ(std::set<std::uint64_t>(hashes.begin(), hashes.end()).size(), 3U);
  EXPECT_EQ(hashes[0], level.varied(0).hash());
  EXPECT_EQ(hashes[1], hashes[0]);  // both inputs of a run have the same variation
  EXPECT_EQ(hashes[2], level.varied(1000).varied(2).hash());
  EXPECT_EQ(hashes[4], level.varied(4).hash());
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      EXPECT_FALSE(std::equal(inputs[j].begin(), inputs[j].end(), inputs[k].begin(),
                              [](const auto& a, const auto& b) { return a.buttons == b.buttons; }));
    }
  }
}

TEST(Validation, MeasuresARealLevel) {
  const std::vector<LevelFile> levels = {LevelFile(TEST_ASSETS "/levels/first_swing.tmj")};
  ValidationOptions options;
  options.runs = 1;
  options.max_error_m = 10.0;
  options.budget_us = 1e9;
  options.ticks = 5;
  const Validation validation = validate_recommendations(levels, options, [](double) {});
  EXPECT_EQ(validation.error.met, 1);
  EXPECT_EQ(validation.budget.met, 1);
}

// --- variation
// --------------------------------------------------------------------------------------------------------

TEST(Variation, IsTheSameForTheSameSeed) {
  const LevelFile file(TEST_ASSETS "/levels/first_swing.tmj");
  EXPECT_EQ(file.varied(3).hash(), file.varied(3).hash());
  EXPECT_NE(file.varied(3).hash(), file.varied(4).hash());
  EXPECT_EQ(file.varied(3).level().map.content_hash, file.varied(3).hash());
  EXPECT_EQ(file.level().map.content_hash, game::load_level(file.path()).map.content_hash);
}

/// Smallest and largest value, relative to that of the level.
struct Range {
  double least = 1e9;
  double most = 0.0;
  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

void expect_range(const Range& range, double factor) {
  EXPECT_GE(range.least, 0.97 / factor);  // links are whole
  EXPECT_LE(range.most, 1.03 * factor);
  EXPECT_LT(range.least, 1.3 / factor);  // and the range is used up to its ends
  EXPECT_GT(range.most, factor / 1.3);
}

TEST(Variation, StaysWithinItsRangesAndCoversThem) {
  const LevelFile file(TEST_ASSETS "/levels/first_swing.tmj");
  const auto own = file.level().make_scene();
  const double own_mass = file.level().player_mass;
  Range mass, links, drag, damping, bending, player;
  double furthest = 0.0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const game::Level level = file.varied(seed).level();
    player.add(level.player_mass / own_mass);
    const auto scene = level.make_scene();
    for (int c = 0; c < own->coupling().size(); ++c) {
      const ribbon::CordDef& is = scene->coupling().cord(c).direct().def();
      const ribbon::CordDef& was = own->coupling().cord(c).direct().def();
      mass.add(is.mass_per_length * is.length / (was.mass_per_length * was.length));
      links.add((is.points - 1.0) / (was.points - 1.0));
      drag.add(is.drag / was.drag);
      damping.add(is.damping / was.damping);
      bending.add(is.bending_stiffness / was.bending_stiffness);
      const ribbon::Vec2 off = is.positions.front() - was.positions.front();
      furthest = std::max({furthest, std::abs(off.x), std::abs(off.y)});
      EXPECT_EQ(is.friction, was.friction);
      EXPECT_EQ(is.pins.size(), was.pins.size());
    }
  }
  for (const Range& range : {mass, drag, damping, bending, player}) expect_range(range, Variation::factor);
  expect_range(links, Variation::links);
  EXPECT_LE(furthest, Variation::place + 1e-12);
  EXPECT_GT(furthest, 0.9 * Variation::place);
}

TEST(Variation, IsTheLevelThatIsMeasured) {
  const LevelFile file = LevelFile(TEST_ASSETS "/levels/first_swing.tmj").varied(7);
  const auto with = file.with({"direct", "tr_bdf2", 2, 1e-5}).make_scene();
  const auto own = file.level().make_scene();
  EXPECT_EQ(with->coupling().cord(0).direct().def().points, own->coupling().cord(0).direct().def().points);
  EXPECT_EQ(with->coupling().cord(0).direct().def().mass_per_length,
            own->coupling().cord(0).direct().def().mass_per_length);
  EXPECT_EQ(with->coupling().cord(0).direct().def().accuracy.substeps, 2);
}

}  // namespace
}  // namespace study
