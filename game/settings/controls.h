#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/tick/input.h"
#include "engine/window/window_input.h"
#include "game/settings/settings.h"

namespace game {

/// Converts the inputs of frames to those of ticks. Each press counts in the next tick, however short it was.
class Controls {
 public:
  static constexpr int wheel_ticks = 8;   ///< ticks for which a notch of the wheel holds its button
  static constexpr double pad_aim = 8.0;  ///< m, from the player to the point at which a stick aims

  /// Adds the input of a frame. `mouse`: its position in the world, m; nothing for a player that has none, and aims
  /// only with a stick. `dragging`: the left button only drags.
  void take(const engine::WindowInput& input, const Settings& settings, std::optional<ribbon::Vec2> mouse,
            bool dragging) {
    take(input, settings.bindings, settings.toggle_grab, mouse, dragging);
  }
  /// The same with other bindings than those of the settings. `toggles_grab`: see Settings::toggle_grab.
  void take(const engine::WindowInput& input, const Bindings& bindings, bool toggles_grab,
            std::optional<ribbon::Vec2> mouse, bool dragging);
  /// Returns what the player aims at, m: with the stick or the mouse, whichever it used last. `hand`: the position of
  /// its hand, m.
  std::optional<ribbon::Vec2> pointer(ribbon::Vec2 hand) const;
  /// Returns the input of the next tick of the first player. `hand`: the position of its hand, m.
  engine::TickInput next(ribbon::Vec2 hand);
  /// Discards unused presses, ignores buttons that are still down from a menu until they are up, and ends a toggled
  /// grab.
  void discard();
  /// Ignores the keys that are held, until each is up, and ends a toggled grab: after a fall
  /// they would act on what they were not meant for.
  void ignore_held();
  /// Discards unused presses only. For single steps, in which a button that is held counts.
  void discard_presses();

 private:
  void take_aim(const engine::WindowInput& input, std::optional<ribbon::Vec2> mouse);
  void toggle_grab(bool wanted);

  std::uint16_t held_ = 0;
  std::uint16_t tapped_ = 0;
  std::uint16_t stale_ = 0;                     // held since before discard(), ignored
  bool discarded_ = false;                      // since the last take()
  bool grabs_ = false;                          // toggled on
  std::array<int, action_count> wheel_left_{};  // ticks
  std::optional<ribbon::Vec2> mouse_;           // m
  std::optional<ribbon::Vec2> stick_;           // its last direction, a unit vector; none: the mouse aims
};

}  // namespace game
