#pragma once

#include "game/simulation/player.h"
#include "ribbon/box2d/coupling.h"

namespace game {

/// m, from the hand to a cord that the knife cuts: one at the feet is in reach.
inline constexpr double knife_reach = 2.2;

/// Cuts the cord nearest to the player's hand, within the reach, that it does not hold: one of the level, a line of the
/// other player, or one that it released or tied. If there is none, cuts the cord that it holds just below the hand.
/// Returns false if there is nothing to cut.
bool cut_by_hand(const Player& player, ribbon::box2d::Coupling& coupling);

}  // namespace game
