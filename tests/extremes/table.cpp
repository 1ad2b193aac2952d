#include "tests/extremes/table.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace extremes {

Worst::Worst(std::string what, std::string figure, Method method, double bar) {
  row_.what = std::move(what);
  row_.figure = std::move(figure);
  row_.method = method;
  row_.bar = bar;
}

void Worst::take(double value, std::string_view setting) {
  ++row_.cases;
  if (row_.cases > 1 && (value <= row_.worst || std::isnan(row_.worst))) return;
  row_.worst = value;
  row_.setting = setting;
}

const std::vector<Group>& groups() {
  static const std::vector<Group> all = {
      {"sweep", "every length, width, load, stiffness and step", run_sweep},
      {"starts", "from where no motion leads", run_starts},
      {"drives", "anchors, lengths and gravity that change as nothing does", run_drives},
      {"crush", "circles that nothing stops, or that are born where the cord is", run_crush},
      {"degenerate", "points without a distance, lengths that are refused", run_degenerate},
      {"places", "the same motion elsewhere", run_places},
      {"soak", "a lively scene that goes on and on", run_soak},
  };
  return all;
}

void print_rows(const std::vector<Row>& rows) {
  std::printf("%-34s %-8s %6s  %-26s %10s %8s  %-4s %8s %5s %5s %5s %5s %6s  %s\n", "what", "method", "cases", "figure",
              "worst", "bar", "", "newton", "srch", "fall", "gain", "halv", "unconv", "worst at");
  for (const Row& row : rows) {
    std::printf("%-34s %-8.*s %6d  %-26s %10.3g %8.2g  %-4s ", row.what.c_str(),
                static_cast<int>(name(row.method).size()), name(row.method).data(), row.cases, row.figure.c_str(),
                row.worst, row.bar,
                row.passed() ? "ok"
                : row.held() ? "FAIL"
                             : "lost");
    const ribbon::CordReport& direct = row.counts.direct;
    const ribbon::StepReport& thesis = row.counts.thesis;
    if (row.method == Method::thesis) {
      std::printf("fem skipped %d, held back %d, tangled %d", thesis.fem_skipped, thesis.motion_limited,
                  thesis.tangled_columns);
    } else {
      std::printf("%8d %5d %5d %5d %5d %6d", direct.iterations, direct.searches, direct.fallbacks, direct.energy_gains,
                  direct.halvings, direct.unconverged);
    }
    std::printf("  %s\n", row.setting.c_str());
  }
}

}  // namespace extremes
