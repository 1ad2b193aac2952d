#pragma once

#include <optional>
#include <string>

namespace tradeoff {

/// The options of the standard report. Without `repeats`, costs are from 1 repeat in a quick report, and medians of 9,
/// or of the number in the scene, in a full one.
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
