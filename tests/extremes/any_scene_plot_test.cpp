#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/extremes/any_scene/plot.h"
#include "tests/extremes/any_scene/statistics.h"

namespace any_scene {
namespace {

/// Returns four ticks of 0 to 200 linear systems; one has a residual of 1 cm.
Summary some_run(Preset preset) {
  Summary run;
  run.preset = preset;
  run.ticks = 4;
  run.work = {{0, 1}, {3, 2}, {200, 1}};
  run.left = std::map<int, int>{{bin_of(0.01), 1}};
  run.stretch = 0.02;
  return run;
}

/// Returns the same for a solver that does not report residuals; its stretch stays below 1 %.
Summary run_before(Preset preset) {
  Summary run = some_run(preset);
  run.left.reset();
  run.unconverged = 7;
  run.work[5000] = 4;
  run.ticks = 8;
  run.stretch = 5e-3;
  return run;
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(AnyScenePlot, BarsAreSharesOfTicks) {
  const std::string text = plot_of({some_run(Preset::fast), some_run(Preset::fast)}, {}, "some.svg");
  // Eight ticks, with the axis at half a tick: a quarter take 0, half take 3, a quarter take 189 to 235.
  expect_part(text,
              "$work_fast_now << END\n"
              "0.25 0.0625\n0.25 0.25\n0.5 0.25\n0.5 0.0625\n"
              "2.5 0.0625\n2.5 0.5\n3.5 0.5\n3.5 0.0625\n"
              "188.5 0.0625\n188.5 0.25\n235.5 0.25\n235.5 0.0625\nEND\n");
  expect_part(text, "$left_fast_now << END\n0.00562341 0.0625\n0.00562341 0.25\n0.01 0.25\n0.01 0.0625\nEND\n");
  expect_part(text, "'now: 99.9 % of ticks up to 200, most 200'");
  expect_part(text, "'now: 25 % of ticks unsolved'");
  expect_part(text, "'now: 2 of 2 scenes above 1 %'");
  expect_part(text, "set output 'some.svg'");
  EXPECT_EQ(text.find("before"), std::string::npos) << text;
}

TEST(AnyScenePlot, DrawsEarlierRunsBehind) {
  const std::string text = plot_of({some_run(Preset::balanced)}, {run_before(Preset::balanced)}, "some.svg");
  expect_part(text, "'before: 99.9 % of ticks up to 5000, most 5000'");
  expect_part(text, "'before: 7 substeps unsolved, residual not reported'");
  expect_part(text, "'before: 0 of 1 scenes above 1 %'");
  expect_part(text, "plot NaN notitle, $work_balanced_before using");
  EXPECT_LT(text.find("$work_balanced_before using"), text.find("$work_balanced_now using"));
  EXPECT_EQ(text.find("$left_balanced_before"), std::string::npos) << text;
  EXPECT_EQ(text.find("$work_fast"), std::string::npos) << text;
}

TEST(AnyScenePlot, BinsOfWorkAreContiguous) {
  for (int work = 0; work <= 8; ++work) EXPECT_EQ(end_of_work_bin(work), work);
  for (int work = 1; work < 1000; ++work) {
    const int end = end_of_work_bin(work);
    EXPECT_GE(end, work);
    EXPECT_LE(end, work + work / 4);
    EXPECT_EQ(end_of_work_bin(end), end);
    EXPECT_GT(end_of_work_bin(end + 1), end);
  }
}

TEST(AnyScenePlot, IsWrittenToAFileOrRefused) {
  const std::string path = testing::TempDir() + "any_scene's plot.svg";
  std::filesystem::remove(path);
  draw({some_run(Preset::fast), some_run(Preset::accurate)}, {run_before(Preset::accurate)}, path);
  std::stringstream drawn;
  drawn << std::ifstream(path).rdbuf();
  expect_part(drawn.str(), "25 % of ticks unsolved");
  expect_part(drawn.str(), "</svg>");
  EXPECT_THROW(draw({some_run(Preset::fast)}, {}, "/nowhere/plot.svg"), std::runtime_error);
}

}  // namespace
}  // namespace any_scene
