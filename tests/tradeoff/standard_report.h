#pragma once

#include <optional>
#include <string>

namespace tradeoff {

/// What the standard report runs. Unless `repeats` says otherwise, costs are the median of 1 in a quick one, and of 9
/// or what a scene says in a whole one.
struct StandardReport {
  std::string folder;
  bool quick = false;
  std::optional<int> repeats;
};

/// Scenes that others are measured on too, and all levels of the game: a page each in folders of their names, and one
/// of contents, rewritten with each. Returns the program's exit status: 1 if it was interrupted, or if a plot
/// could not be drawn, which keeps no page from being written. Throws std::runtime_error
/// for a folder that is none or cannot be written.
int write(const StandardReport& report);

}  // namespace tradeoff
