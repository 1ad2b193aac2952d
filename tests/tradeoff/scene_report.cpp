#include "tests/tradeoff/scene_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

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

bool is_cord(const std::string& method) { return method.starts_with("cord") || method == "held"; }

/// Of each experiment, with its name where there are several.
std::vector<std::string> who_is_ahead(const std::vector<Row>& rows, const std::vector<study::Point>& points) {
  std::map<std::string, std::vector<study::Point>> experiments;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    experiments[rows[k].contestant.experiment].push_back(points[k]);
  }
  std::vector<std::string> sentences;
  for (const auto& [name, own] : experiments) {
    for (const std::string& sentence : study::who_is_ahead(own, is_cord)) {
      std::string& told = sentences.emplace_back(sentence);
      if (experiments.size() > 1) told.insert(0, name + ": ");
    }
  }
  return sentences;
}

}  // namespace

study::Report report_of(const Scene& scene, const std::vector<Row>& rows) {
  const auto has = [&](const char* name) {
    return std::any_of(scene.columns.begin(), scene.columns.end(), [name](const Column& c) { return c.name == name; });
  };
  const char* error = has("rms_error_m") ? "rms_error_m" : "penetration_m";
  study::Report report;
  report.title = scene.name;
  report.notes = {scene.description + ". The error is " + error + "."};
  std::vector<const Column*> told;
  for (const Column& column : scene.columns) {
    if (column.name == "us_per_tick" || column.name == "p99_us") continue;
    told.push_back(&column);
    report.columns.push_back(column.name);
  }
  for (const Row& row : rows) {
    study::Point point{row.contestant.method, row.contestant.setting, row.timing.median_us, row.timing.p99_us};
    point.error_m = value_of(scene, row, error);
    if (value_of(scene, row, "unconverged") > 0.0) point.failure = "not converged";
    report.points.push_back(point);
    std::vector<std::string> cells;
    for (const Column* column : told) cells.push_back(text(column->value(row)));
    report.cells.push_back(std::move(cells));
  }
  for (std::string& sentence : who_is_ahead(rows, report.points)) report.notes.push_back(std::move(sentence));
  for (const char* name : {"own_error_m", "max_stretch_pct", "energy_drift_pct", "energy_gain_pct"}) {
    if (!has(name)) continue;
    study::Metric& metric = report.metrics.emplace_back();
    metric.name = name;
    for (const Row& row : rows) metric.values.push_back(std::abs(value_of(scene, row, name)));
  }
  return report;
}

}  // namespace tradeoff
