#include "tests/study/terms.h"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include "engine/replay/replay.h"
#include "ribbon/study/conditions.h"
#include "tests/study/reference.h"
#include "tests/study/text.h"
#include "tests/support/contact_figures.h"
#include "tests/tradeoff/measure.h"

namespace study {
namespace {

using ribbon::Vec2;

constexpr double visible = 1e-2;  // m
constexpr int repeats = 7;
constexpr double noise_share = 0.02;    // of the cost
constexpr double pushing_share = 1e-3;  // of a cord's weight
constexpr std::array<const char*, 10> switchable = {
    "friction", "restitution", "self_contact",      "cord_contact",  "tension_only",
    "drag",     "damping",     "bending_stiffness", "poisson_ratio", "area_stiffness"};

/// Terms that can be switched on.
struct Switch {
  const char* term;
  std::variant<bool, double> value;
};
constexpr std::array<Switch, 4> undeclared_terms = {
    {{"self_contact", true}, {"cord_contact", true}, {"tension_only", true}, {"area_stiffness", 1.0}}};

void note(Symptom& symptom, std::size_t tick) {
  if (symptom.ticks++ == 0) symptom.first_tick = tick;
}

/// The middle lines of all cords of the direct solver.
std::vector<std::vector<Vec2>> lines_of(const ribbon::box2d::Coupling& coupling) {
  std::vector<std::vector<Vec2>> lines;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() == ribbon::box2d::Solver::direct) lines.push_back(middle_line(coupling, c));
  }
  return lines;
}

bool any_pushing(const ribbon::box2d::Coupling& coupling, double gravity) {
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() == ribbon::box2d::Solver::direct && pushes(coupling.cord(c).direct(), gravity))
      return true;
  }
  return false;
}

bool any_self_crossing(const std::vector<std::vector<Vec2>>& lines) {
  return std::any_of(lines.begin(), lines.end(),
                     [](const auto& line) { return test_support::self_crossings(line, false) > 0; });
}

bool any_mutual_crossing(const std::vector<std::vector<Vec2>>& lines) {
  for (std::size_t b = 1; b < lines.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (test_support::mutual_crossings(lines[a], false, lines[b], false) > 0) return true;
    }
  }
  return false;
}

/// Returns the number of cells with inverted corners.
bool any_inverted_cell(const ribbon::box2d::Coupling& coupling) {
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    const int rows = coupling.cord(c).shape().rows;
    const auto x = coupling.cord(c).positions();
    const auto at = [&](std::size_t column, int row) {
      return x[column * static_cast<std::size_t>(rows) + static_cast<std::size_t>(row)];
    };
    for (std::size_t i = 0; rows > 1 && i + 1 < x.size() / static_cast<std::size_t>(rows); ++i) {
      for (int j = 0; j + 1 < rows; ++j) {
        if (cross(at(i + 1, j) - at(i, j), at(i, j + 1) - at(i, j)) <= 0.0) return true;
      }
    }
  }
  return false;
}

std::vector<Symptom> find_symptoms(const LevelFile& file, std::span<const engine::TickInput> inputs) {
  Symptom self{"cords pass through themselves", "self_contact"};
  Symptom mutual{"cords pass through each other", "cord_contact"};
  Symptom inverted{"cells of ribbons are turned inside out", "area_stiffness"};
  Symptom pushing{"links push", "tension_only"};
  const game::Level level = file.level();
  LevelRun run(level, inputs);
  run.reset();
  for (std::size_t tick = 1; tick <= inputs.size(); ++tick) {
    run.tick();
    const ribbon::box2d::Coupling& coupling = run.simulation().scene().coupling();
    const auto lines = lines_of(coupling);
    if (any_self_crossing(lines)) note(self, tick);
    if (any_mutual_crossing(lines)) note(mutual, tick);
    if (any_inverted_cell(coupling)) note(inverted, tick);
    const b2Vec2 gravity = run.simulation().scene().world().GetGravity();
    if (any_pushing(coupling, static_cast<double>(gravity.Length()))) note(pushing, tick);
  }
  std::vector<Symptom> seen;
  for (const Symptom& symptom : {self, mutual, inverted, pushing}) {
    if (symptom.ticks > 0) seen.push_back(symptom);
  }
  return seen;
}

/// A changed level, and its comparison with the original one.
struct Trial {
  TermResult result;
  std::optional<game::Level> level;
};

