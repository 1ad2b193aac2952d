#pragma once

#include <optional>
#include <string>

#include "game/level.h"
#include "game/medals.h"
#include "game/records.h"

namespace game {

/// What a level is called: "First swing" for first_swing.
std::string level_title(const Level& level);
std::optional<Medals> level_medals(const Level& level);
LevelKey level_key(const Level& level);

/// "12.35 s, Gold", "14.00 s with help"; empty: not won yet.
std::string best_in_words(const Level& level, const std::optional<Best>& best);
/// The medal that a run gets: none for one with assists.
Medal medal_of(const Level& level, const Best& run);

}  // namespace game
