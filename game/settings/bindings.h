#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/window/window_input.h"
#include "game/settings/action.h"

namespace game {

/// The bindings of inputs to actions. Each input code has at most one action; an action may have several codes.
class Bindings {
 public:
  /// Makes empty bindings.
  Bindings() = default;
  static Bindings defaults();
  /// The keys of the second player of a level for two: the half of the keyboard around the arrows. Shift and ctrl are
  /// those of its side.
  static Bindings second_defaults();

  const std::vector<engine::InputCode>& codes(Action action) const { return codes_[index(action)]; }
  std::optional<Action> action_of(const engine::InputCode& code) const;

  /// Adds a code to the action and removes it from any other.
  void bind(Action action, const engine::InputCode& code);
  void unbind(const engine::InputCode& code);

  bool held(Action action, const engine::WindowInput& input) const;
  bool pressed(Action action, const engine::WindowInput& input) const;

  bool operator==(const Bindings&) const = default;

 private:
  static std::size_t index(Action action) { return static_cast<std::size_t>(action); }

  std::array<std::vector<engine::InputCode>, action_count> codes_;
};

/// Returns the codes of an action for the player: "Space", "A or Left", "none". `of_pad`: those of the gamepad, else
/// those of keyboard and mouse. At most `max_codes` of them.
std::string codes_in_words(const Bindings& bindings, Action action, bool of_pad, std::size_t max_codes = 2);

}  // namespace game
