#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/tick/input.h"
#include "engine/window/window_input.h"
#include "game/settings/settings.h"

namespace game {

/// Makes ticks' inputs of frames' inputs: what was pressed counts in the next tick, however short it was.
class Controls {
 public:
  static constexpr int wheel_ticks = 8;   ///< that a notch of the wheel holds its button
  static constexpr double pad_aim = 8.0;  ///< m, from the player to where a stick points

  /// A frame's input. `mouse` is its place in the world, m. `dragging`: the left button drags cords and does nothing
  /// else.
  void take(const engine::WindowInput& input, const Settings& settings, ribbon::Vec2 mouse, bool dragging);
  /// The next tick's, for a player whose hand is there, m.
  engine::TickInput next(ribbon::Vec2 hand);
  /// What was pressed and not yet used is not meant for later, what is still down from a menu is not meant for the
  /// player until it was up, and a grab by a press is over.
  void forget();
  /// Only what was pressed is forgotten: who goes tick by tick holds down what the next one is to have.
  void forget_presses();

 private:
  void take_aim(const engine::WindowInput& input, ribbon::Vec2 mouse);
  void toggle_grab(bool wanted);

  std::uint16_t held_ = 0;
  std::uint16_t tapped_ = 0;
  std::uint16_t stale_ = 0;                     // down since a menu
  bool forgot_ = false;                         // and was not asked since
  bool grabs_ = false;                          // where a press holds on until the next
  std::array<int, action_count> wheel_left_{};  // ticks
  ribbon::Vec2 mouse_{};                        // m
  std::optional<ribbon::Vec2> stick_;           // where it last pointed, 1 long; none: the mouse aims
};

}  // namespace game
