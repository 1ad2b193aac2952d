#pragma once

#include <span>

#include "ribbon/geometry/tangent.h"
#include "ribbon/island_cord.h"
#include "ribbon/system/cord_parts.h"
#include "ribbon/system/tie_groups.h"

// The points of a cord at the wheels of its pulleys.

namespace ribbon {

/// The path of a cord from the point before a wheel to the one behind it.
struct WheelPath {
  Vec2 center;         ///< m
  double radius;       ///< m
  double sense;        ///< 1 if it runs counterclockwise, −1 if clockwise
  TangentLine before;  ///< the line to the wheel
  TangentLine after;   ///< and the one from it
  double lead;         ///< m, length at rest of the part before the wheel
  double arc;          ///< rad, angle of contact
  double trail;        ///< m, length at rest of the part behind the wheel
};

/// A place on such a path.
struct PathPlace {
  Vec2 position;  ///< m
  Vec2 along;     ///< unit vector in which the cord runs
};

/// Returns the place at a distance at rest [m] from the point before the wheel.
PathPlace place_on_path(const WheelPath& path, double distance);

/// Returns the length at rest of the part behind the wheel, m: what the others leave.
double trail_of(const CordParts& cord, const Pulley& pulley);
/// Returns the mass of the points on a wheel, kg.
double mass_on_wheel(const CordParts& cord, const PulleyDef& def);
/// Returns the mass that has the moment of inertia of a wheel at its radius, kg.
double wheel_mass(const PulleyDef& def);

/// Returns a pulley of a cord as its points lie, and places those between on it. Throws as add_pulley does.
Pulley make_pulley(CordParts& cord, const PulleyDef& def);
/// Finds where cords arrive at their wheels and leave them, takes points up that are about to reach a wheel, and lets
/// go of those that have left it. Before each attempt at a step; `first` before the first one.
void move_points_over_wheels(std::span<const IslandCord> cords, std::span<const TiedPoint> tied,
                             std::span<const RigidBody> bodies, double dt, bool first);

}  // namespace ribbon
