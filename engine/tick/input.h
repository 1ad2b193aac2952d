#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "ribbon/vec2.h"

namespace engine {

/// The input of one tick: everything that the players control in the simulation. A replay records it.
/// All fields are integers, so that the recorded value is exactly the one that the simulation reads.
struct TickInput {
  std::uint16_t buttons = 0;  ///< One bit per button; the game defines their meaning.
  std::int16_t pointer_x_cm = 0;
  std::int16_t pointer_y_cm = 0;
  std::uint16_t second_buttons = 0;  ///< Those of the second player; a run of one player ignores them.

  bool operator==(const TickInput&) const = default;
};
static_assert(sizeof(TickInput) == 8);

/// Rounds a length in metres to whole centimetres (halves away from zero), clamped to −327.68 … 327.67 m. NaN gives 0.
inline std::int16_t quantise_cm(double metres) {
  using Limits = std::numeric_limits<std::int16_t>;
  const double cm = std::round(metres * 100.0);
  if (std::isnan(cm)) return 0;
  if (cm <= Limits::min()) return Limits::min();
  if (cm >= Limits::max()) return Limits::max();
  return static_cast<std::int16_t>(cm);
}

/// Sets the pointer of `input` to a world position in metres, rounded by quantise_cm().
inline void set_pointer(TickInput& input, ribbon::Vec2 world) {
  input.pointer_x_cm = quantise_cm(world.x);
  input.pointer_y_cm = quantise_cm(world.y);
}

/// Returns the world position of the pointer, in metres.
inline ribbon::Vec2 pointer(const TickInput& input) { return {input.pointer_x_cm / 100.0, input.pointer_y_cm / 100.0}; }

}  // namespace engine
