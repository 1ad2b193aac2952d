#include "tests/study/command.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "tests/study/level_study.h"
#include "tests/study/progress_bar.h"
#include "tests/study/promises.h"
#include "tests/study/report.h"
#include "tests/study/terms.h"
#include "tests/study/words.h"

namespace study {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/) { interrupted = 1; }

std::string replay_of(const Command& command, const LevelFile& file) {
  if (!command.replay.empty()) return command.replay;
  const std::string name = std::filesystem::path(file.path()).stem().string();
  std::string path = game::assets_folder() + "/replays/" + name + ".replay";
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw std::runtime_error("no --replay given, and there is no " + path + "; record one: ropeswing --level " +
                             file.path() + " --record FILE");
  }
  return path;
}

/// Returns the name of a mesh: 1 times the links in 2 rows.
std::string name_of(const Mesh& mesh) {
  return significant(mesh.points, 6) + " times the links" +
         (mesh.rows > 1 ? " in " + std::to_string(mesh.rows) + " rows" : "");
}

std::string seconds_of(const Reference& reference, std::size_t ticks) {
  const std::string points = "With " + name_of(reference.mesh) + " ";
  std::string agreement = "two converged runs agree to " + significant(reference.agreement_m, 2) + " m";
  if (reference.unconverged_ticks > 0) {
    agreement += " (though " + count_of(reference.unconverged_ticks, "tick") + " of the finer one did not converge)";
  }
  if (reference.ticks == ticks) return points + agreement + " all along.";
  return points + agreement + " for the first " + fixed(static_cast<double>(reference.ticks) / 60.0, 2) +
         " s; after it a tenth of a millimetre, or a disturbance of 1e-10 m grown to a centimetre, is between them, "
         "and "
         "nothing is compared but statistics.";
}

std::string windows_of(const Study& study) {
  const auto per_cent = [](double share) { return fixed(100.0 * share, 0) + " %"; };
  return "Windows: " + std::to_string(study.windows) +
         " quarters of a second, all along the run, each begun from where the level's own cords are then; cords are "
         "compared in " +
         per_cent(study.compared_cords) + " of their ticks, players in " + per_cent(study.compared_players) +
         ", in which converged runs are a tenth of a millimetre apart at most (RMS " +
         significant(study.agreement.greatest(), 2) +
         " m). What is recommended keeps its word by the greater of the errors from the start and in windows.";
}

/// Returns the difference of two converged runs in their chaotic part. Smaller differences do not rank settings.
std::string yardstick_of(const Reference& reference) {
  std::string sentence = "The two converged runs of " + name_of(reference.mesh) + ": ";
  for (std::size_t k = 0; k < Statistics::count; ++k) {
    sentence +=
        (k == 0 ? "" : ", ") + std::string(Statistics::names[k]) + " " + significant(reference.later.values[k], 2);
  }
  return sentence + ".";
}

void add_later_notes(Report& report, const Study& study) {
  const auto is_chance = [&](const Reference& reference) { return reference.ticks < study.ticks; };
  if (std::none_of(study.references.begin(), study.references.end(), is_chance)) return;
  report.notes.push_back(
      "The columns later_… are of the ticks after those, where a run is one of many that the same input could have led "
      "to: the mean and standard deviation (sd) of the player's height and of the kinetic energy a unit of mass, the "
      "cords' mean stretch and the greatest. Each is how far the setting's statistic is from the converged run's, a "
      "difference of two chaotic runs. What is no greater than the difference of two converged runs says nothing:");
  for (const Reference& reference : study.references) {
    if (is_chance(reference)) report.notes.push_back(yardstick_of(reference));
  }
}

/// Returns the text of a cell; empty for NaN.
std::string cell(double value) { return std::isnan(value) ? "" : significant(value, 3); }

std::vector<std::string> notes_on_baselines(const Study& study) {
  std::vector<std::string> notes =
      who_is_ahead(study.points(), [](const std::string& method) { return method == "direct"; });
  if (study.no_chains.empty()) {
    notes.emplace_back(
        "box2d_chain is the level with each cord as thin boxes on Box2D's joints, in the same world, which takes the "
        "substeps: springs in the joints where the cord resists bending (softer where it bends far), drag as Box2D's "
        "damping, mass and contact as the cord's; of stretch, none. box2d_max_distance also keeps a hand no further "
        "from the cord's pins than the cord is long. Their cost is of player and world alone; that of cords has the "
        "tick's state hash and snapshot in it. b2Rope neither holds nor meets a body, so that it cannot stand in a "
        "level; it stands in the scene heavy_swing.");
  } else {
    notes.push_back("Box2D's chains are not applicable: " + study.no_chains + ".");
  }
  return notes;
}

