#pragma once

#include <cstdint>
#include <string>

namespace game {

/// Whether the hint of a level is shown: from the start of a run until the player has done what it names, and a moment
/// longer. What needs a rope in the hand (to grab, climb, reel) counts only with one.
class Hint {
 public:
  /// Begins with a hint that names actions in braces, as in "hold {grab}". One that names none is done by any button.
  void begin(const std::string& hint);
  /// Takes the buttons of a tick. `holds`: the player holds a rope or its line after the tick.
  void tick(std::uint16_t buttons, bool holds);
  bool is_shown() const { return ticks_left_ > 0; }

 private:
  std::uint16_t wanted_ = 0;  // buttons that were not pressed yet
  bool any_ = false;          // any button will do
  int ticks_left_ = 0;
};

}  // namespace game
