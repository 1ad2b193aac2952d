#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/baseline/check.h"
#include "tests/study/command.h"
#include "tests/study/guard.h"
#include "tests/study/report.h"
#include "tests/study/text.h"
#include "tests/tradeoff/modes.h"
#include "tests/tradeoff/run_scene.h"
#include "tests/tradeoff/scene_report.h"
#include "tests/tradeoff/scenes.h"
#include "tests/tradeoff/standard_report.h"
#include "tests/tradeoff/table.h"

namespace {

using tradeoff::Row;
using tradeoff::Scene;
using tradeoff::Variant;

void list_scenes() {
  for (const Scene& scene : tradeoff::scenes())
    std::printf("%-17s %s\n", scene.name.c_str(), scene.description.c_str());
}

#ifdef TRADEOFF_BOX2D_FROM_SOURCE
constexpr const char* box2d = "compiled from its sources with the flags of everything else here.";
#else
constexpr const char* box2d =
    "the library that Debian compiled: -O2, assertions on. Compiled with our own flags (TRADEOFF_BOX2D_SOURCE in "
    "tests/CMakeLists.txt) it gives the same bits at the same cost, within 3 %.";
#endif

int run_named_scene(const std::string& name, int repeats, bool csv, const std::string& folder) {
  const Scene* scene = tradeoff::find_scene(name);
  if (scene == nullptr) {
    std::fprintf(
        stderr, "tradeoff: %s; accepted are:\n",
        name.empty() ? "no --scene NAME and no --level FILE given" : ("no scene is named '" + name + "'").c_str());
    for (const Scene& known : tradeoff::scenes()) std::fprintf(stderr, "  %s\n", known.name.c_str());
    return 2;
  }
  if (!folder.empty()) study::require_folder(folder);
  const std::vector<Variant> variants = scene->variants();
  const std::vector<Row> rows = tradeoff::run_scene(*scene, variants, repeats);
  csv ? print_csv(*scene, rows) : print_table(*scene, rows);
  const study::Report report = tradeoff::report_of(*scene, rows);
  for (const std::string& note : report.notes) {
    if (!csv) std::printf("%s\n", note.c_str());
  }
  if (folder.empty()) return 0;
  study::write_report(report, folder);
  std::printf("report: %s/index.html\n", folder.c_str());
  return 0;
}

/// Returns a validator for a number above 0 with a unit: 1cm, 50us.
CLI::Validator measured_in(const std::map<std::string, double>& units) {
  std::string accepted;
  for (const auto& [unit, factor] : units) accepted.append(accepted.empty() ? "" : ", ").append(unit);
  const auto check = [units, accepted](std::string& text) -> std::string {
    const std::size_t end = text.find_first_not_of("0123456789.eE+-");
    const auto unit = units.find(end == std::string::npos ? "" : text.substr(end));
    double value = 0.0;
    if (unit == units.end() || !CLI::detail::lexical_cast(text.substr(0, end), value) || !(value > 0.0) ||
        !std::isfinite(value * unit->second)) {
      return text + " is not accepted; accepted is a number above 0 with a unit: " + accepted;
    }
    text = study::significant(value * unit->second, 17);
    return {};
  };
  return CLI::Validator(check, "NUMBER+UNIT");
}

std::string positive(const std::string& text) {
  double value = 0.0;
  if (CLI::detail::lexical_cast(text, value) && value > 0.0 && std::isfinite(value)) return {};
  return text + " is not accepted; accepted is a number above 0: 20000";
}

/// The arguments of the command line.
struct Arguments {
  bool list = false;
  bool report = false;
  bool accept = false;
  int repeats = 25;
  bool repeats_given = false;
  std::string scene;
  std::string table;  // of the baseline
  std::string guard;  // file of accepted levels
  std::string promises;
  study::Command study;
};

void add_level_options(CLI::App& app, study::Command& study) {
  auto* level = app.add_option("--level", study.levels, "A level (a name, or a .tmj file) instead of a scene")
                    ->allow_extra_args(false);
  app.add_option("--replay", study.replay, "Its recorded input; default: the replay of the same name in the assets")
      ->needs(level);
  app.add_flag("--quick", study.quick, "A small grid of a level; a report of fewer scenes too");
  app.add_option("--max-error", study.limits.max_error_m, "Recommend the cheapest setting with at most this error: 1cm")
      ->transform(measured_in({{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}));
  app.add_option("--budget", study.limits.median_us, "Recommend the most exact setting that costs at most this: 50us")
      ->transform(measured_in({{"us", 1.0}, {"ms", 1e3}}));
  app.add_option("--budget-p99", study.limits.p99_us, "The same for the 99th percentile of the ticks, by counted work")
      ->transform(measured_in({{"us", 1.0}, {"ms", 1e3}}));
  app.add_option("--budget-most", study.limits.most_us, "The same for the greatest tick, by counted work")
      ->transform(measured_in({{"us", 1.0}, {"ms", 1e3}}));
  app.add_option("--budget-work", study.limits.most_work,
                 "The same in counted work, which is the same on every machine: a number above 0, of the greatest tick")
      ->check(positive, "NUMBER");
  app.add_flag("--by-cord", study.by_cord,
               "Look for settings by cord, too: some cheaper than one setting for all. With --apply these are written. "
               "Without --level, or with several: a table of levels");
  app.add_flag("--apply", study.apply, "Write the recommended setting to the level")->needs(level);
  app.add_option(
         "--validate,--promises", study.validation_runs,
         "Validate recommendations in this many runs of each level: each varies it, recommends settings for one "
         "random input and measures them with another; all levels of the game, or those of --level, which may "
         "be repeated. --csv prints a row for each promise")
      ->check(CLI::Range(1, 10000));
  app.add_option("--players", study.validation_players,
                 "Beside --validate: try each recommendation with this many players, a run each; a divisor of the runs")
      ->check(CLI::Range(1, 10000));
  app.add_flag("--terms", study.terms, "Report which terms of its cords the level needs")->needs(level);
}

void add_options(CLI::App& app, Arguments& arguments) {
  app.add_flag("--list", arguments.list, "List the scenes");
  app.add_option("--scene", arguments.scene, "The scene to run");
  app.add_option_function<int>(
         "--repeats",
         [&arguments](int repeats) {
           arguments.repeats = repeats;
           arguments.repeats_given = true;
         },
         "Repeats to take the median of, unless given 25 of a scene, 9 of a level, 3 of a level with --quick, at most "
         "9 in "
         "a report, 1 in a quick one")
      ->check(CLI::Range(1, 100000));
  app.add_option("--out", arguments.study.folder, "A folder for the report: CSV, JSON, a plot and a page");
  add_level_options(app, arguments.study);
  app.add_flag("--report", arguments.report, "The standard report of scenes and levels, into --out");
  app.add_option("--baseline", arguments.table,
                 "Count the work of all scenes and recorded runs and compare it with this table");
  app.add_option("--check", arguments.guard,
                 "Compare the work and the error of levels, those of --level or of the file, with this file");
  app.add_option("--promises-of", arguments.promises,
                 "Count the promises that were kept in a file of --validate --csv");
  app.add_option_function<std::string>(
      "--shard", [&arguments](const std::string& text) { arguments.study.shard = study::shard_of(text); },
      "K/N: only the K-th of N parts of --validate, --check, --report or --by-cord");
  app.add_flag("--accept", arguments.accept, "Rewrite the table or the file instead");
  app.add_flag("--csv", arguments.study.csv,
               "Print rows of comma-separated values under a header, scene,method,setting,points,…");
}

std::vector<std::string> given_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() > 0) names.push_back(option->get_name());
  }
  return names;
}

