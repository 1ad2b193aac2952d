#pragma once

#include <optional>
#include <string>

#include "engine/window/window_input.h"
#include "game/settings/bindings.h"

namespace game {

/// Waits for what a player presses for an action, and asks again if it belongs to another one.
class Rebinding {
 public:
  explicit Rebinding(Action action) : action_(action) {}

  /// A frame's input. A key of another action is asked for twice; one that the action has already is taken from it.
  /// True when there is no more to wait for.
  bool take(const engine::WindowInput& input, Bindings& bindings);
  /// What to tell the player.
  std::string prompt(const Bindings& bindings) const;
  Action action() const { return action_; }

 private:
  Action action_;
  std::optional<engine::InputCode> contested_;
};

/// The first code that was pressed in this frame.
std::optional<engine::InputCode> pressed_code(const engine::WindowInput& input);

}  // namespace game
