#pragma once

#include "engine/replay/replay.h"
#include "game/simulation/level.h"

namespace game {

/// Returns the header of a replay of this level.
engine::ReplayHeader replay_header(const Level& level);

/// Sets the assists and the yard of the level to those that the replay declares. What it cannot have stays out, so that
/// the headers differ.
void take_settings(Level& level, const engine::ReplayHeader& header);

}  // namespace game
