#pragma once

#include <cstdint>

#include "engine/window/window_input.h"

namespace game {

/// The input of a menu from keyboard, gamepad and mouse.
struct MenuInput {
  int down = 0;   ///< lines to go down; negative: up
  int right = 0;  ///< steps to the right; negative: to the left
  bool accept = false;
  bool back = false;
  bool mouse_moved = false;
  bool clicked = false;
  ribbon::Vec2 mouse{};  ///< px
};

/// Reads the input of menus. Directions that are held repeat, like the keys of a keyboard. The keys of menus are fixed,
/// so that menus work with any bindings.
class MenuReader {
 public:
  MenuInput read(const engine::WindowInput& input, std::int64_t elapsed_ns);

 private:
  /// The auto-repeat of one direction.
  class Repeat {
   public:
    int steps(bool pressed, bool held, std::int64_t elapsed_ns);

   private:
    std::int64_t left_ns_ = 0;  // until the next step
  };

  Repeat up_, down_, left_, right_;
};

}  // namespace game
