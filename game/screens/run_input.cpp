#include "game/screens/run_input.h"

#include "game/settings/two_players.h"
#include "game/simulation/buttons.h"

namespace game {

void RunInput::take(const engine::WindowInput& input, const Settings& settings, ribbon::Vec2 mouse, bool dragging,
                    int players) {
  if (players == 1) return first_.take(input, settings, mouse, dragging);
  first_.take(input_of(0, input), bindings_of(0, settings), settings.toggle_grab, mouse, dragging);
  second_.take(input_of(1, input), bindings_of(1, settings), settings.toggle_grab, std::nullopt, false);
}

engine::TickInput RunInput::next(const Simulation& simulation) {
  engine::TickInput input = first_.next(simulation.player().hand());
  if (simulation.players() == 2) {
    const ribbon::Vec2 hand = simulation.player(1).hand();
    input.second_buttons = second_.next(hand).buttons;
    if (const auto at = second_.pointer(hand)) engine::set_second_pointer(input, *at);
  }
  input.buttons &= static_cast<std::uint16_t>(~button_restart);
  input.second_buttons &= static_cast<std::uint16_t>(~button_restart);
  return input;
}

void RunInput::discard() {
  first_.discard();
  second_.discard();
}

void RunInput::discard_presses() {
  first_.discard_presses();
  second_.discard_presses();
}

void RunInput::ignore_held() {
  first_.ignore_held();
  second_.ignore_held();
}

}  // namespace game
