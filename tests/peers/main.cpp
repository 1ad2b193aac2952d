#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tests/peers/table.h"
#include "tests/peers/variants.h"
#include "tests/study/progress_bar.h"
#include "tests/study/report.h"
#include "tests/study/text.h"
#include "tests/tradeoff/measure.h"

namespace {

using peers::Result;
using peers::Scene;
using peers::Variant;

std::vector<double> times_of(const peers::Recording& recording) {
  std::vector<double> times;
  for (const peers::Frame& frame : recording) times.push_back(frame.us);
  return times;
}

/// The runs of a setting in a scene: figures of the first one, times of all.
struct Runs {
  Result result;
  std::vector<double> medians;
  std::vector<double> p99s;
  bool is_slow = false;  ///< then it is not repeated
};

constexpr double long_seconds = 20.0;

void run_once(const Scene& scene, const peers::Plan& plan, const Variant& variant, Runs& runs) {
  if (!runs.result.failure.empty() || runs.is_slow) return;
  try {
    const auto start = std::chrono::steady_clock::now();
    const peers::Recording recording = variant.run(scene, plan);
    runs.is_slow = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > long_seconds;
    const std::vector<double> times = times_of(recording);
    runs.medians.push_back(tradeoff::quantile(times, 0.5));
    runs.p99s.push_back(tradeoff::quantile(times, 0.99));
    if (runs.medians.size() > 1) return;
    runs.result.figures = peers::figures_of(scene.set_up, plan, recording);
    if (runs.result.figures.blew_up > 0) {
      runs.result.failure = "blew up in tick " + std::to_string(runs.result.figures.blew_up);
    } else if (recording.size() != static_cast<std::size_t>(plan.ticks)) {
      runs.result.failure = "ended after " + study::count_of(static_cast<int>(recording.size()), "tick");
    } else if (runs.result.figures.tunnelled && scene.name == "bridge") {
      runs.result.failure = "tunnelled: the ball is below the cord";
    } else {
      runs.result.error_m = scene.error(runs.result.figures, recording);
    }
  } catch (const std::runtime_error& error) {
    runs.result.failure = error.what();
    std::replace(runs.result.failure.begin(), runs.result.failure.end(), ',', ';');
  }
}

/// Interleaves all settings, so that a slow moment of a shared machine affects all of them alike.
std::vector<Result> run_scene(const Scene& scene, const std::vector<Variant>& variants, int rounds) {
  const peers::Plan plan = peers::plan_of(scene.set_up, scene.settling_ticks, scene.ticks);
  std::vector<Runs> runs(variants.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < variants.size(); ++k) {
      const double done = static_cast<double>(static_cast<std::size_t>(round) * variants.size() + k);
      study::show_progress((scene.name + " " + scene.group).c_str(),
                           done / static_cast<double>(variants.size() * static_cast<std::size_t>(rounds)));
      run_once(scene, plan, variants[k], runs[k]);
    }
  }
  study::show_progress((scene.name + " " + scene.group).c_str(), 1.0);
  std::vector<Result> results;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    Result result = runs[k].result;
    result.engine = variants[k].engine;
    result.setting = variants[k].setting;
    result.group = scene.group;
    if (!runs[k].medians.empty()) {
      result.cost_us = tradeoff::quantile(runs[k].medians, 0.5);
      result.p99_us = tradeoff::quantile(runs[k].p99s, 0.5);
    }
    results.push_back(result);
  }
  return results;
}

struct Options {
  std::string folder;
  std::string script;
  std::vector<std::string> only;
  int rounds = 3;
  bool quick = false;
};

int run(const Options& options) {
  std::filesystem::create_directories(options.folder);
  const peers::NodeRunner node(options.script, options.folder);
  const std::vector<peers::Engine> engines = peers::engines(node);
  std::vector<std::string> names;  // of scenes, unique
  std::map<std::string, std::vector<Result>> results;
  for (const Scene& scene : peers::scenes()) {
    if (!options.only.empty() && std::find(options.only.begin(), options.only.end(), scene.name) == options.only.end())
      continue;
    if (names.empty() || names.back() != scene.name) names.push_back(scene.name);
    const std::vector<Result> more = run_scene(scene, peers::variants(scene, node, options.quick), options.rounds);
    std::vector<Result>& all = results[scene.name];
    all.insert(all.end(), more.begin(), more.end());
  }
  std::ofstream(options.folder + "/peers.csv") << peers::csv_of(names, results);
  std::ofstream(options.folder + "/table.md") << peers::table_of(engines, names, results);
  std::fputs(peers::csv_of(names, results).c_str(), stdout);
  for (const std::string& name : names) {
    study::write_report(peers::report_of(name, engines, results[name]), options.folder + "/" + name);
  }
  for (const char* scratch : {"/plan.json", "/recording", "/node.log"}) {
    std::filesystem::remove(options.folder + scratch);
  }
  std::printf("written: %s\n", options.folder.c_str());
  return 0;
}

}  // namespace

/// Returns 0 on success, 1 if a plot or a file could not be written, 2 for a bad argument.
int main(int argc, char** argv) {
  CLI::App app{"Our cords and other engines' ropes in the same scenes, by the same measures"};
  Options options;
  std::vector<std::string> names;
  for (const Scene& scene : peers::scenes()) {
    if (names.empty() || names.back() != scene.name) names.push_back(scene.name);
  }
  app.add_option("--out", options.folder, "A folder for CSV, plots and the table")->required();
  app.add_option("--script", options.script, "tests/peers/run_plan.mjs, beside its node_modules")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--scene", options.only, "These scenes alone")->check(CLI::IsMember(names));
  app.add_option("--rounds", options.rounds, "Times that all settings take turns; costs are medians of them")
      ->check(CLI::Range(1, 99));
  app.add_flag("--quick", options.quick, "One setting of each engine");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peers: %s\n", error.what());
    return 1;
  }
}
