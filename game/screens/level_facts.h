#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/settings/records.h"
#include "game/simulation/level.h"
#include "game/simulation/medals.h"
#include "game/simulation/splits.h"

namespace game {

/// Returns the title of a level, or "First swing" for first_swing.
std::string level_title(const Level& level);
/// Returns all levels of the assets folder in their order. Skips levels that cannot be read, with a message on standard
/// error.
std::vector<Level> levels_in_order();
LevelKey level_key(const Level& level);

/// Returns "12.35 s, Gold" or "14.00 s with assists"; empty if there is no best run.
std::string best_in_words(const Level& level, const std::optional<Best>& best);
/// Returns the times at the checkpoints, each with its difference to the reference if that is known, two in a line:
/// "Checkpoint 1: 8.32 s (−0.42 s)   2: 12.05 s".
std::vector<std::string> splits_in_words(const Splits& splits, const Splits& reference);
/// Returns "Gold", "Silver", "Bronze" or an empty text.
std::string medal_title(Medal medal);
/// Returns the medal of a run; none for runs with assists.
Medal medal_of(const Level& level, const Best& run);

}  // namespace game
