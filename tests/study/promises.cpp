#include "tests/study/promises.h"

#include <random>

#include "game/buttons.h"

namespace study {
namespace {

constexpr int ticks = 120;
constexpr int repeats = 3;

StudyOptions quick_options() {
  StudyOptions options;
  options.quick = true;
  options.repeats = repeats;
  options.chains = false;  // which are never recommended
  return options;
}

}  // namespace

std::vector<engine::TickInput> random_inputs(unsigned seed, int count) {
  constexpr int held_for = 15;  // ticks, on average
  std::mt19937 random(seed);
  std::vector<engine::TickInput> inputs(static_cast<std::size_t>(count));
  std::uint16_t buttons = game::button_right;
  for (engine::TickInput& input : inputs) {
    if (random() % held_for == 0) {
      buttons = 0;
      for (const std::uint16_t button : {game::button_left, game::button_right, game::button_jump, game::button_grab}) {
        if (random() % 2 == 0) buttons = static_cast<std::uint16_t>(buttons | button);
      }
    }
    input.buttons = buttons;
  }
  return inputs;
}

Promises try_promises(const LevelFile& file, double max_error, double budget_us, int tries,
                      const std::function<void(double)>& progress) {
  Promises promises;
  for (int k = 0; k < tries; ++k) {
    const auto seed = static_cast<unsigned>(2 * k);
    const Study chosen_on = measure(file, random_inputs(seed, ticks), quick_options());
    const Study tried_on = measure(file, random_inputs(seed + 1, ticks), quick_options());
    const std::vector<Point> points = applicable(chosen_on);
    const std::vector<Point> again = tried_on.points();
    if (const auto chosen = cheapest_within(points, max_error)) {
      ++promises.error_tries;
      promises.errors_kept += again[*chosen].error_m <= max_error ? 1 : 0;
    }
    if (const auto chosen = most_exact_within(points, budget_us)) {
      ++promises.budget_tries;
      promises.budgets_kept += again[*chosen].cost_us <= budget_us ? 1 : 0;
    }
    progress(static_cast<double>(k + 1) / tries);
  }
  return promises;
}

}  // namespace study