Report report_of(const Study& study, const LevelFile& file) {
  Report report;
  report.title = study.level;
  report.notes.push_back(
      "Level " + study.level + ", " + fixed(static_cast<double>(study.ticks) / 60.0, 2) + " s of recorded input (" +
      study.replay +
      "). Errors are of time and solver, RMS, of the cords' places and of the player's, the greater "
      "of both; what cannot be told from the converged motion stands at what is known of it. Cords of other "
      "numbers of points are compared with their own converged motion; mesh_m is how far that is from "
      "the one of four times the level's links.");
  if (std::any_of(study.references.begin(), study.references.end(),
                  [](const Reference& r) { return r.mesh.rows > 1; })) {
    report.notes.push_back(
        "Cords of several rows are ribbons of the ropes' mass, bending and thickness, with a stretch_stiffness of " +
        significant(file.ribbon_stiffness(), 2) +
        " N where the rope has none: five times the weight of all that moves stretches one by a ten thousandth.");
  }
  report.notes.push_back(
      "Each error is of its own kind. tension: of the peak, as a share of the converged one. penetration: the deepest "
      "that a cord is in a body after a tick, as a share of its radius. energy and momentum: the furthest from the "
      "converged ones of the same tick, as shares of weight times longest cord, and of mass times the speed of a free "
      "fall of half that length; who plays gives and takes both, so that there is no drift to be told.");
  for (const Reference& reference : study.references) report.notes.push_back(seconds_of(reference, study.ticks));
  report.notes.push_back(windows_of(study));
  add_later_notes(report, study);
  report.points = study.points();
  for (std::string& note : notes_on_baselines(study)) report.notes.push_back(std::move(note));
  report.columns = {
      "position_m",      "position_share", "player_m",           "stretch",          "tension", "penetration",
      "energy",          "momentum",       "windows_position_m", "windows_player_m", "mesh_m",  "newton_a_tick",
      "contacts_a_tick", "fallbacks",      "halvings",           "unconverged_ticks"};
  report.columns.insert(report.columns.end(), Statistics::names.begin(), Statistics::names.end());
  for (const Measured& m : study.settings) {
    const bool direct = m.dials.solver == "direct";
    report.cells.push_back(
        {significant(m.error.position_m, 3), significant(m.error.position_share, 3), significant(m.error.player_m, 3),
         significant(m.error.stretch, 3), cell(m.error.tension), cell(m.error.penetration), cell(m.error.energy),
         cell(m.error.momentum), cell(m.windows.position_m), cell(m.windows.player_m),
         significant(m.mesh.greatest_length(), 3),
         direct ? fixed(1.0 * m.work.iterations / static_cast<double>(study.ticks), 1) : "",
         direct ? fixed(1.0 * m.contacts / static_cast<double>(study.ticks), 1) : "",
         direct ? std::to_string(m.work.fallbacks) : "", direct ? std::to_string(m.work.halvings) : "",
         direct ? std::to_string(m.unconverged_ticks) : ""});
    for (const double later : m.later.values) report.cells.back().push_back(cell(later));
  }
  const auto add = [&](const char* name, double (*value)(const Measured&)) {
    Metric& metric = report.metrics.emplace_back();
    metric.name = name;
    for (const Measured& m : study.settings) metric.values.push_back(value(m));
  };
  add("position_m", [](const Measured& m) { return m.error.position_m; });
  add("player_m", [](const Measured& m) { return m.error.player_m; });
  add("stretch", [](const Measured& m) { return m.error.stretch; });
  add("tension", [](const Measured& m) { return m.error.tension; });
  add("penetration", [](const Measured& m) { return m.error.penetration; });
  add("energy", [](const Measured& m) { return m.error.energy; });
  add("momentum", [](const Measured& m) { return m.error.momentum; });
  add("windows_position_m", [](const Measured& m) { return m.windows.position_m; });
  add("windows_player_m", [](const Measured& m) { return m.windows.player_m; });
  return report;
}

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

/// Returns false if no setting meets the request.
bool recommend(const Command& command, const LevelFile& file, const Study& study) {
  if (!command.max_error_m && !command.budget_us) return true;
  std::vector<Point> points = applicable(study);
  if (command.max_error_m && command.budget_us) {
    for (Point& point : points) {
      if (point.cost_us > kept_budget * *command.budget_us) point.failure = "too dear";
    }
  }
  const auto chosen = command.max_error_m ? cheapest_within(points, *command.max_error_m)
                                          : most_exact_within(points, *command.budget_us);
  if (!chosen) {
    std::string asked;
    if (command.max_error_m) asked += " an error of " + significant(*command.max_error_m, 4) + " m";
    if (command.budget_us) asked += " a cost of " + significant(*command.budget_us, 4) + " us";
    std::printf("no setting of the grid keeps%s with the margin that a promise needs\n", asked.c_str());
    return false;
  }
  const Point& p = points[*chosen];
  std::printf("recommended: %s: %.2f us a tick, error %.3g m", p.setting.c_str(), p.cost_us, p.error_m);
  if (command.max_error_m)
    std::printf(", %.0f %% below what is allowed", 100.0 * (1.0 - p.error_m / *command.max_error_m));
  if (command.budget_us) std::printf(", %.0f %% below the budget", 100.0 * (1.0 - p.cost_us / *command.budget_us));
  std::putchar('\n');
  if (command.apply) {
    file.apply(study.settings[*chosen].dials);
    std::printf("written into %s; recordings of it have to be made anew\n", file.path().c_str());
  }
  return true;
}

