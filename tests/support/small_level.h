#pragma once

#include <utility>
#include <vector>

#include "engine/scene/tiled_map.h"
#include "game/simulation/level.h"
#include "ribbon/vec2.h"

/// Levels of a few objects, made in code. Lengths are in m.
namespace test_support {

using Property = std::pair<std::string, engine::Properties::Value>;

/// Returns an object of this class. `size`: of a rectangle or an ellipse; a point has none.
engine::MapObject object(const std::string& kind, engine::MapShape shape, ribbon::Vec2 position, ribbon::Vec2 size = {},
                         const std::vector<Property>& properties = {});
/// Returns a ground between two corners.
engine::MapObject ground(ribbon::Vec2 low, ribbon::Vec2 high, const std::vector<Property>& properties = {});
/// Returns a crate on its lower edge.
engine::MapObject crate(ribbon::Vec2 foot, ribbon::Vec2 size, double mass,
                        const std::vector<Property>& properties = {});
engine::MapObject hook(ribbon::Vec2 position);

/// Returns a level of 40 × 20 m with a player whose feet are at `feet`, a goal far away, and a floor up to y = 1.
game::Level small_level(ribbon::Vec2 feet, std::vector<engine::MapObject> objects,
                        const std::vector<Property>& properties = {});

}  // namespace test_support
