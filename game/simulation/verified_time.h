#pragma once

#include <functional>
#include <optional>
#include <string>

#include "game/simulation/medals.h"

namespace game {

/// What a recording shows: the time to the flag, or why it shows none.
struct VerifiedTime {
  std::string fault;         ///< why the recording is not true; empty if it is
  std::string level;         ///< name; empty if the file is no recording
  std::string title;         ///< of the level, for the player
  int number = 0;            ///< of the level
  std::optional<int> ticks;  ///< until the flag; nothing if it was not reached
  bool assisted = false;     ///< with assists, or dragged by the pointer
  Medal medal = Medal::none;
};

/// Runs a recording of a level of the assets folder again and compares every tick. Of several runs in it, between
/// restarts, the best one counts; one without help is better than any with help. `report` is called with the share
/// that is done, 0 … 1. Does not throw for a bad recording: see `fault`.
VerifiedTime verify_time(const std::string& path, const std::function<void(double share)>& report = {});

}  // namespace game
