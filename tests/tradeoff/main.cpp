#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/tradeoff/scenes.h"

namespace {

using tradeoff::Contestant;
using tradeoff::Scene;

void list_scenes() {
  for (const Scene& scene : tradeoff::scenes())
    std::printf("%-12s %s\n", scene.name.c_str(), scene.description.c_str());
}

/// On the terminal's error stream, so that a redirected table stays clean.
void show_progress(double share) {
  constexpr int width = 40;
  const int full = static_cast<int>(share * width);
  std::fprintf(stderr, "\r[%s%s] %3.0f %%", std::string(static_cast<std::size_t>(full), '#').c_str(),
               std::string(static_cast<std::size_t>(width - full), '.').c_str(), 100.0 * share);
  if (share >= 1.0) std::fputc('\n', stderr);
}

void print_rows(const Scene& scene, const std::vector<Contestant>& contestants, const std::vector<double>& spent,
                bool csv) {
  if (csv) {
    std::puts("scene,method,setting,points,us_per_tick,frames_per_second");
  } else {
    std::printf("%-12s %-14s %-12s %7s %12s %12s %12s %10s\n", "scene", "method", "setting", "points", "us a tick",
                "frames/s", "ns a point", "x first");
  }
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    const Contestant& row = contestants[c];
    const double us = spent[c];
    if (csv) {
      std::printf("%s,%s,%s,%d,%.3f,%.1f\n", scene.name.c_str(), row.method.c_str(), row.setting.c_str(), row.points,
                  us, 1e6 / us);
    } else {
      std::printf("%-12s %-14s %-12s %7d %12.2f %12.1f %12.1f %10.2f\n", scene.name.c_str(), row.method.c_str(),
                  row.setting.c_str(), row.points, us, 1e6 / us, 1e3 * us / row.points, us / spent[0]);
    }
  }
}

void run_scene(const Scene& scene, int repeats, bool csv) {
  const std::vector<Contestant> contestants = scene.contestants();
  std::vector<tradeoff::Tick> ticks;
  for (const Contestant& contestant : contestants) {
    contestant.tick();  // warm-up: what is allocated once is allocated here
    ticks.push_back(contestant.tick);
  }
  print_rows(scene, contestants, tradeoff::interleaved_medians(ticks, scene.ticks, repeats, show_progress), csv);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Measures what a cord's accuracy costs, as medians of interleaved repeats in one process."};
  bool list = false;
  bool csv = false;
  int repeats = 25;
  std::string name;
  app.add_flag("--list", list, "List the scenes");
  app.add_option("--scene", name, "The scene to run");
  app.add_option("--repeats", repeats, "Repeats to take the median of")->check(CLI::Range(1, 100000));
  app.add_flag("--csv", csv, "Print rows scene,method,setting,points,us_per_tick,frames_per_second");
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
  run_scene(*scene, repeats, csv);
  return 0;
}
