#include "tests/study/level_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/study/text.h"

namespace study {
namespace {

using Json = nlohmann::ordered_json;

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
         " s. Later they differ by 0.1 mm, or the motion is so sensitive (a contact, a catch) that a change of all "
         "velocities by 4 mm/s moves something by 1 cm: a setting is not judged by such a path, only by statistics.";
}

std::string windows_of(const Study& study) {
  const auto per_cent = [](double share) { return fixed(100.0 * share, 0) + " %"; };
  return "Windows: " + std::to_string(study.windows) +
         " quarters of a second along the run, each started from the state that the level's own cords reach, after a "
         "quarter with 16 substeps. (Contacts give way less with more substeps, so that without it the converged run "
         "would throw off what rests.) Cords are compared in " +
         per_cent(study.compared_cords) + " of their ticks, players in " + per_cent(study.compared_players) +
         ", in which converged runs differ by at most 0.1 mm (RMS " + significant(study.agreement.greatest(), 2) +
         " m), and runs whose velocities differ by 4 mm/s by at most 1 cm. Recommendations use the larger of the "
         "errors "
         "from the start and in windows.";
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
      "). The error is that of time steps and solver: the largest of the RMS errors of the cords' positions, of the "
      "player's, and of those of a second player and the dynamic bodies. Cords are compared while both runs have them: "
      "a cord that is cut is another one from then on, and thrown lines have the setting too. An error below the "
      "accuracy of the reference is set to that accuracy. Cords with other numbers of "
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
  if (study.others > 0) {
    report.notes.push_back(
        "Other players: " + std::to_string(study.others) +
        " random ones of two seconds each, chosen for the cords that they hold and touch. A setting is judged by the "
        "worst of them and the recorded one (others_m, others_work_most), because a player that meets no cord shows no "
        "setting to be too cheap.");
  }
  add_chaotic_notes(report, study);
  report.notes.emplace_back(
      "posed: ticks in which the cords' budget of work (max_work) did not suffice, so that they were redone as one "
      "linearised step, whatever the number of substeps. Such a setting is measured again with max_work=20000, and "
      "recommended for an error only if no other one is within it. Else what is recommended for an error has that "
      "budget: it changes nothing where the default one suffices."
      " The converged runs have a budget of a million.");
  for (const std::string& left_out : study.left_out) report.notes.push_back("Left out: " + left_out + ".");
  for (std::string& note : notes_on_baselines(study)) report.notes.push_back(std::move(note));
}

void add_table(Report& report, const Study& study) {
  report.columns = {"position_m",
                    "position_relative",
                    "player_m",
                    "body_m",
                    "stretch",
                    "tension",
                    "penetration",
                    "energy",
                    "momentum",
                    "windows_position_m",
                    "windows_player_m",
                    "windows_body_m",
                    "others_m",
                    "others_work_most",
                    "mesh_m",
                    "work_per_tick",
                    "work_p99",
                    "work_most",
                    "most_us",
                    "newton_per_tick",
                    "contacts_per_tick",
                    "fallbacks",
                    "halvings",
                    "posed",
                    "unconverged_ticks"};
  report.columns.insert(report.columns.end(), Statistics::names.begin(), Statistics::names.end());
  for (const Measured& m : study.settings) {
    const bool direct = m.setting.solver == "direct";
    report.cells.push_back({cell(m.error.position_m),
                            cell(m.error.position_relative),
                            significant(m.error.player_m, 3),
                            cell(m.error.body_m),
                            significant(m.error.stretch, 3),
                            cell(m.error.tension),
                            cell(m.error.penetration),
                            cell(m.error.energy),
                            cell(m.error.momentum),
                            cell(m.windows.position_m),
                            cell(m.windows.player_m),
                            cell(m.windows.body_m),
                            cell(m.others.error_m),
                            std::isnan(m.others.work.most) ? "" : fixed(m.others.work.most, 0),
                            std::isnan(m.mesh.position_m) ? "" : significant(m.mesh.greatest_length(), 3),
                            cell(m.tick_work.mean),
                            direct ? fixed(m.tick_work.p99, 0) : "",
                            direct ? fixed(m.tick_work.most, 0) : "",
                            significant(m.most_us, 3),
                            direct ? fixed(1.0 * m.work.iterations / static_cast<double>(study.ticks), 1) : "",
                            direct ? fixed(1.0 * m.contacts / static_cast<double>(study.ticks), 1) : "",
                            direct ? std::to_string(m.work.fallbacks) : "",
                            direct ? std::to_string(m.work.halvings) : "",
                            direct ? std::to_string(m.work.posed) : "",
                            direct ? std::to_string(m.unconverged_ticks) : ""});
    for (const double value : m.chaotic.values) report.cells.back().push_back(cell(value));
  }
}

Json json_of(ribbon::Vec2 p) { return Json::array({p.x, p.y}); }

/// Returns the stage and the films for the page; empty without films.
std::string films_of(const Study& study) {
  if (study.films.empty()) return {};
  Json json{{"origin", json_of(study.stage.origin)},
            {"unit", study.stage.unit},
            {"ticksPerFrame", study.stage.ticks_per_frame},
            {"compared", study.references.front().ticks},
            {"converged", study.converged_film},
            {"scenery", Json::array()},
            {"points", Json::array()}};
  for (const auto& outline : study.stage.scenery) {
    Json corners = Json::array();
    for (const ribbon::Vec2 corner : outline) corners.push_back(json_of(corner));
    json["scenery"].push_back(std::move(corners));
  }
  for (const Film& film : study.films) {
    json["points"].push_back({{"frames", film.frames},
                              {"greatest",
                               {{"tick", film.greatest.tick},
                                {"metres", film.greatest.metres},
                                {"place", json_of(film.greatest.place)},
                                {"reference", json_of(film.greatest.reference_place)}}}});
  }
  return json.dump();
}

void add_advice(Report& report, const Study& study, const LevelFile& file, const Advice& advice) {
  Limits limits = advice.limits;
  if (!limits.any()) limits.max_error_m = default_error;
  const Calibration calibration = calibrate(study);
  const Choice choice = choose(study, limits, calibration);
  if (choice.setting) {
    report.headline =
        "Recommended for " + in_words(limits) + ": " + in_words(study, *choice.setting, calibration, limits) + ".";
    report.recommended = choice.setting;
    const Measured& chosen = study.settings[*choice.setting];
    if (recommended_for(limits, chosen) != chosen.setting)
      report.recommended_with = "max_work=" + std::to_string(ample_work);
    if (study.by_cord) report.headline += " By cord, cheaper: " + in_words(*study.by_cord, file) + ".";
  } else if (choice.nearest) {
    report.headline = "No setting meets " + in_words(limits) + " with the margin of a recommendation; the nearest is " +
                      in_words(study, *choice.nearest, calibration, limits) + ".";
  } else {
    report.headline = "No setting counts: each one failed or was not compared.";
  }
  for (std::size_t k = 0; k < study.settings.size(); ++k) {
    if (is_present(study.settings[k].setting)) report.present = k;
  }
  report.notes.emplace_back(
      "The picture shows the errors that recommendations use: the larger of those from the start and in windows. Other "
      "methods and other numbers of points have no windows: their marks are small, and not compared with the others.");
  report.notes.push_back(
      "The 99th percentile and the greatest tick of a recommendation are those of counted work, which "
      "is the same on every machine: on this one a tick takes " +
      significant(calibration.base_us, 3) + " us and 1000 units of work " +
      significant(1e3 * calibration.us_per_work, 3) +
      " us (least squares over the settings; rank correlation of time and work " +
      significant(calibration.rank_correlation, 3) + ").");
}

}  // namespace

std::vector<std::string> findings_of(const Terms& terms) {
  std::vector<std::string> lines;
  for (const bool declared : {true, false}) {
    for (const TermResult& result : terms.results) {
      if (result.declared != declared) continue;
      lines.push_back(result.term + (declared ? " (declared): " : " (not declared): ") + verdict(result));
    }
  }
  for (const Symptom& symptom : terms.missing) {
    lines.push_back(symptom.term + " may be missing: " + symptom.what + ", first in tick " +
                    std::to_string(symptom.first_tick) + ", in " + count_of(static_cast<int>(symptom.ticks), "tick"));
  }
  return lines;
}

Report report_of(const Study& study, const LevelFile& file, const Advice& advice) {
  Report report;
  report.title = study.level;
  report.points = applicable(study);  // as recommendations see them
  add_notes(report, study, file);
  add_advice(report, study, file, advice);
  add_table(report, study);
  report.films = films_of(study);
  if (advice.terms != nullptr) report.findings = findings_of(*advice.terms);
  return report;
}

}  // namespace study
