#include "tests/study/command.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "tests/study/cord_search.h"
#include "tests/study/level_report.h"
#include "tests/study/level_study.h"
#include "tests/study/progress_bar.h"
#include "tests/study/terms.h"
#include "tests/study/text.h"
#include "tests/study/validation.h"

namespace study {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/) { interrupted = 1; }

std::string recording_of(const LevelFile& file) {
  return game::assets_folder() + "/replays/" + std::filesystem::path(file.path()).stem().string() + ".replay";
}

}  // namespace

std::string replay_of(const Command& command, const LevelFile& file) {
  if (!command.replay.empty()) return command.replay;
  std::string path = recording_of(file);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw std::runtime_error("no --replay given, and there is no " + path + "; record one: ropeswing --level " +
                             file.path() + " --record FILE");
  }
  return path;
}

namespace {

void print_table(const Report& report) {
  const std::vector<std::size_t> on_front = front(report.points);
  std::printf("%-18s %-44s %10s %10s %10s\n", "method", "setting", "us_a_tick", "p99_us", "error_m");
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    const bool best = std::find(on_front.begin(), on_front.end(), k) != on_front.end();
    std::printf("%-18s %-44s %10.2f %10.2f %10s%s\n", p.method.c_str(), p.setting.c_str(), p.cost_us, p.p99_us,
                p.failure.empty() ? significant(p.error_m, 3).c_str() : p.failure.c_str(), best ? "  front" : "");
  }
}

void print_calibration(const Calibration& calibration) {
  std::printf(
      "calibration: a tick takes %s us, and 1000 units of counted work %s us on this machine; rank correlation of "
      "time and work over the settings %s\n",
      significant(calibration.base_us, 3).c_str(), significant(1e3 * calibration.us_per_work, 3).c_str(),
      significant(calibration.rank_correlation, 3).c_str());
}

/// Returns false if no setting meets the request.
bool recommend(const Command& command, const LevelFile& file, const Study& study) {
  const Limits& limits = command.limits;
  if (!limits.any()) return true;
  const Calibration calibration = calibrate(study);
  const Choice choice = choose(study, limits, calibration);
  if (!choice.setting) {
    std::printf("no setting of the grid meets %s with the margin of a recommendation\n", in_words(limits).c_str());
    if (choice.nearest) {
      std::printf("nearest: %s; that is %s times what a recommendation may use\n",
                  in_words(study, *choice.nearest, calibration, limits).c_str(), significant(choice.excess, 3).c_str());
    }
    return false;
  }
  const Measured& m = study.settings[*choice.setting];
  const WorkFigures work = largest_work(m);
  std::printf("recommended: %s", in_words(study, *choice.setting, calibration, limits).c_str());
  const auto add = [](const char* limit, const std::optional<double>& most, double value) {
    if (most) std::printf(", %.0f %% below the limit of %s", 100.0 * (1.0 - value / *most), limit);
  };
  add("the error", limits.max_error_m, applicable(study)[*choice.setting].error_m);
  add("the median", limits.median_us, m.cost_us);
  add("the 99th percentile", limits.p99_us, calibration.us(work.p99));
  add("the greatest tick", limits.most_us, calibration.us(work.most));
  add("work", limits.most_work, work.most);
  std::putchar('\n');
  if (study.by_cord) std::printf("by cord: %s\n", in_words(*study.by_cord, file).c_str());
  if (command.by_cord && !study.by_cord) std::puts("by cord: nothing is cheaper than the setting above");
  if (command.apply) {
    file.apply(study.by_cord ? study.by_cord->settings : recommended_for(limits, m));
    std::printf("written to %s; its recordings must be made again\n", file.path().c_str());
  }
  return true;
}

void print_tally(const std::string& promise, const std::string& level, const Tally& tally) {
  std::printf("%-16s %-24s met by %d of %d recommended settings with another input", promise.c_str(),
              level.empty() ? "all levels" : level.c_str(), tally.met, tally.recommended);
  if (tally.recommended > 0) std::printf(" (%.1f %%)", 100.0 * tally.met / tally.recommended);
  if (tally.not_found > 0) std::printf("; in %d more runs no setting was recommended", tally.not_found);
  std::putchar('\n');
}

