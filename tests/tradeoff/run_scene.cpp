#include "tests/tradeoff/run_scene.h"

#include "tests/study/progress_bar.h"

namespace tradeoff {
namespace {

using study::show_progress;

std::vector<double> figures_of(const Contestant& contestant) {
  if (contestant.figures) return contestant.figures();
  contestant.tick();  // warm-up: what is allocated once is allocated here
  return {};
}

}  // namespace

std::vector<Row> run_scene(const Scene& scene, const std::vector<Contestant>& contestants, int repeats) {
  std::vector<Row> rows;
  std::vector<Timed> timed;
  for (const Contestant& contestant : contestants) {
    rows.push_back({contestant, {}, figures_of(contestant)});
    timed.push_back({contestant.reset, contestant.tick, contestant.rest});
    show_progress("figures", static_cast<double>(rows.size()) / static_cast<double>(contestants.size()));
  }
  const auto timings =
      interleaved_timings(timed, scene.ticks, repeats, [](double share) { show_progress("timing", share); });
  for (std::size_t c = 0; c < rows.size(); ++c) rows[c].timing = timings[c];
  return rows;
}

}  // namespace tradeoff
