#pragma once

#include <optional>

#include "engine/scene/scene.h"
#include "game/simulation/level.h"
#include "game/simulation/player.h"
#include "game/simulation/target.h"
#include "ribbon/vec2.h"

namespace game {

/// Returns the target of a throw: the hook near the pointer [m], if there is one, else the sticky surface in the
/// direction of the pointer, else a hook or a sticky surface ahead of the player and above it, all within the throw
/// range of its hand. What is in front of a surface hides it.
std::optional<Target> aimed_target(const Level& level, const engine::Scene& scene, const Player& player,
                                   std::optional<ribbon::Vec2> pointer);

/// Returns the hook, or else the place on a sticky surface, that is nearest to the hand of the player, within its
/// reach.
std::optional<Target> target_at_hand(const Level& level, const engine::Scene& scene, const Player& player);

}  // namespace game
