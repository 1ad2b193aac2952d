#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/window/window_input.h"
#include "game/settings/action.h"

namespace game {

/// Which keys and buttons do what. One code belongs to one action at most; an action may have any number of codes.
class Bindings {
 public:
  /// Nothing is bound.
  Bindings() = default;
  static Bindings defaults();

  const std::vector<engine::InputCode>& codes(Action action) const { return codes_[index(action)]; }
  std::optional<Action> action_of(const engine::InputCode& code) const;

  /// Adds a code to those of the action, taking it from whichever had it.
  void bind(Action action, const engine::InputCode& code);
  void unbind(const engine::InputCode& code);

  bool held(Action action, const engine::WindowInput& input) const;
  bool pressed(Action action, const engine::WindowInput& input) const;

  bool operator==(const Bindings&) const = default;

 private:
  static std::size_t index(Action action) { return static_cast<std::size_t>(action); }

  std::array<std::vector<engine::InputCode>, action_count> codes_;
};

/// Those of one device, as a player reads them: "Space", "A or Left", "none". Not all if there are more than `most`.
std::string codes_in_words(const Bindings& bindings, Action action, bool of_pad, std::size_t most = 2);

}  // namespace game