Trial without(const LevelFile& file, const char* term) {
  Trial trial;
  trial.result.term = term;
  try {
    trial.level = file.with_property(term, nullptr);
  } catch (const engine::MapError&) {
    trial.result.can_be_built = false;
  }
  return trial;
}

Trial with(const LevelFile& file, const Switch& on) {
  Trial trial;
  trial.result.term = on.term;
  trial.result.declared = false;
  trial.level = std::visit([&](auto value) { return file.switched_on(on.term, value); }, on.value);
  trial.result.can_be_built = trial.level.has_value();
  return trial;
}

std::vector<Trial> trials_of(const LevelFile& file) {
  std::vector<Trial> trials;
  for (const char* term : switchable) {
    if (file.declares(term)) trials.push_back(without(file, term));
  }
  for (const Switch& on : undeclared_terms) {
    if (!file.declares(on.term)) trials.push_back(with(file, on));
  }
  return trials;
}

void compare(Trial& trial, const Trace& original, std::span<const engine::TickInput> inputs, std::size_t ticks) {
  const Trace changed = run(*trial.level, inputs);
  const std::size_t same = std::min(agreeing_ticks(original, changed, visible), ticks);
  trial.result.first_difference = same < ticks ? same + 1 : 0;
  trial.result.change = difference(changed, original, same);
}

void time(std::vector<Trial>& trials, const game::Level& original, std::span<const engine::TickInput> inputs,
          const std::function<void(double)>& progress) {
  std::vector<tradeoff::Timed> timed{timed_run(original, inputs)};
  for (const Trial& trial : trials) {
    if (trial.level) timed.push_back(timed_run(*trial.level, inputs));
  }
  const auto timings = tradeoff::interleaved_timings(timed, static_cast<int>(inputs.size()), repeats, progress);
  std::size_t next = 1;
  for (Trial& trial : trials) {
    if (trial.level) trial.result.cost_share = timings[next++].median_us / timings[0].median_us;
  }
}

/// "at 12 % more cost"; empty if the difference is noise.
std::string cost_in_words(double share) {
  if (std::abs(share - 1.0) <= noise_share) return "at about the same cost";
  return "at " + fixed(100.0 * std::abs(share - 1.0), 0) + " % " + (share > 1.0 ? "more" : "less") + " cost";
}

}  // namespace

bool pushes(const ribbon::Cord& cord, double gravity) {
  const ribbon::CordDef& def = cord.def();
  if (def.rows > 1 || def.tension_only) return false;
  const double most = pushing_share * def.mass_per_length * def.length * gravity;
  return std::any_of(cord.tensions().begin(), cord.tensions().end(),
                     [most](double tension) { return tension < -most; });
}

std::size_t comparable_ticks(const LevelFile& file, std::span<const engine::TickInput> inputs) {
  const auto [left, right] = run_probes(file.with(probe({})), inputs);
  return agreeing_ticks(left, right, ribbon::study::max_probe_difference);
}

Terms try_terms(const LevelFile& file, const std::string& replay_path, const std::function<void(double)>& progress) {
  const std::vector<engine::TickInput> inputs = inputs_of(engine::load_replay(replay_path));
  const game::Level original = file.level();
  const Trace trace = run(original, inputs);
  Terms terms;
  terms.ticks = comparable_ticks(file, inputs);
  terms.missing = find_symptoms(file, inputs);

  std::vector<Trial> trials = trials_of(file);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    if (trials[k].level) compare(trials[k], trace, inputs, terms.ticks);
    progress(0.5 * static_cast<double>(k + 1) / static_cast<double>(trials.size()));
  }
  time(trials, original, inputs, [&](double share) { progress(0.5 + 0.5 * share); });
  for (Trial& trial : trials) terms.results.push_back(std::move(trial.result));
  return terms;
}

std::string verdict(const TermResult& result) {
  if (!result.can_be_built) {
    return result.declared ? "needed: such a cord cannot be built without it"
                           : "not applicable: no cord of the level can have it";
  }
  const std::string how = result.declared ? "without" : "with";
  const std::string cost = cost_in_words(result.cost_share);
  if (result.first_difference > 0) {
    const std::string difference =
        how + " it a position differs by 1 cm from tick " + std::to_string(result.first_difference) + " on";
    return result.declared ? "needed: " + difference : "changes the motion: " + difference + ", " + cost;
  }
  return "not needed: " + how + " it all positions agree to " + significant(result.change.greatest_length(), 2) +
         " m, " + cost;
}

}  // namespace study
