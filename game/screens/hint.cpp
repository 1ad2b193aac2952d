#include "game/screens/hint.h"

#include "game/screens/help.h"
#include "game/settings/action.h"
#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"

namespace game {
namespace {

constexpr int ticks_longer = 3 * ticks_per_second;

constexpr std::uint16_t need_a_rope = button_grab | button_up | button_down | button_reel_in | button_reel_out;

}  // namespace

void Hint::begin(const std::string& hint) {
  wanted_ = 0;
  for (const Action action : all_actions()) {
    if (hint.find(name_in_braces(action)) != std::string::npos)
      wanted_ = static_cast<std::uint16_t>(wanted_ | button_of(action));
  }
  any_ = wanted_ == 0;
  ticks_left_ = ticks_longer;
}

void Hint::tick(std::uint16_t buttons, bool holds) {
  const auto done = static_cast<std::uint16_t>(holds ? buttons : buttons & ~need_a_rope);
  wanted_ = static_cast<std::uint16_t>(wanted_ & ~done);
  if (buttons != 0) any_ = false;
  if (wanted_ == 0 && !any_ && ticks_left_ > 0) --ticks_left_;
}

}  // namespace game
