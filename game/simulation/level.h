#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/scene/tiled_map.h"
#include "game/simulation/area.h"
#include "game/simulation/assists.h"
#include "game/simulation/place.h"

namespace game {

/// A sign with text in the world.
struct Sign {
  ribbon::Vec2 at;  ///< m, the middle of its foot
  std::string text;
};

/// The time limits of the medals in s; 0 if there is no such medal.
struct Medals {
  double gold = 0.0;
  double silver = 0.0;
  double bronze = 0.0;
};

/// A level as read from its map: the objects that are not in the scene, and the map to build the scene from.
struct Level {
  std::string name;
  std::string title;  ///< for the player; by default the name
  std::string hint;   ///< one sentence, may be empty
  int number = 0;     ///< position in the list of levels, from 1; 0: last
  Place place = Place::hills;
  bool sandbox = false;  ///< the pointer can drag bodies and cords without the debug view
  Medals medals;
  engine::TiledMap map;
  ribbon::Vec2 player_start;  ///< m, the middle of the player's feet
  double player_mass = 0.0;   ///< kg
  Assists assists;
  std::optional<Area> goal;  ///< none in a sandbox
  std::vector<Area> checkpoints;
  std::vector<ribbon::Vec2> hooks;  ///< m, targets for a thrown line
  std::vector<Sign> signs;

  /// Builds a new scene in its initial state.
  std::unique_ptr<engine::Scene> make_scene() const;
};

/// Returns the folder of levels and replays: the environment variable ROPESWING_ASSETS, or that of the source tree.
std::string assets_folder();

/// Loads assets/levels/NAME.tmj, or the file itself if the name ends in .tmj. In addition to the objects of
/// engine/scene/scene.h a map has
/// - one `player`: point, the middle of its feet; mass [kg], by default that of PlayerTuning
/// - one `goal`, or none in a sandbox: rectangle, at the foot of the flag; the player wins by touching the flag
/// - `checkpoint`: rectangle; after a fall the player returns to the foot of the last one that it entered
/// - `hook`: point at which a line can be thrown
/// - `text`: point, the foot of a sign; text
/// and properties of its own: title, hint (may name keys, see hint_in_words), number, sandbox, gold, silver, bronze
/// [s], place (hills, cave, harbour or storm; by default hills). Throws engine::MapError if the file does not exist, if
/// the map has other or invalid objects or properties, or if the scene cannot be built.
Level load_level(const std::string& name);

/// Returns the level of a map. Throws like load_level.
Level level_of(engine::TiledMap map);

/// Returns the names of the levels in the assets folder, sorted.
std::vector<std::string> level_names();

}  // namespace game
