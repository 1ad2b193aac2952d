#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/scene/tiled_map.h"
#include "game/simulation/area.h"
#include "game/simulation/assists.h"
#include "game/simulation/level_rules.h"
#include "game/simulation/place.h"
#include "game/simulation/yard.h"

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

/// The second player of a level for two.
struct SecondPlayer {
  ribbon::Vec2 start;  ///< m, the middle of its feet
  double mass = 0.0;   ///< kg
  int tether = 0;      ///< id of the cord whose ends both players hold; 0: they are not tied together
};

/// A level as read from its map: the objects that are not in the scene, and the map to build the scene from.
struct Level {
  std::string name;
  std::string title;  ///< for the player; by default the name
  std::string hint;   ///< one sentence, may be empty
  int number = 0;     ///< position in the list of levels, from 1; 0: last
  Place place = Place::hills;
  bool sandbox = false;  ///< the pointer can drag bodies and cords without the debug view
  int lines = 1;         ///< that the player can hold at once, 1 … 2
  /// Of thrown lines; none: LineTuning::accuracy. A map can set its substeps and tolerance.
  std::optional<ribbon::Accuracy> line_accuracy{};
  Medals medals;
  engine::TiledMap map;
  ribbon::Vec2 player_start;           ///< m, the middle of the player's feet
  double player_mass = 0.0;            ///< kg
  std::optional<SecondPlayer> second;  ///< only in a level for two
  Assists assists;
  std::optional<Area> goal;  ///< none in a sandbox
  std::vector<Area> checkpoints;
  std::vector<ribbon::Vec2> hooks;  ///< m, targets for a thrown line
  std::vector<Sign> signs;
  LevelRules rules;
  Yard yard;  ///< what the player has placed in a sandbox; set_yard() changes it

  /// The number of players, 1 or 2.
  int players() const { return second ? 2 : 1; }
  /// Builds a new scene in its initial state.
  std::unique_ptr<engine::Scene> make_scene() const;
};

/// Returns the cord of a new scene of the level that ties the players together; nothing if there is none.
std::optional<ribbon::box2d::CordId> tether_of(const Level& level, const engine::Scene& scene);

/// Returns the folder of levels and replays: the environment variable ROPESWING_ASSETS, or that of the source tree.
std::string assets_folder();

/// Loads assets/levels/NAME.tmj, or the file itself if the name ends in .tmj. In addition to the objects of
/// engine/scene/scene.h a map has
/// - one `player`: point, the middle of its feet; mass [kg], by default that of PlayerTuning
/// - one `player_2` in a level for two: point, likewise; mass; tether (optional: the rope of the direct solver between
///   the two, whose first point is within 0.5 m of the middle of player's body, and its last one of that of player_2's)
/// - one `goal`, or none in a sandbox: rectangle, at the foot of the flag; the player wins by touching the flag
/// - `checkpoint`: rectangle; after a fall the player returns to the foot of the last one that it entered
/// - `hook`: point at which a line can be thrown
/// - `text`: point, the foot of a sign; text
/// - `blade`: polyline or rectangle, whose edges cut the cords of the map that meet them, those of the direct solver,
///   but for half a link at their ends; body (optional: the ground, circle or load that carries it)
/// - `fire`: rectangle; a place of such a cord that stays in it for `seconds` [s, 0.05 … 600, by default 1] burns
///   through; the player dies in it, as by a fall
/// - `spikes`: rectangle, in which the player dies
/// - `chaser`: rectangle, or ellipse as wide as high, that follows a path from the place nearest to its centre, an open
///   one up to its end, and kills the player that it touches; path, speed [m/s, by default 3], from_x [m; optional: it
///   waits until the player passes this x], cord (optional: it falls where it is over this cord, if that is cut or
///   broken). After a death it is back at its start
/// - `coin`: point; the player collects it by touch, and keeps it after a fall
/// and properties of its own: title, hint (may name keys, see hint_in_words), number, sandbox, lines,
/// line_substeps and line_tolerance (of thrown lines, as those of a cord), gold, silver,
/// bronze [s], knife (the player can cut cords; false by default), place (hills, cave, harbour or storm; by default
/// hills). Bodies and the player float in the water of the map; see WaterForces. A line can be thrown at bodies with
/// the property `sticky` too. Throws engine::MapError if the file does not exist, if the map has other or invalid
/// objects or properties, or if the scene cannot be built.
Level load_level(const std::string& name);

/// Returns the level of a map. Throws like load_level.
Level level_of(engine::TiledMap map);

/// Returns the names of the levels in the assets folder, sorted.
std::vector<std::string> level_names();

}  // namespace game
