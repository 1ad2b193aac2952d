#include "tests/tradeoff/scene_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

// Conversion of a scene's figures to the points of its report.

namespace tradeoff {
namespace {

using Figures = std::map<std::string, double>;

/// Returns the report of a setting with these figures and no others.
study::Report report_of_one(const Figures& figures) {
  Scene scene;
  scene.name = "scene";
  scene.description = "something";
  scene.notes = {"A note."};
  Variant variant;
  variant.method = "cord";
  variant.setting = "fast";
  variant.group = "light";
  Row row{variant, {}, {}};
  for (const auto& [name, value] : figures) {
    scene.columns.push_back(figure(name, row.figures.size()));
    row.figures.push_back(value);
  }
  return report_of(scene, {row});
}

std::string failure_of(Figures figures) {
  figures["penetration_m"] = 1e-3;
  return report_of_one(figures).points.at(0).failure;
}

TEST(SceneReport, ARunWithoutFailuresCounts) {
  const Figures well = {{"blew_up", 0.0},   {"crossings", 0.0},   {"energy_gain_pct", 5.0},          {"tunnelled", 0.0},
                        {"corrected", 9.0}, {"unconverged", 0.0}, {"mutual_crossings", std::nan("")}};
  EXPECT_EQ(failure_of(well), "");
  const study::Report report = report_of_one(well);
  EXPECT_EQ(report.points.at(0).group, "light");
  EXPECT_EQ(report.notes.at(1), "A note.");
}

TEST(SceneReport, AFailedRunDoesNotCount) {
  EXPECT_EQ(failure_of({{"blew_up", 3.0}}), "blew up in tick 3");
  EXPECT_EQ(failure_of({{"energy_gain_pct", 101.0}}), "blew up: 101 % more energy");
  EXPECT_EQ(failure_of({{"tunnelled", 1.0}}), "tunnelling");
  EXPECT_EQ(failure_of({{"crossings", 1.0}, {"mutual_crossings", 2.0}}), "tunnelling: 3 crossings");
  EXPECT_EQ(failure_of({{"crossings", std::nan("")}, {"mutual_crossings", 2.0}}), "tunnelling: 2 crossings");
  EXPECT_EQ(failure_of({{"unconverged", 4.0}}), "not converged 4 times");
}

TEST(SceneReport, TheErrorIsThatOfPositionsOrOfDepth) {
  const study::Report report =
      report_of_one({{"penetration_m", 2e-9}, {"max_stretch_pct", -3.0}, {"jitter_m", 4.0}, {"cords_us", 5.0}});
  EXPECT_EQ(report.axis, "penetration_m");
  EXPECT_EQ(report.points.at(0).error_m, 1e-6);  // smaller depths count as a micrometre

  const study::Report swing = report_of_one({{"penetration_m", 0.1}, {"rms_error_m", 2e-9}});
  EXPECT_EQ(swing.axis, "rms_error_m");
  EXPECT_EQ(swing.points.at(0).error_m, 2e-9);
}

}  // namespace
}  // namespace tradeoff
