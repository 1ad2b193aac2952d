#pragma once

#include <cstdint>

namespace game {

/// What the bits of engine::TickInput::buttons mean. Replays hold them: add at the end, never renumber.
enum Button : std::uint16_t {
  button_left = 1U << 0,
  button_right = 1U << 1,
  button_jump = 1U << 2,
  button_grab = 1U << 3,     ///< held: catch the nearest cord point and hang on to it
  button_restart = 1U << 4,  ///< the level begins anew
  button_drag = 1U << 5,     ///< held: the body or cord point nearest to the pointer follows it
  button_up = 1U << 6,       ///< held: climb the cord
  button_down = 1U << 7,     ///< held: slide down it
  button_throw = 1U << 8,    ///< throws a line at a hook, or lets the one that is held go
  button_reel_in = 1U << 9,  ///< held: the line gets shorter
  button_reel_out = 1U << 10,
  button_retry = 1U << 11,  ///< the player goes back to the last checkpoint
};

}  // namespace game
