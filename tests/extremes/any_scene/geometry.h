#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ribbon/vec2.h"
#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

// Geometry of the oracles, written apart from the solver's.

/// m, from a point to a segment.
double distance(ribbon::Vec2 p, ribbon::Vec2 a, ribbon::Vec2 b);
/// m, between two segments, 0 where they cross.
double distance(ribbon::Vec2 a, ribbon::Vec2 b, ribbon::Vec2 c, ribbon::Vec2 d);
/// Whether two segments cross in their insides.
bool crosses(ribbon::Vec2 a, ribbon::Vec2 b, ribbon::Vec2 c, ribbon::Vec2 d);

/// Where something is at two successive ticks; between them it is taken to move straight.
struct Swept {
  ribbon::Vec2 before;
  ribbon::Vec2 after;
};
/// Where along the link from a to b, 0 … 1, the point p passes to its other side; nothing if it does not, or passes and
/// returns.
std::optional<double> passes(Swept p, Swept a, Swept b);

/// A position and a rotation.
struct Pose {
  ribbon::Vec2 position;
  double cos = 1.0;
  double sin = 0.0;
  ribbon::Vec2 to_world(ribbon::Vec2 local) const;
  ribbon::Vec2 to_local(ribbon::Vec2 world) const;
};
Pose pose_of(const Solid& solid);

/// m, how deep the deepest point of a segment is inside a solid, its surface being at 0; negative outside. A circle's
/// deepest place is its centre; an edge has no inside: minus the distance.
double depth(const Solid& solid, const Pose& pose, ribbon::Vec2 a, ribbon::Vec2 b);
/// m, of a box and an edge, that Box2D's polygons are thicker.
double skin(const Solid& solid);

/// What of a cord can be touched: a rope's line, a ribbon's closed outline.
struct Outline {
  std::vector<ribbon::Vec2> points;
  bool closed = false;
  int links() const { return static_cast<int>(points.size()) - (closed ? 0 : 1); }
  ribbon::Vec2 start(int link) const { return points[static_cast<std::size_t>(link)]; }
  ribbon::Vec2 end(int link) const { return points[static_cast<std::size_t>(link + 1) % points.size()]; }
};
Outline outline(const ribbon::CordDef& def, std::span<const ribbon::Vec2> positions);
/// The outline of a cord that is straight and at rest.
Outline outline_at_rest(const ribbon::CordDef& def);
/// By pair of links, i · links + j: whether they are so near each other at rest that the solver does not keep all of
/// them apart.
std::vector<char> neighbours(const ribbon::CordDef& def);

}  // namespace any_scene