void print_tallies(const std::vector<PromiseRow>& rows) {
  for (const auto& [promise, by_level] : tallies_of(rows)) {
    for (const auto& [level, tally] : by_level) {
      if (!level.empty() || by_level.size() > 2) print_tally(promise, level, tally);
    }
  }
}

/// Returns the first seconds of a level's recorded run; nothing without one.
Inputs start_of_recording(const LevelFile& level) {
  constexpr std::size_t ticks = 240;
  const std::string path = recording_of(level);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return {};
  Inputs inputs = inputs_of(engine::load_replay(path));
  inputs.resize(std::min(inputs.size(), ticks));
  return inputs;
}

/// Returns those of the command, or all of the game.
std::vector<LevelFile> levels_of(const Command& command) {
  const std::vector<std::string> names = command.levels.empty() ? game::level_names() : command.levels;
  if (names.empty()) throw std::runtime_error("there is no level in " + game::assets_folder() + "/levels");
  return {names.begin(), names.end()};
}

/// Verifies recommendations for the requested limits. With csv the rows go to the output as they come.
int print_validation(const Command& command) {
  const std::vector<LevelFile> levels = levels_of(command);
  ValidationOptions options;
  options.promises = promises_of(command.limits);
  options.runs = *command.validation_runs;
  options.players = command.validation_players;
  for (const LevelFile& level : levels) options.recorded.push_back(start_of_recording(level));
  options.shard = command.shard;
  std::vector<PromiseRow> all;
  if (command.csv && options.shard.is_first()) std::printf("%s\n", promises_header().c_str());
  validate_recommendations(levels, options, [&](const std::vector<PromiseRow>& rows, double share) {
    all.insert(all.end(), rows.begin(), rows.end());
    for (const PromiseRow& row : rows) {
      if (command.csv) std::printf("%s\n", csv_of(row).c_str());
    }
    std::fflush(stdout);
    show_progress("runs", share);
  });
  if (command.csv) return 0;
  for (const PromiseRow& row : all) {
    if (!row.setting.empty() && !row.is_met) std::printf("violation: %s\n", csv_of(row).c_str());
  }
  print_tallies(all);
  return 0;
}

int print_terms(const LevelFile& file, const std::string& replay) {
  const Terms terms = try_terms(file, replay, [](double share) { show_progress("terms", share); });
  std::printf(
      "Compared for %.2f s; after that the motion is too sensitive: 4 mm/s more or less move something by 1 cm.\n",
      static_cast<double>(terms.ticks) / 60.0);
  for (const bool declared : {true, false}) {
    std::puts(declared ? "Without each declared term:" : "With each undeclared term that has a natural value:");
    for (const TermResult& result : terms.results) {
      if (result.declared != declared) continue;
      const std::string cost = std::isnan(result.cost_share) ? "-" : fixed(result.cost_share, 2) + "x";
      std::printf("%-18s cost %6s  %s\n", result.term.c_str(), cost.c_str(), verdict(result).c_str());
    }
  }
  for (const Symptom& symptom : terms.missing) {
    std::printf("%-18s MAY BE MISSING: %s, first in tick %zu, in %zu ticks\n", symptom.term.c_str(),
                symptom.what.c_str(), symptom.first_tick, symptom.ticks);
  }
  if (terms.missing.empty()) std::puts("no motion was found that an undeclared term would prevent");
  return 0;
}

void print_grid(const std::vector<Setting>& all) {
  std::printf("%zu settings:\n", all.size());
  for (const Setting& setting : all) std::printf("  %-18s %s\n", setting.solver.c_str(), name_of(setting).c_str());
  std::fflush(stdout);
}

}  // namespace

int summarise_promises(const std::string& path) {
  std::vector<PromiseRow> rows = read_promises(path);
  print_tallies(rows);
  for (PromiseRow& row : rows) row.promise = "all promises";
  print_tallies(rows);
  return 0;
}

