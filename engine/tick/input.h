#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "ribbon/vec2.h"

namespace engine {

/// The input of one tick: everything that the players control in the simulation. A replay records it.
/// All fields are integers, so that the recorded value is exactly the one that the simulation reads.
struct TickInput {
  std::uint16_t buttons = 0;  ///< One bit per button; the game defines their meaning.
  std::int16_t pointer_x_cm = 0;
  std::int16_t pointer_y_cm = 0;
  std::uint16_t second_buttons = 0;  ///< Those of the second player; a run of one player ignores them.
  std::int16_t second_pointer_x_cm = 0;
  std::int16_t second_pointer_y_cm = 0;
  bool second_has_pointer = false;  ///< Whether the second player has a pointer: it aims with a stick.

  bool operator==(const TickInput&) const = default;
};
static_assert(sizeof(TickInput) == 14);

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

/// The same for the pointer of the second player, which it has then.
inline void set_second_pointer(TickInput& input, ribbon::Vec2 world) {
  input.second_pointer_x_cm = quantise_cm(world.x);
  input.second_pointer_y_cm = quantise_cm(world.y);
  input.second_has_pointer = true;
}

/// Returns the world position of the pointer, in metres.
inline ribbon::Vec2 pointer(const TickInput& input) { return {input.pointer_x_cm / 100.0, input.pointer_y_cm / 100.0}; }

/// Returns that of the second player; nothing if it has none.
inline std::optional<ribbon::Vec2> second_pointer(const TickInput& input) {
  if (!input.second_has_pointer) return std::nullopt;
  return ribbon::Vec2{input.second_pointer_x_cm / 100.0, input.second_pointer_y_cm / 100.0};
}

}  // namespace engine
