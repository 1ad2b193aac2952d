#pragma once

#include <box2d/box2d.h>

#include "game/simulation/player.h"
#include "ribbon/vec2.h"

namespace game {

/// Makes the Box2D body of a player, a capsule that does not rotate. `feet`: the middle of the soles, m.
b2Body* make_player_body(b2World& world, ribbon::Vec2 feet, const PlayerTuning& tuning);

}  // namespace game
