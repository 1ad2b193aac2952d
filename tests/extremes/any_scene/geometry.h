#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ribbon/vec2.h"
#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

// Geometry of the oracles, independent of the solver's.

/// Returns the distance from a point to a segment, m.
double distance(ribbon::Vec2 p, ribbon::Vec2 a, ribbon::Vec2 b);
/// Returns the distance between two segments, m; 0 if they cross.
double distance(ribbon::Vec2 a, ribbon::Vec2 b, ribbon::Vec2 c, ribbon::Vec2 d);
/// Returns whether the interiors of two segments cross.
bool crosses(ribbon::Vec2 a, ribbon::Vec2 b, ribbon::Vec2 c, ribbon::Vec2 d);

/// A point's positions at two successive ticks. The motion between them is taken as linear.
struct Swept {
  ribbon::Vec2 before;
  ribbon::Vec2 after;
};
/// Returns the place along the link from a to b, 0 … 1, at which p passes to the other side. Returns nothing if p ends
/// on the side where it started.
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

/// Returns the greatest depth of a segment below a solid's surface, m; negative outside. A circle is deepest at its
/// centre. An edge has no interior: the depth is minus the distance.
double depth(const Solid& solid, const Pose& pose, ribbon::Vec2 a, ribbon::Vec2 b);
/// Returns the thickness that Box2D adds to a box or an edge, m.
double skin(const Solid& solid);

/// The part of a cord that takes part in contact: a rope's line, or a ribbon's closed outline.
struct Outline {
  std::vector<ribbon::Vec2> points;
  bool closed = false;
  std::vector<char> on_wheel{};  ///< by link: it is at a wheel, where a cord touches nothing; empty without wheels
  int links() const { return static_cast<int>(points.size()) - (closed ? 0 : 1); }
  ribbon::Vec2 start(int link) const { return points[static_cast<std::size_t>(link)]; }
  ribbon::Vec2 end(int link) const { return points[static_cast<std::size_t>(link + 1) % points.size()]; }
  void lay_on_wheel(int before, int after);  ///< the links from a point to one behind it
  bool is_on_wheel(int link) const { return !on_wheel.empty() && on_wheel[static_cast<std::size_t>(link)] != 0; }
  bool is_at_wheel(int point) const;  ///< a link of the point is on one
};
/// Returns the distance of a point from the segment from a to b, m.
double distance(ribbon::Vec2 p, ribbon::Vec2 a, ribbon::Vec2 b);
Outline outline(const ribbon::CordDef& def, std::span<const ribbon::Vec2> positions);
/// Returns the outline of a straight cord at rest.
Outline outline_at_rest(const ribbon::CordDef& def);
/// Returns for each pair of links, at i · links + j, whether they are so close at rest that the solver does not
/// separate all of them.
std::vector<char> neighbours(const ribbon::CordDef& def);
/// Returns the same for a link of a cord and one of the cord that was cut from its last column.
std::vector<char> neighbours(const ribbon::CordDef& before, const ribbon::CordDef& after);

}  // namespace any_scene
