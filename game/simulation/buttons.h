#pragma once

#include <cstdint>

namespace game {

/// The bits of engine::TickInput::buttons. Replays record them: add new ones at the end, never renumber.
enum Button : std::uint16_t {
  button_left = 1U << 0,
  button_right = 1U << 1,
  button_jump = 1U << 2,
  button_grab = 1U << 3,           ///< held: catch the nearest cord point and hold it
  button_restart = 1U << 4,        ///< restart the level
  button_drag = 1U << 5,           ///< held: the body or cord point nearest to the pointer follows it
  button_up = 1U << 6,             ///< held: climb up the cord
  button_down = 1U << 7,           ///< held: slide down the cord
  button_throw = 1U << 8,          ///< throw a line at a hook, or release the line that is held
  button_reel_in = 1U << 9,        ///< held: shorten the line
  button_reel_out = 1U << 10,      ///< held: lengthen the line
  button_retry = 1U << 11,         ///< return to the last checkpoint
  button_cut = 1U << 12,           ///< cut a cord, in a level with a knife
  button_throw_second = 1U << 13,  ///< as button_throw, with the line of the second hand, if the player has two
  button_tie = 1U << 14,           ///< tie two held lines together, or one to a hook or a sticky surface at hand
};

}  // namespace game
