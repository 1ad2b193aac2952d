#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/scene/tiled_map.h"
#include "game/simulation/assists.h"

namespace game {

/// A part of the level where something happens to who enters it.
struct Area {
  ribbon::Vec2 center;  ///< m
  ribbon::Vec2 size;    ///< m
  bool holds(ribbon::Vec2 point) const {
    return std::abs(point.x - center.x) <= 0.5 * size.x && std::abs(point.y - center.y) <= 0.5 * size.y;
  }
};

/// Words that stand in the world.
struct Sign {
  ribbon::Vec2 at;  ///< m, the middle of its foot
  std::string text;
};

/// s, in which a run is worth a medal; 0 where there is none.
struct Medals {
  double gold = 0.0;
  double silver = 0.0;
  double bronze = 0.0;
};

/// A level as read from its map: what the scene does not know of, and the map to build the scene from.
struct Level {
  std::string name;
  std::string title;     ///< as players read it; the name unless given
  std::string hint;      ///< one sentence, may be empty
  int number = 0;        ///< its place among the levels, from 1; 0 comes last
  bool sandbox = false;  ///< the pointer drags what it can get hold of, without being asked for
  Medals medals;
  engine::TiledMap map;
  ribbon::Vec2 player_start;  ///< m, the middle of the player's feet
  double player_mass = 0.0;   ///< kg
  Assists assists;
  Area goal;
  std::vector<Area> checkpoints;
  std::vector<ribbon::Vec2> hooks;  ///< m, where a thrown line catches
  std::vector<Sign> signs;

  /// A new world with everything where the map has it.
  std::unique_ptr<engine::Scene> make_scene() const;
};

/// The folder of levels and replays: the environment's ROPESWING_ASSETS, or the source tree's.
std::string assets_folder();

/// Loads assets/levels/NAME.tmj, or the file itself if the name ends in .tmj. Beside what engine/scene/scene.h says a
/// map has
/// - one `player`: point, the middle of its feet; mass [kg], that of PlayerTuning unless given
/// - one `goal`: rectangle
/// - `checkpoint`: rectangle; who falls comes back to the foot of the last one that he entered
/// - `hook`: point at which a line can be thrown
/// - `text`: point, the foot of a sign; text, what it says
/// and properties of its own: title, hint (which may name keys, see hint_in_words), number, sandbox, gold, silver,
/// bronze [s]. Throws engine::MapError if there is no such file, if the map has anything else or these otherwise, or if
/// the scene cannot be built.
Level load_level(const std::string& name);

/// The level that a map is. Throws as load_level does.
Level level_of(engine::TiledMap map);

/// The names of the levels in the assets folder, sorted.
std::vector<std::string> level_names();

}  // namespace game