void print_tally(const std::string& promise, const Tally& tally) {
  std::printf("%s: %d of %d chosen settings kept it with another player", promise.c_str(), tally.kept, tally.found);
  if (tally.none > 0) std::printf("; none was found in %d more", tally.none);
  std::putchar('\n');
}

/// Verifies recommendations for the requested limits; the defaults are a centimetre and a tenth of a millisecond.
int tell_promises(const Command& command) {
  const std::vector<std::string> names = command.levels.empty() ? game::level_names() : command.levels;
  const std::vector<LevelFile> levels(names.begin(), names.end());
  if (levels.empty()) throw std::runtime_error("there is no level in " + game::assets_folder() + "/levels");
  PromiseOptions options;
  options.max_error_m = command.max_error_m.value_or(options.max_error_m);
  options.budget_us = command.budget_us.value_or(options.budget_us);
  options.tries = *command.promises;
  const Promises promises = try_promises(levels, options, [](double share) { show_progress("tries", share); });
  for (const std::string& broken : promises.broken) std::printf("broken: %s\n", broken.c_str());
  std::printf("the other player held a cord in %d of %d tries\n", promises.held, options.tries);
  print_tally("an error of " + significant(options.max_error_m, 6) + " m", promises.error);
  print_tally("a cost of " + significant(options.budget_us, 6) + " us", promises.budget);
  return 0;
}

int tell_terms(const LevelFile& file, const std::string& replay) {
  const Terms terms = try_terms(file, replay, [](double share) { show_progress("terms", share); });
  std::printf("Compared for %.2f s; after that what a run does is chance.\n", static_cast<double>(terms.ticks) / 60.0);
  for (const bool declared : {true, false}) {
    std::puts(declared ? "Without each term that is declared:"
                       : "With each term that is not, and has one natural value:");
    for (const TermResult& result : terms.results) {
      if (result.declared != declared) continue;
      const std::string cost = std::isnan(result.cost_share) ? "-" : fixed(result.cost_share, 2) + "x";
      std::printf("%-18s cost %6s  %s\n", result.term.c_str(), cost.c_str(), verdict(result).c_str());
    }
  }
  for (const Symptom& symptom : terms.lacking) {
    std::printf("%-18s MAY BE LACKING: %s, first in tick %zu, in %zu ticks\n", symptom.term.c_str(),
                symptom.what.c_str(), symptom.first_tick, symptom.ticks);
  }
  if (terms.lacking.empty()) std::puts("nothing is seen that a term which is not declared would prevent");
  return 0;
}

void print_grid(const std::vector<Dials>& all) {
  std::printf("%zu settings:\n", all.size());
  for (const Dials& dials : all) std::printf("  %-18s %s\n", dials.solver.c_str(), name_of(dials).c_str());
  std::fflush(stdout);
}

}  // namespace

int run(const Command& command) {
  if (command.promises) return tell_promises(command);
  const LevelFile file(command.level);
  const std::string replay = replay_of(command, file);
  if (command.terms) return tell_terms(file, replay);

  print_grid(grid(command.quick));
  StudyOptions options;
  options.quick = command.quick;
  options.repeats = command.repeats;
  options.folder = command.folder;
  options.stopped = [] { return interrupted != 0; };
  options.progress = [](double share, double left) { show_progress("study", share, left); };
  const auto before = std::signal(SIGINT, interrupt);
  const Study study = measure(file, replay, options);
  std::signal(SIGINT, before);
  if (!study.complete) {
    std::printf("\ninterrupted; %s\n", command.folder.empty()
                                           ? "nothing is kept without --out FOLDER"
                                           : "what is measured is kept, and the same command goes on from there");
    return 1;
  }
  const Report report = report_of(study, file);
  for (const std::string& note : report.notes) std::printf("%s\n", note.c_str());
  print_table(report);
  const bool kept = recommend(command, file, study);
  if (!command.folder.empty()) {
    write_report(report, command.folder);
    std::printf("report: %s/index.html\n", command.folder.c_str());
  }
  return kept ? 0 : 1;
}

}  // namespace study
