#include "game/simulation/splits.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace game {

std::optional<std::size_t> SplitTimer::update(const Simulation& simulation) {
  const bool restarted = simulation.run_ticks() <= run_ticks_;
  run_ticks_ = simulation.run_ticks();
  const std::size_t count = simulation.level().checkpoints.size();
  if (restarted || splits_.size() != count) splits_.assign(count, std::nullopt);
  const auto entered = simulation.checkpoint();
  if (!entered || splits_[*entered]) return std::nullopt;
  splits_[*entered] = run_ticks_;
  return entered;
}

std::string difference_in_words(int ticks, int reference) {
  const int difference = ticks - reference;
  const char* const sign = difference > 0 ? "+" : difference < 0 ? "−" : "±";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%s%.2f s", sign, std::abs(difference) / (1.0 * ticks_per_second));
  return text.data();
}

}  // namespace game
