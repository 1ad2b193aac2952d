#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/settings/records.h"
#include "game/simulation/level.h"
#include "game/simulation/medals.h"

namespace game {

/// What a level is called: its title, or "First swing" for first_swing.
std::string level_title(const Level& level);
/// "Gold 12.00 s   Silver 15.00 s   Bronze 20.00 s"; empty if the level has none.
std::string medals_in_words(const Level& level);
/// All levels of the assets folder, in the order in which they are to be played. One that cannot be read is left out,
/// and standard error says why.
std::vector<Level> levels_in_order();
LevelKey level_key(const Level& level);

/// "12.35 s, Gold", "14.00 s with help"; empty: not won yet.
std::string best_in_words(const Level& level, const std::optional<Best>& best);
/// The medal that a run gets: none for one with assists.
Medal medal_of(const Level& level, const Best& run);

}  // namespace game
