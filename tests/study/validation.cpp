#include "tests/study/validation.h"

#include <algorithm>
#include <iterator>
#include <random>

#include "game/simulation/buttons.h"
#include "tests/study/text.h"

namespace study {
namespace {

constexpr int repeats = 3;

/// The settings of the quick grid for a level's own cords.
std::vector<Setting> own_settings() {
  std::vector<Setting> own;
  const std::vector<Setting> all = grid(true);
  std::copy_if(all.begin(), all.end(), std::back_inserter(own), [](const Setting& setting) {
    return setting.solver == "direct" && mesh_of(setting) == Mesh{} && !is_present(setting);
  });
  return own;
}

StudyOptions options_of(std::vector<Setting> settings) {
  StudyOptions options;
  options.quick = true;
  options.repeats = repeats;
  options.grid = std::move(settings);
  return options;
}

/// The chosen settings to measure again; both may be the same setting.
struct Chosen {
  std::optional<std::size_t> cheapest;
  std::optional<std::size_t> most_exact;

  std::vector<Setting> to_measure(const std::vector<Measured>& settings) const {
    std::vector<Setting> some;
    if (cheapest) some.push_back(settings[*cheapest].setting);
    if (most_exact && most_exact != cheapest) some.push_back(settings[*most_exact].setting);
    return some;
  }
};

/// Counts the result of a limit: `value` of the setting must be at most `most`.
void count(Tally& tally, const Point& again, double Point::*value, double most, const std::string& what,
           std::vector<std::string>& violations) {
  ++tally.recommended;
  if (again.failure.empty() && again.*value <= most) {
    ++tally.met;
    return;
  }
  violations.push_back(what + ": " + again.setting + ": " +
                       (again.failure.empty() ? significant(again.*value, 3) : again.failure));
}

bool holds_a_cord(const game::Level& level, const std::vector<engine::TickInput>& inputs) {
  game::Simulation simulation(level);
  return std::any_of(inputs.begin(), inputs.end(), [&simulation](const engine::TickInput& input) {
    simulation.tick(input);
    return simulation.scene().coupling().body(simulation.player().body()).held_place().has_value();
  });
}

}  // namespace

std::vector<engine::TickInput> random_inputs(unsigned seed, int count) {
  constexpr int held_for = 15;  // ticks, on average
  std::mt19937 random(seed);
  std::vector<engine::TickInput> inputs(static_cast<std::size_t>(count));
  std::uint16_t buttons = game::button_right;
  for (engine::TickInput& input : inputs) {  // mostly right and grab, because levels go to the right
    if (random() % held_for == 0) {
      buttons = 0;
      for (const auto& [button, eighths] : {std::pair{game::button_left, 1U},
                                            {game::button_right, 7U},
                                            {game::button_jump, 4U},
                                            {game::button_grab, 6U}}) {
        if (random() % 8 < eighths) buttons = static_cast<std::uint16_t>(buttons | button);
      }
    }
    input.buttons = buttons;
  }
  return inputs;
}

Validation validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                                    const std::function<void(double)>& progress, const Measure& measure_level) {
  Validation validation;
  for (int k = 0; k < options.runs; ++k) {
    const auto seed = static_cast<unsigned>(2 * k);
    const LevelFile level = levels[static_cast<std::size_t>(k) % levels.size()].varied(seed);
    const Study chosen_on = measure_level(level, random_inputs(seed, options.ticks), options_of(own_settings()));
    const std::vector<Point> points = applicable(chosen_on);
    const Chosen chosen{cheapest_within(points, options.max_error_m), most_exact_within(points, options.budget_us)};
    validation.error.not_found += chosen.cheapest ? 0 : 1;
    validation.budget.not_found += chosen.most_exact ? 0 : 1;
    const std::vector<Setting> retested = chosen.to_measure(chosen_on.settings);
    if (!retested.empty()) {
      const Study tried_on = measure_level(level, random_inputs(seed + 1, options.ticks), options_of(retested));
      const std::vector<Point> again = tried_on.points();
      const std::string where = chosen_on.level + ", run " + std::to_string(k + 1) + ", ";
      if (chosen.cheapest) {
        count(validation.error, again.front(), &Point::error_m, options.max_error_m, where + "error [m]",
              validation.violations);
      }
      if (chosen.most_exact) {
        count(validation.budget, again.back(), &Point::cost_us, options.budget_us, where + "cost [us]",
              validation.violations);
      }
    }
    validation.runs_with_grip += holds_a_cord(level.level(), random_inputs(seed + 1, options.ticks)) ? 1 : 0;
    progress(static_cast<double>(k + 1) / options.runs);
  }
  return validation;
}

Validation validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                                    const std::function<void(double)>& progress) {
  return validate_recommendations(levels, options, progress,
                                  [](const LevelFile& file, const std::vector<engine::TickInput>& inputs,
                                     const StudyOptions& how) { return measure(file, inputs, how); });
}

}  // namespace study
