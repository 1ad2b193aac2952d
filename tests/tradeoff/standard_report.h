#pragma once

#include <optional>
#include <string>

#include "tests/study/shard.h"

namespace tradeoff {

/// The options of the standard report. Without `repeats`, costs are from 1 repeat in a quick report, and medians of 9,
/// or of the number in the scene, in a full one.
struct StandardReport {
  std::string folder;
  bool quick = false;
  std::optional<int> repeats;
  study::Shard shard;  ///< of the pages
};

/// Writes a page for each standard scene and for each level of the game, in a folder of its name, and a page of
/// contents after each. A shard writes a part of the pages, and a page of contents of all, so that the folders of all
/// shards, copied into one, are the report. Writes all pages even if a plot cannot be drawn. Returns the program's exit
/// status: 1 if it was interrupted, or if a plot is missing. Throws std::runtime_error if the path is not a folder or
/// cannot be written.
int write(const StandardReport& report);

}  // namespace tradeoff
