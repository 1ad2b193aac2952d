#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/pulley.h"
#include "ribbon/vec2.h"

/// Random scenes: definition, generation, playing, judging, shrinking and printing.
namespace any_scene {

/// Those of ribbon::Accuracy, and `balanced` with a budget of work of 20,000, of which a substep may be halved.
enum class Preset : unsigned char { fast, balanced, accurate, ample };
inline constexpr std::array all_presets = {Preset::fast, Preset::balanced, Preset::accurate, Preset::ample};
/// The presets that a seed chooses from.
inline constexpr std::array usual_presets = {Preset::fast, Preset::balanced, Preset::accurate};
enum class Motion : unsigned char { fixed, dynamic, kinematic };
enum class Shape : unsigned char { circle, box, edge };

/// Returns "fast", "balanced", "accurate" or "ample".
std::string_view name(Preset preset);
ribbon::Accuracy accuracy_of(Preset preset);

/// A rigid body with one fixture around its origin.
struct Solid {
  Motion motion = Motion::fixed;
  Shape shape = Shape::circle;
  ribbon::Vec2 position;          ///< m
  double angle = 0.0;             ///< rad
  ribbon::Vec2 half{0.2, 0.2};    ///< m: x is a circle's radius or half an edge's length; x, y are half a box's sides
  double density = 1.0;           ///< kg/m²
  double friction = 0.0;          ///< 0 … 1
  double restitution = 0.0;       ///< 0 … 1
  ribbon::Vec2 velocity;          ///< m/s
  double angular_velocity = 0.0;  ///< rad/s
  double belt_speed = 0.0;        ///< m/s, of its surface: see ribbon::box2d::Surface::tangent_speed

  bool operator==(const Solid&) const = default;
};

/// A cord and its initial velocity, uniform over all points.
struct SceneCord {
  ribbon::CordDef def;          ///< with positions; the scene's preset sets the accuracy
  ribbon::Vec2 velocity;        ///< m/s
  bool other_softness = false;  ///< Accuracy::soft_contacts is the opposite of the preset's
  int family = -1;              ///< pieces of one cord have the same; −1 for a whole one. For the oracles
  bool split = false;           ///< it touches no other piece of its family. For the oracles
  int cut_from = -1;            ///< index of the cord from whose last column it was cut; −1 if none. For the oracles

  bool operator==(const SceneCord&) const = default;
};

/// A solid that holds a cord.
struct Hold {
  int solid = 0;                                              ///< index
  int cord = 0;                                               ///< index
  double arc = 0.0;                                           ///< m at rest from the cord's first point
  int row = 0;                                                ///< of a ribbon
  ribbon::Vec2 local_anchor;                                  ///< m, in the solid's own frame
  double strength = std::numeric_limits<double>::infinity();  ///< N, above which the hold slips
  bool lets_go = false;                                       ///< releases instead of slipping
  double climb_to = -1.0;                                     ///< m at rest, the target of a climb; below 0: no climb
  double climb_speed = 1.0;                                   ///< m/s

  bool operator==(const Hold&) const = default;
};

/// A wheel that a cord runs around, on a solid.
struct Wheel {
  int cord = 0;           ///< index
  int solid = 0;          ///< index of the one that carries it
  ribbon::PulleyDef def;  ///< with the centre at the start

  bool operator==(const Wheel&) const = default;
};

/// Drags a point along a path from corner to corner, then releases it.
struct Drag {
  int cord = 0;                    ///< index
  int point = 0;                   ///< index in the cord
  int from_tick = 0;               ///< the first tick
  double speed = 1.0;              ///< m/s
  std::vector<ribbon::Vec2> path;  ///< m, relative to the point's position at the first tick

  bool operator==(const Drag&) const = default;
};

/// Reels links from a tick on: see ribbon::Cord::reel.
struct Reel {
  int cord = 0;
  int first = 0;
  int last = 0;
  int from_tick = 0;
  double length = 1.0;  ///< m
  double speed = 1.0;   ///< m/s

  bool operator==(const Reel&) const = default;
};

/// Cuts a cord before a tick.
struct Cut {
  int tick = 0;
  double cord = 0.0;     ///< 0 … below 1, share of the cords that there are then, by id
  double place = 0.5;    ///< above 0 and below 1, share of its length
  bool weakens = false;  ///< instead, the link there cannot bear any tension from then on, and breaks
  bool along = false;    ///< a ribbon of three or more rows is cut along a row, at that share of its inner rows

  bool operator==(const Cut&) const = default;
};

/// Ties two cords before a tick, at the nearest points of theirs, or unties one of the ties that there are.
struct Knot {
  int tick = 0;
  double cord = 0.0;    ///< 0 … below 1, share of the cords that there are then, by id
  double place = 0.5;   ///< 0 … below 1, share of its points: this one is tied to the nearest one of another cord
  bool unties = false;  ///< instead, that share of the ties, by id, is untied

  bool operator==(const Knot&) const = default;
};

/// All inputs of a run.
struct Scene {
  ribbon::Vec2 gravity{0.0, -9.81};  ///< m/s²
  Preset preset = Preset::balanced;
  int ticks = 300;        ///< of 1/60 s
  int calm_ticks = 0;     ///< after them, in which nothing drives any more
  bool sleeping = false;  ///< b2World::SetAllowSleeping
  std::vector<SceneCord> cords;
  std::vector<Solid> solids;
  std::vector<Hold> holds;
  std::vector<Wheel> wheels;
  std::vector<Drag> drags;
  std::vector<Reel> reels;
  std::vector<Cut> cuts;
  std::vector<Knot> knots;

  bool operator==(const Scene&) const = default;
};

constexpr double dt = 1.0 / 60.0;  // s, of every scene

/// Returns whether anything adds energy: moving kinematic bodies, belts, motors, drags, reels or climbers.
bool is_driven(const Scene& scene);
/// Returns whether the solid holds the cord at any time.
bool holds(const Scene& scene, int solid, int cord);
/// Returns whether the solid carries a wheel of the cord.
bool carries(const Scene& scene, int solid, int cord);
/// Returns whether a place of a cord, in links from its first column, is on a wheel.
bool is_on_wheel(const Scene& scene, int cord, double column);
/// Returns the number of points of all cords.
int points(const Scene& scene);

}  // namespace any_scene
