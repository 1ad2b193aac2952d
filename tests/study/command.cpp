#include "tests/study/command.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "tests/study/level_study.h"
#include "tests/study/progress_bar.h"
#include "tests/study/report.h"
#include "tests/study/terms.h"
#include "tests/study/text.h"
#include "tests/study/validation.h"

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

std::string agreement_of(const Reference& reference, std::size_t ticks) {
  const std::string points = "With " + name_of(reference.mesh) + " ";
  std::string agreement = "two converged runs agree to " + significant(reference.agreement_m, 2) + " m";
  if (reference.unconverged_ticks > 0) {
    agreement += " (though " + count_of(reference.unconverged_ticks, "tick") + " of the finer one did not converge)";
  }
  if (reference.ticks == ticks) return points + agreement + " in all ticks.";
  return points + agreement + " for the first " + fixed(static_cast<double>(reference.ticks) / 60.0, 2) +
         " s; later they differ by 0.1 mm, or a disturbance of 1e-10 m has grown to 1 cm, so that only statistics are "
         "compared.";
}

std::string windows_of(const Study& study) {
  const auto per_cent = [](double share) { return fixed(100.0 * share, 0) + " %"; };
  return "Windows: " + std::to_string(study.windows) +
         " quarters of a second along the run, each started from the state of the level's own cords; cords are "
         "compared "
         "in " +
         per_cent(study.compared_cords) + " of their ticks, players in " + per_cent(study.compared_players) +
         ", in which converged runs differ by at most 0.1 mm (RMS " + significant(study.agreement.greatest(), 2) +
         " m). Recommendations use the larger of the errors from the start and in windows.";
}

/// Returns the difference of two converged runs in their chaotic part. Smaller differences do not rank settings.
std::string chaotic_difference_of(const Reference& reference) {
  std::string sentence = "The two converged runs of " + name_of(reference.mesh) + ": ";
  for (std::size_t k = 0; k < Statistics::count; ++k) {
    sentence +=
        (k == 0 ? "" : ", ") + std::string(Statistics::names[k]) + " " + significant(reference.chaotic.values[k], 2);
  }
  return sentence + ".";
}

void add_chaotic_notes(Report& report, const Study& study) {
  const auto is_chaotic = [&](const Reference& reference) { return reference.ticks < study.ticks; };
  if (std::none_of(study.references.begin(), study.references.end(), is_chaotic)) return;
  report.notes.push_back(
      "The columns chaotic_… are statistics of the ticks after those, in which the motion is chaotic: the mean and "
      "standard deviation (sd) of the player's height and of the kinetic energy per mass, and the mean and the "
      "greatest "
      "stretch of the cords. Each value is the difference of the setting's statistic from that of the converged run. A "
      "value below the difference of two converged runs is not significant:");
  for (const Reference& reference : study.references) {
    if (is_chaotic(reference)) report.notes.push_back(chaotic_difference_of(reference));
  }
}

/// Returns the text of a cell; empty for NaN.
std::string cell(double value) { return std::isnan(value) ? "" : significant(value, 3); }

std::vector<std::string> notes_on_baselines(const Study& study) {
  std::vector<std::string> notes =
      compare_with_baselines(study.points(), [](const std::string& method) { return method == "direct"; });
  if (study.no_chains_reason.empty()) {
    notes.emplace_back(
        "box2d_chain replaces each cord of the level by thin boxes on Box2D's joints, in the same world, which takes "
        "the "
        "substeps: springs in the joints for bending stiffness (softer at large angles), Box2D's damping for drag, the "
        "cord's mass and contacts, and no stretch. box2d_max_distance also limits the distance of a hand from the "
        "cord's "
        "pins to the length of the cord between them. Their cost is that of player and world; the cost of cords "
        "includes the tick's state hash and snapshot. b2Rope neither holds bodies nor collides with them, so that it "
        "cannot run a level; it runs the scene heavy_swing.");
  } else {
    notes.push_back("Box2D's chains are not applicable: " + study.no_chains_reason + ".");
  }
  return notes;
}

void add_notes(Report& report, const Study& study, const LevelFile& file) {
  report.notes.push_back(
      "Level " + study.level + ", " + fixed(static_cast<double>(study.ticks) / 60.0, 2) + " s of recorded input (" +
      study.replay +
      "). The error is that of time steps and solver: the larger of the RMS errors of the cords' positions and of the "
      "player's. An error below the accuracy of the reference is set to that accuracy. Cords with other numbers of "
      "points are compared with their own converged motion; mesh_m is its difference from the converged motion with "
      "four times the level's links.");
  if (std::any_of(study.references.begin(), study.references.end(),
                  [](const Reference& r) { return r.mesh.rows > 1; })) {
    report.notes.push_back(
        "Cords of several rows are ribbons of the ropes' mass, bending and thickness, with a stretch_stiffness of " +
        significant(file.ribbon_stiffness(), 2) +
        " N where the rope has none: five times the weight of everything that moves stretches one by 1e-4.");
  }
  report.notes.push_back(
      "Further errors: tension: of the peak, relative to the converged peak. penetration: the greatest depth of a cord "
      "in a body after a tick, relative to its radius. energy and momentum: the greatest difference from the converged "
      "run in the same tick, relative to weight times longest cord, and to mass times the speed after a free fall of "
      "half that length. The player adds and removes both, so there is no drift to report.");
  for (const Reference& reference : study.references) report.notes.push_back(agreement_of(reference, study.ticks));
  report.notes.push_back(windows_of(study));
  add_chaotic_notes(report, study);
  for (std::string& note : notes_on_baselines(study)) report.notes.push_back(std::move(note));
}

