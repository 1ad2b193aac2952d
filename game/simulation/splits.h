#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/simulation/simulation.h"

namespace game {

/// The ticks of a run when it first entered each checkpoint of the level; nothing for one that it did not enter.
using Splits = std::vector<std::optional<int>>;

/// Notes the splits of a run. It does not change the run.
class SplitTimer {
 public:
  /// Call it after each tick. Returns the checkpoint that the run entered for the first time, if it did.
  std::optional<std::size_t> update(const Simulation& simulation);
  const Splits& splits() const { return splits_; }

 private:
  Splits splits_;
  int run_ticks_ = 0;
};

/// Returns the difference of two times with its sign: "+0.42 s", "−1.05 s", "±0.00 s".
std::string difference_in_words(int ticks, int reference);

}  // namespace game
