#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene.h"
#include "engine/tiled_map.h"

namespace game {

/// A level as read from its map: what the scene does not know of, and the map to build the scene from.
struct Level {
  std::string name;
  engine::TiledMap map;
  ribbon::Vec2 player_start;  ///< m, the middle of the player's feet
  double player_mass = 0.0;   ///< kg
  /// m; none: that of PlayerTuning. Not of the map: an assist, which replays declare.
  std::optional<double> player_reach{};
  ribbon::Vec2 goal_center;  ///< m
  ribbon::Vec2 goal_size;    ///< m

  /// A new world with everything where the map has it.
  std::unique_ptr<engine::Scene> make_scene() const;
};

/// The folder of levels and replays: the environment's ROPESWING_ASSETS, or the source tree's.
std::string assets_folder();

/// Loads assets/levels/NAME.tmj, or the file itself if the name ends in .tmj. Throws engine::MapError if there is none,
/// if it has not exactly one `player` (a point; mass [kg], that of PlayerTuning unless given) and one `goal` (a
/// rectangle), or if the scene cannot be built.
Level load_level(const std::string& name);

/// The level that a map is. Throws as load_level does.
Level level_of(engine::TiledMap map);

/// The names of the levels in the assets folder, sorted.
std::vector<std::string> level_names();

}  // namespace game
