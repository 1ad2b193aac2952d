#pragma once

#include <optional>
#include <string>

#include "engine/window/window_input.h"
#include "game/settings/bindings.h"

namespace game {

/// Waits for the new input of an action. An input of another action must be pressed twice.
class Rebinding {
 public:
  explicit Rebinding(Action action) : action_(action) {}

  /// Handles the input of a frame. An input that the action already has is removed from it. Returns true when it is
  /// finished.
  bool take(const engine::WindowInput& input, Bindings& bindings);
  /// Returns the prompt for the player.
  std::string prompt(const Bindings& bindings) const;
  Action action() const { return action_; }

 private:
  Action action_;
  std::optional<engine::InputCode> contested_;
};

/// Returns the first code that was pressed in this frame.
std::optional<engine::InputCode> pressed_code(const engine::WindowInput& input);

}  // namespace game
