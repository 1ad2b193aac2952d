#include "tests/tradeoff/run_scene.h"

#include "tests/study/progress_bar.h"

namespace tradeoff {
namespace {

using study::show_progress;

std::vector<double> figures_of(const Variant& variant) {
  if (variant.figures) return variant.figures();
  variant.tick();  // warm-up: what is allocated once is allocated here
  return {};
}

}  // namespace

std::vector<Row> run_scene(const Scene& scene, const std::vector<Variant>& variants, int repeats) {
  std::vector<Row> rows;
  std::vector<Timed> timed;
  for (const Variant& variant : variants) {
    rows.push_back({variant, {}, figures_of(variant)});
    timed.push_back({variant.reset, variant.tick, variant.rest});
    show_progress("figures", static_cast<double>(rows.size()) / static_cast<double>(variants.size()));
  }
  const auto timings =
      interleaved_timings(timed, scene.ticks, repeats, [](double share) { show_progress("timing", share); });
  for (std::size_t c = 0; c < rows.size(); ++c) rows[c].timing = timings[c];
  return rows;
}

}  // namespace tradeoff
