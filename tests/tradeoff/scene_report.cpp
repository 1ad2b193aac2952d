#include "tests/tradeoff/scene_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace tradeoff {
namespace {

std::string text(double value) {
  if (std::isnan(value)) return {};
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
  return buffer.data();
}

double value_of(const Scene& scene, const Row& row, const char* name) {
  const auto found =
      std::find_if(scene.columns.begin(), scene.columns.end(), [name](const Column& c) { return c.name == name; });
  return found == scene.columns.end() ? std::nan("") : found->value(row);
}

}  // namespace

study::Report report_of(const Scene& scene, const std::vector<Row>& rows) {
  study::Report report;
  report.title = scene.name;
  report.notes = {scene.description + ". The error is rms_error_m, against the exact or converged motion."};
  for (const Column& column : scene.columns) {
    if (column.name != "us_per_tick" && column.name != "p99_us") report.columns.push_back(column.name);
  }
  for (const Row& row : rows) {
    study::Point point{row.contestant.method, row.contestant.setting, row.timing.median_us, row.timing.p99_us};
    point.error_m = value_of(scene, row, "rms_error_m");
    if (value_of(scene, row, "unconverged") > 0.0) point.failure = "not converged";
    report.points.push_back(point);
    std::vector<std::string> cells;
    for (const Column& column : scene.columns) {
      if (column.name != "us_per_tick" && column.name != "p99_us") cells.push_back(text(column.value(row)));
    }
    report.cells.push_back(std::move(cells));
  }
  return report;
}

}  // namespace tradeoff
