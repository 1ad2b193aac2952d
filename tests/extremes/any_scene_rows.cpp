// Random scenes as a group of the table of extremes.

#include <array>
#include <limits>
#include <vector>

#include "tests/extremes/any_scene/runs.h"
#include "tests/extremes/table.h"

namespace extremes {
namespace {

using any_scene::Summary;

constexpr double no_limit = 1e300;  // reported, not bounded

/// A figure of a run, and its upper bound.
struct Figure {
  const char* name;
  double (*value)(const Summary& run);
  double limit = no_limit;
};
/// A run that timed out counts as completed: it only exceeded its time on this machine.
bool has_completed(any_scene::End end) { return end == any_scene::End::completed || end == any_scene::End::timed_out; }

constexpr std::array figures = {
    Figure{"Newton steps in a tick", [](const Summary& run) { return static_cast<double>(run.max_work); }, 400.0},
    Figure{"unconverged substeps", [](const Summary& run) { return static_cast<double>(run.unconverged); }},
    Figure{"ticks with a crossing", [](const Summary& run) { return static_cast<double>(all_crossings(run)); }},
    Figure{"corners turned inside out", [](const Summary& run) { return static_cast<double>(run.inverted); }},
    Figure{"stretch", [](const Summary& run) { return run.stretch; }},
    Figure{"rise of energy, relative", [](const Summary& run) { return run.rise; }},
    Figure{"gap of a grip, m", [](const Summary& run) { return run.gap; }},
    Figure{"runs that crashed or broke", [](const Summary& run) { return has_completed(run.end) ? 0.0 : 1.0; }, 0.0},
};

Method method_of(any_scene::Preset preset) { return static_cast<Method>(preset); }

std::vector<any_scene::SceneId> scenes(const Scope& scope) {
  constexpr unsigned few = 100;
  constexpr unsigned many = 10'000;
  std::vector<any_scene::SceneId> all;
  for (unsigned seed = 0; seed < (scope.full ? many : few); ++seed) {
    const any_scene::Family family = any_scene::all_families[seed % any_scene::all_families.size()];
    all.push_back({seed, family, any_scene::Difficulty::gentle, {}});
  }
  return all;
}

}  // namespace

std::vector<Row> run_any_scene(const Scope& scope) {
  std::vector<WorstCase> worst;
  for (const Method method : {Method::fast, Method::balanced, Method::accurate}) {
    for (const Figure& figure : figures) worst.emplace_back("any scene", figure.name, method, figure.limit);
  }
  const std::vector<any_scene::SceneId> all = scenes(scope);
  double done = 0.0;
  any_scene::RunOptions options;
  if (!scope.full) options.max_seconds = 5.0;
  any_scene::run_all(all, options, [&](const Summary& run) {
    const std::string setting = std::string(name(run.which.family)) + ", seed " + std::to_string(run.which.seed);
    for (std::size_t k = 0; k < worst.size() && scope.wants(setting); ++k) {
      if (worst[k].row().method != method_of(run.preset)) continue;
      worst[k].take(figures[k % figures.size()].value(run), setting);
    }
    scope.progress(++done / static_cast<double>(all.size()));
  });
  std::vector<Row> rows;
  for (const WorstCase& figure : worst) rows.push_back(figure.row());
  return rows;
}

}  // namespace extremes
