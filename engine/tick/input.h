#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "ribbon/vec2.h"

namespace engine {

/// One tick's input: everything a player can tell the simulation, and what a replay records of it.
/// Integers on purpose: the simulation sees the very value the replay holds.
struct TickInput {
  std::uint16_t buttons = 0;  ///< One bit a button; which one means what is the game's.
  std::int16_t pointer_x_cm = 0;
  std::int16_t pointer_y_cm = 0;

  bool operator==(const TickInput&) const = default;
};
static_assert(sizeof(TickInput) == 6);

/// A length in metres to the nearest whole centimetre (halves away from zero), clamped to −327.68 .. 327.67 m;
/// not-a-number counts as 0.
inline std::int16_t quantise_cm(double metres) {
  using Limits = std::numeric_limits<std::int16_t>;
  const double cm = std::round(metres * 100.0);
  if (std::isnan(cm)) return 0;
  if (cm <= Limits::min()) return Limits::min();
  if (cm >= Limits::max()) return Limits::max();
  return static_cast<std::int16_t>(cm);
}

/// Points `input` at a world position in metres, quantised as by quantise_cm().
inline void set_pointer(TickInput& input, ribbon::Vec2 world) {
  input.pointer_x_cm = quantise_cm(world.x);
  input.pointer_y_cm = quantise_cm(world.y);
}

/// The world position, in metres, that `input` points at.
inline ribbon::Vec2 pointer(const TickInput& input) { return {input.pointer_x_cm / 100.0, input.pointer_y_cm / 100.0}; }

}  // namespace engine
