#pragma once

#include <box2d/box2d.h>

#include <optional>

#include "game/simulation/player_tuning.h"
#include "ribbon/vec2.h"

namespace game {

/// The edge of a ledge that a hand can hold.
struct Ledge {
  ribbon::Vec2 edge;  ///< m, where the wall meets the level top
  int side = 1;       ///< of the wall: 1 to the right of the player, −1 to the left
};

/// Returns the edge of a level ledge of static ground within reach of a player's hand [m], on this side: 1 right, −1
/// left.
std::optional<Ledge> find_ledge(const b2Body& player, ribbon::Vec2 hand, int side, const PlayerTuning& tuning);

}  // namespace game