namespace {

void print_bound(const std::string& level, std::size_t cords, const CordBound& bound,
                 const std::optional<ByCord>& found) {
  const auto known = [](double value, int decimals) { return std::isnan(value) ? "-" : fixed(value, decimals); };
  std::printf("%-20s %5zu  %-38s %10s %10s %8s %8s\n", level.c_str(), cords,
              bound.common.empty() ? (cords < 2 ? "-" : "none") : bound.common.c_str(),
              known(bound.common_work, 0).c_str(), known(bound.least_work, 0).c_str(),
              known(bound.most_gain, 2).c_str(),
              found ? fixed(found->common_work / found->outcome.work, 2).c_str() : "-");
  std::fflush(stdout);
}

}  // namespace

int print_by_cord(const Command& command) {
  const double error = command.limits.max_error_m.value_or(default_error);
  StudyOptions options;
  options.quick = true;
  options.repeats = 1;
  options.grid = own_settings();
  options.by_cord_error_m = error;
  const std::vector<LevelFile> levels = levels_of(command);
  if (command.shard.is_first())
    std::printf("%-20s %5s  %-38s %10s %10s %8s %8s\n", "level", "cords", "one setting for all", "work/tick", "least",
                "at most", "by cord");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (!command.shard.has(k, levels.size())) continue;
    const LevelFile& level = levels[k];
    const std::size_t cords = cord_objects_of(level.level()).size();
    if (cords < 2) {  // there is nothing to choose
      print_bound(level.level().name, cords, {{}, unavailable, unavailable, 1.0}, std::nullopt);
      continue;
    }
    options.others = players_that_meet_cords(level.level(), 0, judging_players);
    options.by_cord_progress = [](double share) { show_progress("by cord", share); };
    options.progress = [](double share, double left) { show_progress("study", share, left); };
    const Study study = measure(level, replay_of(command, level), options);
    print_bound(level.level().name, cords, bound_of(study, usable_error_share * error, cords), study.by_cord);
  }
  return 0;
}

namespace {

StudyOptions options_of(const Command& command, const LevelFile& file) {
  StudyOptions options;
  options.others = players_that_meet_cords(file.level(), 0, judging_players);
  options.quick = command.quick;
  if (command.by_cord) options.by_cord_error_m = command.limits.max_error_m.value_or(default_error);
  options.repeats = command.repeats.value_or(command.quick ? 3 : 9);
  options.folder = command.folder;
  options.films = !command.folder.empty();
  options.stopped = [] { return interrupted != 0; };
  options.progress = [](double share, double left) { show_progress("study", share, left); };
  options.by_cord_progress = [](double share) { show_progress("by cord", share); };
  return options;
}

}  // namespace

int run(const Command& command) {
  if (command.validation_runs) return print_validation(command);
  const LevelFile file(command.level);
  const std::string replay = replay_of(command, file);
  if (command.terms) return print_terms(file, replay);

  print_grid(grid(command.quick));
  const StudyOptions options = options_of(command, file);
  const auto before = std::signal(SIGINT, interrupt);
  const Study study = measure(file, replay, options);
  std::signal(SIGINT, before);
  if (!study.complete) {
    std::printf("\ninterrupted; %s\n", command.folder.empty() ? "nothing is saved without --out FOLDER"
                                                              : "results are saved, and the same command continues");
    return 1;
  }
  Advice advice{command.limits};
  std::optional<Terms> terms;
  if (!command.folder.empty()) {
    terms = try_terms(file, replay, [](double share) { show_progress("terms", share); });
    advice.terms = &*terms;
  }
  const Report report = report_of(study, file, advice);
  for (const std::string& note : report.notes) std::printf("%s\n", note.c_str());
  print_table(report);
  print_calibration(calibrate(study));
  const bool recommended = recommend(command, file, study);
  if (!command.folder.empty()) {
    write_report(report, command.folder);
    std::printf("report: %s/index.html\n", command.folder.c_str());
  }
  return recommended ? 0 : 1;
}

}  // namespace study
