#include "tests/study/terms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "engine/replay.h"
#include "tests/study/words.h"
#include "tests/support/contact_figures.h"
#include "tests/tradeoff/measure.h"

namespace study {
namespace {

using ribbon::Vec2;

constexpr double disturbance = 1e-10;  // m
constexpr double visible = 1e-2;       // m
constexpr int repeats = 7;
constexpr double saved_share = 0.02;  // of the cost, less of which is noise
constexpr std::array<const char*, 10> switchable = {
    "friction", "restitution", "self_contact",      "cord_contact",  "tension_only",
    "drag",     "damping",     "bending_stiffness", "poisson_ratio", "area_stiffness"};

void note(Symptom& symptom, std::size_t tick) {
  if (symptom.ticks++ == 0) symptom.first_tick = tick;
}

/// The middle lines of all cords of the direct solver.
std::vector<std::vector<Vec2>> lines_of(const engine::Coupling& coupling) {
  std::vector<std::vector<Vec2>> lines;
  for (int c = 0; c < coupling.size(); ++c) {
    if (coupling.solver(c) == engine::Solver::direct) lines.push_back(middle_line(coupling, c));
  }
  return lines;
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

/// Cells whose corners are in another order than they should.
bool any_inverted_cell(const engine::Coupling& coupling) {
  for (int c = 0; c < coupling.size(); ++c) {
    const int rows = coupling.shape(c).rows;
    const auto x = coupling.positions(c);
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
  const game::Level level = file.level();
  LevelRun run(level, inputs);
  run.reset();
  for (std::size_t tick = 1; tick <= inputs.size(); ++tick) {
    run.tick();
    const engine::Coupling& coupling = run.simulation().scene().coupling();
    const auto lines = lines_of(coupling);
    if (any_self_crossing(lines)) note(self, tick);
    if (any_mutual_crossing(lines)) note(mutual, tick);
    if (any_inverted_cell(coupling)) note(inverted, tick);
  }
  std::vector<Symptom> seen;
  for (const Symptom& symptom : {self, mutual, inverted}) {
    if (symptom.ticks > 0) seen.push_back(symptom);
  }
  return seen;
}

}  // namespace

Terms try_terms(const LevelFile& file, const std::string& replay_path, const std::function<void(double)>& progress) {
  const std::vector<engine::TickInput> inputs = inputs_of(engine::load_replay(replay_path));
  const game::Level as_it_is = file.level();
  const Trace trace = run(as_it_is, inputs);
  const Trace disturbed = run(file.displaced(disturbance), inputs);
  Terms terms;
  terms.ticks = ticks_together(trace, disturbed, visible);
  terms.lacking = find_symptoms(file, inputs);

  std::vector<std::unique_ptr<game::Level>> levels;
  std::vector<tradeoff::Timed> timed{timed_run(as_it_is, inputs)};
  for (const char* term : switchable) {
    if (!file.declares(term)) continue;
    TermResult& result = terms.declared.emplace_back();
    result.term = term;
    try {
      levels.push_back(std::make_unique<game::Level>(file.with_property(term, nullptr)));
    } catch (const engine::MapError&) {
      result.can_do_without = false;
      continue;
    }
    const Trace without = run(*levels.back(), inputs);
    const std::size_t same = ticks_together(trace, without, visible);
    result.shows_at = same < terms.ticks ? same + 1 : 0;
    result.change = difference(trace, without, std::min(same, terms.ticks));
    timed.push_back(timed_run(*levels.back(), inputs));
    progress(0.05 * static_cast<double>(terms.declared.size()));
  }
  const auto timings = tradeoff::interleaved_timings(timed, static_cast<int>(inputs.size()), repeats,
                                                     [&](double share) { progress(0.5 + 0.5 * share); });
  std::size_t next = 1;
  for (TermResult& result : terms.declared) {
    if (result.can_do_without) result.cost_share = timings[next++].median_us / timings[0].median_us;
  }
  return terms;
}

std::string verdict(const TermResult& result) {
  if (!result.can_do_without) return "needed: such a cord cannot be built without it";
  if (result.shows_at > 0) {
    return "needed: without it something is a centimetre elsewhere from tick " + std::to_string(result.shows_at) +
           " on";
  }
  const double saved = 1.0 - result.cost_share;
  return "not needed: without it all is where it was, to " + significant(result.change.greatest_length(), 2) +
         " m, at " + (saved > saved_share ? fixed(100.0 * saved, 0) + " % less" : "about the same") + " cost";
}

}  // namespace study
