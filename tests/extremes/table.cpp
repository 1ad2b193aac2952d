#include "tests/extremes/table.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace extremes {

WorstCase::WorstCase(std::string what, std::string figure, Method method, double limit) {
  row_.what = std::move(what);
  row_.figure = std::move(figure);
  row_.method = method;
  row_.limit = limit;
}

void WorstCase::take(double value, std::string_view setting, std::string_view how) {
  ++row_.cases;
  if (row_.cases > 1 && (value <= row_.worst || std::isnan(row_.worst))) return;
  row_.worst = value;
  row_.setting = setting;
  row_.how = std::isfinite(value) ? how : "diverged";
}

bool Row::is_reported() const {
  const ribbon::IslandReport& direct = counts.direct;
  const ribbon::StepReport& thesis = counts.thesis;
  return direct.unconverged > 0 || thesis.fem_skipped > 0 || thesis.motion_limited > 0 || thesis.tangled_columns > 0 ||
         thesis.strained_bars > 0 || thesis.turned_over > 0 || thesis.energy_gains > 0;
}

const std::vector<Group>& groups() {
  static const std::vector<Group> all = {
      {"sweep", "every length, width, load, stiffness and step", run_sweep},
      {"starts", "initial states that no motion reaches", run_starts},
      {"drives", "anchors, lengths and gravity that change suddenly", run_drives},
      {"crush", "kinematic circles that squeeze a cord, and circles created inside one", run_crush},
      {"degenerate", "coincident points, and lengths that are refused", run_degenerate},
      {"places", "the same motion elsewhere", run_places},
      {"soak", "a moving scene for many ticks", run_soak},
      {"any_scene", "random scenes with any combination of features; without limits", run_any_scene},
  };
  return all;
}

std::string verdict(const Row& row) {
  if (row.passed()) return "ok";
  return (row.is_required() ? "FAIL: " : "allowed: ") + (row.how.empty() ? "not converged" : row.how);
}

void print_rows(const std::vector<Row>& rows) {
  std::printf("%-34s %-8s %6s  %-26s %10s %8s  %-18s %8s %5s %5s %5s %5s %6s  %s\n", "what", "method", "cases",
              "figure", "worst", "limit", "", "newton", "srch", "fall", "gain", "halv", "unconv", "worst at");
  for (const Row& row : rows) {
    if (row.cases == 0) continue;
    std::printf("%-34s %-8.*s %6d  %-26s %10.3g %8.2g  %-18s ", row.what.c_str(),
                static_cast<int>(name(row.method).size()), name(row.method).data(), row.cases, row.figure.c_str(),
                row.worst, row.limit, verdict(row).c_str());
    const ribbon::IslandReport& direct = row.counts.direct;
    const ribbon::StepReport& thesis = row.counts.thesis;
    if (row.method == Method::thesis) {
      std::printf("motion limited %d, strained %d, turned over %d, tangled %d, gains %d, FEM skipped %d",
                  thesis.motion_limited, thesis.strained_bars, thesis.turned_over, thesis.tangled_columns,
                  thesis.energy_gains, thesis.fem_skipped);
    } else {
      std::printf("%8d %5d %5d %5d %5d %6d", direct.iterations, direct.searches, direct.fallbacks, direct.energy_gains,
                  direct.halvings, direct.unconverged);
    }
    std::printf("  %s\n", row.setting.c_str());
  }
}

}  // namespace extremes
