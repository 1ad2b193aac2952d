#pragma once

#include <cstdint>
#include <string>

#include "game/settings.h"

namespace game {

/// A sentence for the player, shown for a while at the bottom of whichever screen there is; a new one takes its place.
class Notice {
 public:
  void show(std::string sentence);
  void pass(std::int64_t nanoseconds);
  /// Empty: none.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::int64_t left_ns_ = 0;
};

/// What all screens share.
struct Session {
  Settings settings;
  Notice notice;
  bool uses_pad = false;  ///< the last thing that was pressed was on a gamepad: hints name its buttons
};

}  // namespace game
