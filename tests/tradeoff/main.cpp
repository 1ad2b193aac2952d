#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/tradeoff/scenes.h"
#include "tests/tradeoff/table.h"

namespace {

using tradeoff::Contestant;
using tradeoff::Row;
using tradeoff::Scene;

void list_scenes() {
  for (const Scene& scene : tradeoff::scenes())
    std::printf("%-17s %s\n", scene.name.c_str(), scene.description.c_str());
}

/// On the terminal's error stream, so that a redirected table stays clean.
void show_progress(const char* what, double share) {
  constexpr int width = 40;
  const int full = static_cast<int>(share * width);
  std::fprintf(stderr, "\r%-7s [%s%s] %3.0f %%", what, std::string(static_cast<std::size_t>(full), '#').c_str(),
               std::string(static_cast<std::size_t>(width - full), '.').c_str(), 100.0 * share);
  if (share >= 1.0) std::fputc('\n', stderr);
}

std::vector<double> figures_of(const Contestant& contestant) {
  if (contestant.figures) return contestant.figures();
  contestant.tick();  // warm-up: what is allocated once is allocated here
  return {};
}

std::vector<Row> run_scene(const Scene& scene, const std::vector<Contestant>& contestants, int repeats) {
  std::vector<Row> rows;
  std::vector<tradeoff::Timed> timed;
  for (const Contestant& contestant : contestants) {
    rows.push_back({contestant, {}, figures_of(contestant)});
    timed.push_back({contestant.reset, contestant.tick, contestant.rest});
    show_progress("figures", static_cast<double>(rows.size()) / static_cast<double>(contestants.size()));
  }
  const auto timings =
      tradeoff::interleaved_timings(timed, scene.ticks, repeats, [](double share) { show_progress("timing", share); });
  for (std::size_t c = 0; c < rows.size(); ++c) rows[c].timing = timings[c];
  return rows;
}

#ifdef TRADEOFF_BOX2D_FROM_SOURCE
constexpr const char* box2d = "compiled from its sources with the flags of everything else here.";
#else
constexpr const char* box2d =
    "the library that Debian compiled: -O2, assertions on. Compiled with our own flags (TRADEOFF_BOX2D_SOURCE in "
    "tests/CMakeLists.txt) it gives the same bits at the same cost, within 3 %.";
#endif

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      std::string("Measures what a cord's accuracy costs: medians of interleaved repeats in one process, and the 99th "
                  "percentile of single ticks. Box2D is ") +
      box2d};
  bool list = false;
  bool csv = false;
  int repeats = 25;
  std::string name;
  app.add_flag("--list", list, "List the scenes");
  app.add_option("--scene", name, "The scene to run");
  app.add_option("--repeats", repeats, "Repeats to take the median of")->check(CLI::Range(1, 100000));
  app.add_flag("--csv", csv, "Print rows of comma-separated values under a header, scene,method,setting,points,…");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  if (list) {
    list_scenes();
    return 0;
  }
  const Scene* scene = tradeoff::find_scene(name);
  if (scene == nullptr) {
    std::fprintf(stderr, "tradeoff: %s; accepted are:\n",
                 name.empty() ? "no --scene NAME given" : ("no scene is named '" + name + "'").c_str());
    for (const Scene& known : tradeoff::scenes()) std::fprintf(stderr, "  %s\n", known.name.c_str());
    return 2;
  }
  const std::vector<Contestant> contestants = scene->contestants();
  const std::vector<Row> rows = run_scene(*scene, contestants, repeats);
  csv ? print_csv(*scene, rows) : print_table(*scene, rows);
  return 0;
}