void add_table(Report& report, const Study& study) {
  report.columns = {"position_m",
                    "position_relative",
                    "player_m",
                    "stretch",
                    "tension",
                    "penetration",
                    "energy",
                    "momentum",
                    "windows_position_m",
                    "windows_player_m",
                    "mesh_m",
                    "newton_per_tick",
                    "contacts_per_tick",
                    "fallbacks",
                    "halvings",
                    "unconverged_ticks"};
  report.columns.insert(report.columns.end(), Statistics::names.begin(), Statistics::names.end());
  for (const Measured& m : study.settings) {
    const bool direct = m.setting.solver == "direct";
    report.cells.push_back(
        {significant(m.error.position_m, 3), significant(m.error.position_relative, 3),
         significant(m.error.player_m, 3), significant(m.error.stretch, 3), cell(m.error.tension),
         cell(m.error.penetration), cell(m.error.energy), cell(m.error.momentum), cell(m.windows.position_m),
         cell(m.windows.player_m), significant(m.mesh.greatest_length(), 3),
         direct ? fixed(1.0 * m.work.iterations / static_cast<double>(study.ticks), 1) : "",
         direct ? fixed(1.0 * m.contacts / static_cast<double>(study.ticks), 1) : "",
         direct ? std::to_string(m.work.fallbacks) : "", direct ? std::to_string(m.work.halvings) : "",
         direct ? std::to_string(m.unconverged_ticks) : ""});
    for (const double value : m.chaotic.values) report.cells.back().push_back(cell(value));
  }
}

void add_metrics(Report& report, const Study& study) {
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
}

Report report_of(const Study& study, const LevelFile& file) {
  Report report;
  report.title = study.level;
  report.points = study.points();
  add_notes(report, study, file);
  add_table(report, study);
  add_metrics(report, study);
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
      if (point.cost_us > usable_budget_share * *command.budget_us) point.failure = "above the budget";
    }
  }
  const auto chosen = command.max_error_m ? cheapest_within(points, *command.max_error_m)
                                          : most_exact_within(points, *command.budget_us);
  if (!chosen) {
    std::string asked;
    if (command.max_error_m) asked += " an error of " + significant(*command.max_error_m, 4) + " m";
    if (command.budget_us) asked += " a cost of " + significant(*command.budget_us, 4) + " us";
    std::printf("no setting of the grid meets%s with the margin of a recommendation\n", asked.c_str());
    return false;
  }
  const Point& p = points[*chosen];
  std::printf("recommended: %s: %.2f us per tick, error %.3g m", p.setting.c_str(), p.cost_us, p.error_m);
  if (command.max_error_m) std::printf(", %.0f %% below the limit", 100.0 * (1.0 - p.error_m / *command.max_error_m));
  if (command.budget_us) std::printf(", %.0f %% below the budget", 100.0 * (1.0 - p.cost_us / *command.budget_us));
  std::putchar('\n');
  if (command.apply) {
    file.apply(study.settings[*chosen].setting);
    std::printf("written to %s; its recordings must be made again\n", file.path().c_str());
  }
  return true;
}

void print_tally(const std::string& limit, const Tally& tally) {
  std::printf("%s: met by %d of %d recommended settings with another input", limit.c_str(), tally.met,
              tally.recommended);
  if (tally.not_found > 0) std::printf("; no setting was recommended in %d more runs", tally.not_found);
  std::putchar('\n');
}

/// Verifies recommendations for the requested limits; the defaults are a centimetre and a tenth of a millisecond.
int print_validation(const Command& command) {
  const std::vector<std::string> names = command.levels.empty() ? game::level_names() : command.levels;
  const std::vector<LevelFile> levels(names.begin(), names.end());
  if (levels.empty()) throw std::runtime_error("there is no level in " + game::assets_folder() + "/levels");
  ValidationOptions options;
  options.max_error_m = command.max_error_m.value_or(options.max_error_m);
  options.budget_us = command.budget_us.value_or(options.budget_us);
  options.runs = *command.validation_runs;
  const Validation validation =
      validate_recommendations(levels, options, [](double share) { show_progress("runs", share); });
  for (const std::string& violation : validation.violations) std::printf("violation: %s\n", violation.c_str());
  std::printf("the player held a cord in %d of %d runs with the other input\n", validation.runs_with_grip,
              options.runs);
  print_tally("error limit of " + significant(options.max_error_m, 6) + " m", validation.error);
  print_tally("budget of " + significant(options.budget_us, 6) + " us", validation.budget);
  return 0;
}

int print_terms(const LevelFile& file, const std::string& replay) {
  const Terms terms = try_terms(file, replay, [](double share) { show_progress("terms", share); });
  std::printf("Compared for %.2f s; after that the motion is chaotic.\n", static_cast<double>(terms.ticks) / 60.0);
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

int run(const Command& command) {
  if (command.validation_runs) return print_validation(command);
  const LevelFile file(command.level);
  const std::string replay = replay_of(command, file);
  if (command.terms) return print_terms(file, replay);

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
    std::printf("\ninterrupted; %s\n", command.folder.empty() ? "nothing is saved without --out FOLDER"
                                                              : "results are saved, and the same command continues");
    return 1;
  }
  const Report report = report_of(study, file);
  for (const std::string& note : report.notes) std::printf("%s\n", note.c_str());
  print_table(report);
  const bool recommended = recommend(command, file, study);
  if (!command.folder.empty()) {
    write_report(report, command.folder);
    std::printf("report: %s/index.html\n", command.folder.c_str());
  }
  return recommended ? 0 : 1;
}

}  // namespace study
