#pragma once

#include <optional>
#include <vector>

#include "engine/scene/scene_paths.h"
#include "engine/scene/tiled_map.h"
#include "game/simulation/area.h"
#include "ribbon/vec2.h"

namespace game {

/// An edge that cuts cords.
struct Blade {
  std::vector<ribbon::Vec2> edge;  ///< m, at the start; that of a rectangle ends with its first corner
  int body = 0;                    ///< id of the object that carries it; 0: it does not move
};

/// A place where cords burn and the player dies.
struct Fire {
  Area area;
  int ticks = 0;  ///< after which a place of a cord in it burns through
};

/// What follows a track, and kills the player that it touches.
struct Chaser {
  engine::Track track;
  double start = 0.0;            ///< m along the track
  double speed = 0.0;            ///< m/s
  Area area;                     ///< at the start
  bool round = false;            ///< a disc of the width of the area; else the area
  std::optional<double> from_x;  ///< m, at which the player sets it off; none: it starts with the run
  int cord = 0;                  ///< id of the object that it needs below it; 0: none
};

/// What the rules of a level work on.
struct LevelRules {
  std::vector<Blade> blades;
  std::vector<Fire> fires;
  std::vector<Area> spikes;
  std::vector<Chaser> chasers;
  std::vector<ribbon::Vec2> coins;   ///< m
  std::vector<engine::Track> rails;  ///< on which circles of the scene ride, to be drawn
  bool knife = false;                ///< the player can cut cords
};

/// Reads the objects of the classes blade, fire, spikes, chaser and coin, and the property `knife` of the map;
/// game/simulation/level.h describes them. Throws engine::MapError for a shape, property or value that is not accepted.
LevelRules read_rules(const engine::TiledMap& map);

}  // namespace game
