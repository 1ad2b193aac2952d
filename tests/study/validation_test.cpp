#include "tests/study/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/support/refusal.h"

namespace study {
namespace {

// --- arithmetic: a level whose settings have the results that the test defines
// ----------------------------------------------------

constexpr double found_at = 0.5;  // relative to the limit, in the first measurement: below each margin

Measured measured_of(const Setting& setting) {
  Measured m;
  m.setting = setting;
  m.error.position_m = found_at * 1e-2;
  m.cost_us = m.least_us = found_at * 100.0;
  m.tick_work = {1000.0, 2000.0, 3000.0};
  return m;
}

/// The rows of runs of one level. Each setting of the grid has half of the cost and error limits, changed by `first`;
/// in the second measurement, by `again`.
std::vector<PromiseRow> rows_of(int runs, const std::function<void(int k, Measured&)>& first,
                                const std::function<void(int k, Measured&)>& again,
                                const Limits& limits = {.max_error_m = 1e-2, .median_us = 100.0}, Shard shard = {}) {
  int k = -1;
  const Measure measure = [&](const LevelFile&, const std::vector<engine::TickInput>&, const StudyOptions& options) {
    const bool is_first = options.grid.size() > 2;  // in a run; the recommended settings are one or two
    k += is_first ? 1 : 0;
    Study study;
    for (const Setting& setting : options.grid) {
      study.settings.push_back(measured_of(setting));
      (is_first ? first : again)(k, study.settings.back());
    }
    return study;
  };
  const std::vector<LevelFile> levels = {LevelFile(TEST_ASSETS "/levels/first_swing.tmj")};
  ValidationOptions options;
  options.promises = promises_of(limits);
  options.runs = runs;
  options.others = 0;
  options.shard = shard;
  std::vector<PromiseRow> all;
  const auto add = [&](const std::vector<PromiseRow>& rows, double) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
  validate_recommendations(levels, options, add, measure);
  return all;
}

const auto original = [](int, Measured&) {};

/// Returns the tally of all levels.
Tally tally(const std::vector<PromiseRow>& rows, std::size_t promise) {
  return tallies_of(rows).at(promise).second.at(0).second;
}

TEST(Validation, CountsRunsWithinTheLimits) {
  const std::vector<PromiseRow> rows = rows_of(4, original, [](int k, Measured& m) {
    m.error.position_m = k == 0 ? 1e-2 : k == 1 ? 1.01e-2 : 1e-3;
    m.cost_us = k == 2 ? 101.0 : 100.0;
  });
  ASSERT_EQ(rows.size(), 8U);
  EXPECT_EQ(tallies_of(rows)[0].first, "error_0.01_m");
  EXPECT_EQ(tallies_of(rows)[1].first, "median_100_us");
  for (const std::size_t promise : {0U, 1U}) {
    EXPECT_EQ(tally(rows, promise).recommended, 4);
    EXPECT_EQ(tally(rows, promise).met, 3);
  }
  EXPECT_EQ(rows[2].run, 2U);
  EXPECT_EQ(rows[2].value, 1.01e-2);
  EXPECT_FALSE(rows[2].is_met);
  EXPECT_FALSE(rows[5].is_met);
}

TEST(Validation, WindowsCountToo) {
  const std::vector<PromiseRow> rows =
      rows_of(1, original, [](int, Measured& m) { m.windows.player_m = 2e-2; }, {.max_error_m = 1e-2});
  EXPECT_EQ(rows.at(0).value, 2e-2);
  EXPECT_FALSE(rows[0].is_met);
}

TEST(Validation, AFailedRunIsWithinNoLimit) {
  const std::vector<PromiseRow> rows = rows_of(2, original, [](int k, Measured& m) {
    if (k == 1) m.failure = "blew up in tick 3";
  });
  EXPECT_EQ(tally(rows, 0).met, 1);
  EXPECT_EQ(tally(rows, 1).met, 1);
  EXPECT_EQ(rows[3].failure, "blew up in tick 3");
}

TEST(Validation, RunsWithoutARecommendationAreCountedSeparately) {
  const auto first = [](int k, Measured& m) {
    if (k == 0) m.failure = "blew up in tick 3";
    if (k == 1) m.cost_us = 99.0;           // within the budget, but not with its margin
    if (k == 2) m.error.position_m = 9e-3;  // within the error, but not with its margin
  };
  const std::vector<PromiseRow> rows = rows_of(4, first, original);
  for (const std::size_t promise : {0U, 1U}) {
    EXPECT_EQ(tally(rows, promise).not_found, 2);
    EXPECT_EQ(tally(rows, promise).recommended, 2);
    EXPECT_EQ(tally(rows, promise).met, 2);
  }
}

/// By counted work, so that it is the same on every machine.
TEST(Validation, TheCheapestSettingHasTheLeastWork) {
  const auto first = [](int, Measured& m) {
    const bool is_euler = m.setting.integrator == "implicit_euler" && m.setting.substeps == 1;
    m.tick_work.mean = is_euler && m.setting.tolerance == 1e-2 ? 10.0 : 100.0;
    m.cost_us = is_euler ? 50.0 : 5.0;
  };
  const std::vector<PromiseRow> rows = rows_of(1, first, original, {.max_error_m = 1e-2});
  EXPECT_EQ(rows.at(0).setting, "implicit_euler substeps=1 tolerance=0.01 max_work=20000");
}

/// At 0.1 us a unit of work.
TEST(Validation, ThePercentileIsThatOfCountedWork) {
  const auto again = [](int k, Measured& m) { m.tick_work.p99 = k == 0 ? 2990.0 : 3010.0; };
  const auto first = [](int, Measured& m) { m.cost_us = m.least_us = 100.0; };
  const std::vector<PromiseRow> rows = rows_of(2, first, again, {.p99_us = 300.0});
  EXPECT_NEAR(rows.at(0).value, 299.0, 1e-6);
  EXPECT_TRUE(rows[0].is_met);
  EXPECT_NEAR(rows.at(1).value, 301.0, 1e-6);
  EXPECT_FALSE(rows[1].is_met);
}

TEST(Validation, FourPromisesUnlessOthersAreAskedFor) {
  std::string names;
  for (const Promise& promise : promises_of({})) names += promise.name + ' ';
  EXPECT_EQ(names, "error_0.01_m error_0.001_m median_100_us p99_300_us ");
  EXPECT_EQ(promises_of({.most_work = 5000.0}).at(0).name, "greatest_5000_work");
  EXPECT_EQ(promises_of({.most_work = 5000.0}).size(), 1U);
}

TEST(Validation, LevelsAlternateAndEachRunDiffers) {
  std::vector<std::uint64_t> hashes;
  std::vector<std::vector<engine::TickInput>> inputs;
  const Measure measure = [&](const LevelFile& file, const auto& input, const StudyOptions& options) {
    hashes.push_back(file.hash());
    inputs.push_back(input);
    Study study;
    for (const Setting& setting : options.grid) study.settings.push_back(measured_of(setting));
    return study;
  };
  const LevelFile level(TEST_ASSETS "/levels/first_swing.tmj");
  const std::vector<LevelFile> levels = {level, level.varied(1000)};
  ValidationOptions options;
  options.runs = 2;
  options.others = 0;
  validate_recommendations(
      levels, options, [](const auto&, double) {}, measure);
  ASSERT_EQ(hashes.size(), 8U);
  EXPECT_EQ(std::set<std::uint64_t>(hashes.begin(), hashes.end()).size(), 4U);
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

/// A setting is chosen with the players that meet cords and the recorded one, and tested with one player alone.
TEST(Validation, SettingsAreChosenWithSeveralPlayers) {
  const std::vector<LevelFile> levels = {LevelFile(TEST_ASSETS "/levels/first_swing.tmj")};
  const Inputs recorded = random_inputs(77, 240);
  std::vector<std::size_t> others;
  const Measure measure = [&](const LevelFile&, const auto&, const StudyOptions& options) {
    others.push_back(options.others.size());
    if (!options.others.empty()) {
      EXPECT_EQ(options.others.back().size(), recorded.size());
    }
    Study study;
    for (const Setting& setting : options.grid) {
      study.settings.push_back(measured_of(setting));
      const bool is_exact = setting.substeps == 4 && setting.tolerance == 1e-4;
      if (!options.others.empty()) study.settings.back().others.error_m = is_exact ? 1e-3 : 2e-2;
      study.settings.back().tick_work.mean = is_exact ? 2000.0 : 1000.0;
    }
    return study;
  };
  ValidationOptions options;
  options.runs = 1;
  options.others = 2;
  options.recorded = {recorded};
  options.promises = promises_of({.max_error_m = 1e-2});
  std::vector<PromiseRow> rows;
  validate_recommendations(
      levels, options, [&](const auto& some, double) { rows = some; }, measure);
  EXPECT_EQ(others, (std::vector<std::size_t>{3, 0}));
  EXPECT_EQ(rows.at(0).setting, "tr_bdf2 substeps=4 tolerance=0.0001 max_work=20000");
}

/// Of each player the input with which it was measured, and the runs that came out.
struct Tried {
  std::vector<Inputs> inputs;
  std::vector<PromiseRow> rows;
};

/// The study of the `refused`-th input, if any, says that no cord exists.
Tried tried_with(int runs, int players, std::size_t refused = 0) {
  Tried tried;
  const Measure measure = [&](const LevelFile&, const Inputs& inputs, const StudyOptions& options) {
    tried.inputs.push_back(inputs);
    if (tried.inputs.size() == refused) throw engine::MapError("no cord");
    Study study;
    for (const Setting& setting : options.grid) study.settings.push_back(measured_of(setting));
    return study;
  };
  const std::vector<LevelFile> levels = {LevelFile(TEST_ASSETS "/levels/first_swing.tmj")};
  ValidationOptions options;
  options.runs = runs;
  options.players = players;
  options.others = 0;
  options.promises = promises_of({.max_error_m = 1e-2});
  validate_recommendations(
      levels, options, [&](const auto& some, double) { tried.rows.insert(tried.rows.end(), some.begin(), some.end()); },
      measure);
  return tried;
}

TEST(Validation, AChoiceIsTriedWithSeveralPlayersARunEach) {
  const Tried several = tried_with(4, 2);
  const Tried single = tried_with(2, 1);
  ASSERT_EQ(several.inputs.size(), 6U);  // of each of two variations: one to choose with, two to try
  ASSERT_EQ(single.inputs.size(), 4U);
  std::vector<std::size_t> numbers;
  for (const PromiseRow& row : several.rows) numbers.push_back(row.run);
  EXPECT_EQ(numbers, (std::vector<std::size_t>{1, 3, 2, 4}));
  EXPECT_EQ(several.rows.at(0), single.rows.at(0));
  EXPECT_EQ(several.rows.at(2), single.rows.at(1));
  const auto presses = [](const Inputs& inputs) {
    std::vector<std::uint16_t> buttons;
    for (const engine::TickInput& tick : inputs) buttons.push_back(tick.buttons);
    return buttons;
  };
  EXPECT_EQ(presses(several.inputs[1]), presses(single.inputs[1]));
  EXPECT_EQ(presses(several.inputs[4]), presses(single.inputs[3]));
  std::set<std::vector<std::uint16_t>> all;
  for (const Inputs& inputs : several.inputs) all.insert(presses(inputs));
  EXPECT_EQ(all.size(), several.inputs.size());
}

TEST(Validation, APlayerWithoutCordsLeavesTheOthers) {
  const Tried tried = tried_with(3, 3, 3);  // the first input is chosen with
  ASSERT_EQ(tried.inputs.size(), 4U);
  ASSERT_EQ(tried.rows.size(), 3U);
  EXPECT_EQ(tried.rows[1].failure, "no such variation: no cord");
  EXPECT_EQ(tried.rows[1].setting, "");
  for (const std::size_t k : {0U, 2U}) {
    EXPECT_EQ(tried.rows[k].failure, "");
    EXPECT_TRUE(tried.rows[k].is_met);
  }
}

TEST(Validation, PlayersThatDoNotDivideTheRunsAreRefused) {
  for (const int players : {0, 3}) {
    const std::string said = test_support::refusal<std::invalid_argument>([&] { tried_with(4, players); });
    EXPECT_NE(said.find("accepted is a divisor"), std::string::npos) << players << ": " << said;
  }
}

/// As it is recommended: for an error with ample_work, for a cost as it was measured.
TEST(Validation, ASettingIsTestedAsItIsRecommended) {
  std::vector<std::string> tested;
  const auto again = [&tested](int, Measured& m) { tested.push_back(name_of(m.setting)); };
  const std::vector<PromiseRow> rows = rows_of(1, original, again);
  const std::string name = "implicit_euler substeps=1 tolerance=0.01";
  EXPECT_EQ(tested, (std::vector{name + " max_work=20000", name}));
  EXPECT_EQ(rows.at(0).setting, name + " max_work=20000");
  EXPECT_EQ(rows.at(1).setting, name);
}

TEST(Validation, TheRowsOfShardsAreThoseOfTheWhole) {
  const std::vector<PromiseRow> whole = rows_of(5, original, original);
  std::vector<PromiseRow> merged;
  for (const std::size_t number : {1U, 2U, 3U}) {
    const std::vector<PromiseRow> part =
        rows_of(5, original, original, {.max_error_m = 1e-2, .median_us = 100.0}, {number, 3});
    EXPECT_LT(part.size(), whole.size());
    merged.insert(merged.end(), part.begin(), part.end());
  }
  EXPECT_EQ(merged, whole);
}

TEST(Validation, RowsAreReadAsTheyAreWritten) {
  const std::vector<PromiseRow> rows = {{1, "first, or \"second\"", "error_0.01_m", "a b", 0.125, true, "", true, "1f"},
                                        {2, "third", "p99_300_us", "", 0.0, false, "no such variation: x, y", false}};
  const std::string path = testing::TempDir() + "promises.csv";
  const auto write = [&](const std::string& head, const std::string& more) {
    std::ofstream out(path);
    out << head << '\n';
    for (const PromiseRow& row : rows) out << csv_of(row) << '\n';
    out << more;
  };
  write(promises_header(), "");
  EXPECT_EQ(read_promises(path), rows);
  const auto complaint = [&] { return test_support::refusal<std::runtime_error>([&] { read_promises(path); }); };
  write("run,level", "");
  EXPECT_NE(complaint().find("another first line than run,level,promise"), std::string::npos) << complaint();
  write(promises_header(), "3,x,y\n");
  EXPECT_NE(complaint().find("line 4 is not a row"), std::string::npos) << complaint();
  write(promises_header(), promises_header() + "\n");  // a file with the header of each shard
  EXPECT_NE(complaint().find("line 4 is not a row"), std::string::npos) << complaint();
  std::filesystem::remove(path);
}

TEST(Validation, MeasuresARealLevel) {
  const std::vector<LevelFile> levels = {LevelFile(TEST_ASSETS "/levels/first_swing.tmj")};
  ValidationOptions options;
  options.runs = 1;
  options.promises = promises_of({.max_error_m = 10.0, .median_us = 1e9});
  options.ticks = 5;
  std::vector<PromiseRow> rows;
  validate_recommendations(levels, options, [&](const std::vector<PromiseRow>& some, double) { rows = some; });
  EXPECT_TRUE(rows.at(0).is_met) << csv_of(rows[0]);
  EXPECT_EQ(std::stoull(rows[0].level_hash, nullptr, 16), levels[0].hash());
  EXPECT_TRUE(rows.at(1).is_met) << csv_of(rows[1]);
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
  const auto with = file.with(Setting{"direct", "tr_bdf2", 2, 1e-5}).make_scene();
  const auto own = file.level().make_scene();
  EXPECT_EQ(with->coupling().cord(0).direct().def().points, own->coupling().cord(0).direct().def().points);
  EXPECT_EQ(with->coupling().cord(0).direct().def().mass_per_length,
            own->coupling().cord(0).direct().def().mass_per_length);
  EXPECT_EQ(with->coupling().cord(0).direct().def().accuracy.substeps, 2);
}

}  // namespace
}  // namespace study
