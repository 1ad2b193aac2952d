#pragma once

#include <cstdint>

#include "engine/window/window_input.h"

namespace game {

/// What was done in a menu, by keyboard, gamepad or mouse alike.
struct MenuInput {
  int down = 0;   ///< lines to go down; negative: up
  int right = 0;  ///< steps to the right; negative: to the left
  bool accept = false;
  bool back = false;
  bool mouse_moved = false;
  bool clicked = false;
  ribbon::Vec2 mouse{};  ///< px
};

/// Reads it. A direction that stays held is repeated, as a keyboard's keys are. The keys of menus cannot be rebound, so
/// that nobody locks himself out.
class MenuReader {
 public:
  MenuInput read(const engine::WindowInput& input, std::int64_t elapsed_ns);

 private:
  /// Keeps the time that one direction is held.
  class Repeat {
   public:
    int steps(bool pressed, bool held, std::int64_t elapsed_ns);

   private:
    std::int64_t left_ns_ = 0;  // until the next step
  };

  Repeat up_, down_, left_, right_;
};

}  // namespace game
