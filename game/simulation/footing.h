#pragma once

#include <box2d/box2d.h>

#include "game/simulation/player_tuning.h"
#include "ribbon/box2d/coupling.h"

namespace game {

/// What a player stands on.
struct Footing {
  bool is_ground = false;  ///< there is something to stand on
  bool is_firm = false;    ///< level static ground
  bool is_cord = false;    ///< a solid cord
  double rise = 0.0;       ///< m/s, upwards, of what it stands on
};

/// Returns what the body of a player stands on, by the contacts of the last step. A solid cord counts once it has
/// stopped the fall: a jump before that would waste the energy that the cord stores.
Footing find_footing(const b2Body& player, const ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning);

}  // namespace game