/// Returns the exit status.
int run_study(Arguments& arguments) {
  study::Command& study = arguments.study;
  if (study.levels.size() > 1) {
    throw std::runtime_error(
        "--level is given more than once; accepted is that beside --validate, --check or --by-cord");
  }
  study.level = study.levels.front();
  if (study.apply && !study.limits.any()) {
    throw std::runtime_error("--apply needs to know what for; accepted is --max-error or --budget beside it");
  }
  if (arguments.repeats_given) study.repeats = arguments.repeats;
  return study::run(study);
}

/// Returns the exit status.
int run(Arguments& arguments) {
  const study::Command& study = arguments.study;
  if (arguments.list) {
    list_scenes();
    return 0;
  }
  if (!arguments.guard.empty()) {
    const study::Guard guard{arguments.guard, study.levels, study.replay, study.shard};
    if (arguments.accept && !study.shard.is_whole()) {
      throw std::runtime_error("--accept writes one file; accepted is --shard only without it");
    }
    if (guard.levels.size() > 1 && !guard.replay.empty()) {
      throw std::runtime_error("--replay is of one level; accepted is one --level beside it");
    }
    return arguments.accept ? study::accept(guard) : study::check(guard);
  }
  if (arguments.accept) {
    if (arguments.table.empty()) {
      throw std::runtime_error("--accept needs to know what; accepted is --baseline FILE or --check FILE beside it");
    }
    baseline::accept(tradeoff::scenes(), arguments.table);
    return 0;
  }
  if (!arguments.table.empty()) return baseline::check(tradeoff::scenes(), arguments.table);
  if (arguments.report) {
    const auto repeats = arguments.repeats_given ? std::optional(arguments.repeats) : std::nullopt;
    return tradeoff::write({study.folder, study.quick, repeats, study.shard});
  }
  if (study.validation_runs) return study::run(study);
  if (!arguments.promises.empty()) return study::summarise_promises(arguments.promises);
  if (study.by_cord && study.levels.size() != 1) return study::print_by_cord(study);
  if (!study.levels.empty()) return run_study(arguments);
  if (study.limits.any()) {
    throw std::runtime_error("--max-error and --budget need a level; accepted is --level or --validate beside them");
  }
  return run_named_scene(arguments.scene, arguments.repeats, study.csv, study.folder);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      std::string("Measures error against cost of cords: medians of interleaved repeats in one process, and the 99th "
                  "percentile of single ticks. Box2D is ") +
      box2d};
  Arguments arguments;
  add_options(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tradeoff: %s\n", error.what());
    return 2;
  }
  try {
    tradeoff::check_options(given_options(app));
    return run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tradeoff: %s\n", error.what());
    return 2;
  }
}
