#include "tests/tradeoff/scene_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace tradeoff {
namespace {

constexpr double known_depth = 1e-6;  // m, below which differences are invisible

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

/// Returns why a setting does not count; empty if it counts.
std::string failure_of(const Scene& scene, const Row& row) {
  const double tick = value_of(scene, row, "blew_up");
  if (tick > 0.0) return "blew up in tick " + text(tick);
  const double energy = value_of(scene, row, "energy_gain_pct");
  if (energy > 100.0) return "blew up: " + text(energy) + " % more energy";
  if (value_of(scene, row, "tunnelled") > 0.0) return "tunnelling";
  const double own = value_of(scene, row, "crossings");
  const double mutual = value_of(scene, row, "mutual_crossings");
  const double crossings = (own > 0.0 ? own : 0.0) + (mutual > 0.0 ? mutual : 0.0);
  if (crossings > 0.0) return "tunnelling: " + text(crossings) + " crossings";
  const double unconverged = value_of(scene, row, "unconverged");
  if (unconverged > 0.0) return "not converged " + text(unconverged) + " times";
  return {};
}

}  // namespace

study::Report report_of(const Scene& scene, const std::vector<Row>& rows) {
  const auto has = [&](const char* name) {
    return std::any_of(scene.columns.begin(), scene.columns.end(), [name](const Column& c) { return c.name == name; });
  };
  const std::array errors = {"rms_error_m", "stretch_error_m", "creep_95pct_m", "penetration_m"};
  const char* error = *std::find_if(errors.begin(), errors.end() - 1, has);
  study::Report report;
  report.title = scene.name;
  report.axis = error;
  const bool is_depth = report.axis == "penetration_m";
  report.notes = {scene.description + ". The error is " + error + "."};
  if (is_depth) report.notes.front() += " Less than a micrometre counts as a micrometre.";
  report.notes.insert(report.notes.end(), scene.notes.begin(), scene.notes.end());
  std::vector<const Column*> reported;
  for (const Column& column : scene.columns) {
    if (column.name == "us_per_tick" || column.name == "p99_us") continue;
    reported.push_back(&column);
    report.columns.push_back(column.name);
  }
  for (const Row& row : rows) {
    study::Point point{row.variant.method, row.variant.setting, row.timing.median_us, row.timing.p99_us};
    point.error_m = is_depth ? std::max(value_of(scene, row, error), known_depth) : value_of(scene, row, error);
    point.group = row.variant.group;
    point.failure = failure_of(scene, row);
    report.points.push_back(point);
    std::vector<std::string> cells;
    for (const Column* column : reported) cells.push_back(text(column->value(row)));
    report.cells.push_back(std::move(cells));
  }
  for (std::string& sentence : study::compare_with_baselines(report.points, is_cord))
    report.notes.push_back(std::move(sentence));
  return report;
}

}  // namespace tradeoff
