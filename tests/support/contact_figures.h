#pragma once

#include <span>
#include <vector>

#include "ribbon/cord.h"
#include "tests/support/coupled_world.h"

namespace test_support {

/// Returns whether two segments cross in their interiors. Segments that only touch do not cross.
bool is_crossing(ribbon::Vec2 a, ribbon::Vec2 b, ribbon::Vec2 c, ribbon::Vec2 d);
/// Returns the number of pairs of links of one line that cross; `closed` adds the link from its last point to its
/// first.
int self_crossings(std::span<const ribbon::Vec2> line, bool closed);
/// Returns the number of pairs that cross, of a link of one line and a link of the other.
int mutual_crossings(std::span<const ribbon::Vec2> a, bool a_closed, std::span<const ribbon::Vec2> b, bool b_closed);

/// Returns the closed outline of a ribbon of `rows` rows, or a rope's points.
std::vector<ribbon::Vec2> outline_of(std::span<const ribbon::Vec2> points, int rows);

/// Returns the number of links of cords' outlines that cross: of each with itself, and of all with each other.
int self_crossings(const CoupledWorld& world);
int mutual_crossings(const CoupledWorld& world);
/// Returns the number of cells of ribbons with an inverted corner.
int inverted_cells(const CoupledWorld& world);
/// Returns whether an object with this filter collides with the fixture, by Box2D's rule. Sensors and disabled bodies
/// do not collide.
bool meets(const b2Fixture& fixture, const b2Filter& filter);
/// The collision geometry of a cord: `radius` [m] around the links between points.
struct Outline {
  std::vector<ribbon::Vec2> points;
  bool closed = false;  ///< has a link from its last point to its first, as a ribbon
  double radius = 0.0;
};
/// Returns the penetration of the segment a b into a circle, an edge or a polygon, m; negative outside. Box2D's skin of
/// edges and polygons does not count. The penetration of a crossed edge is the distance to the nearer end of the
/// segment.
double depth(const b2Fixture& fixture, ribbon::Vec2 a, ribbon::Vec2 b);
/// Returns the largest penetration of an outline into a circle, an edge or a polygon of the world that `filter`
/// collides with, including the radius, m; 0 if there is none.
double penetration(const b2World& world, const Outline& outline, const b2Filter& filter);
/// Returns the largest penetration of its cords; of chains without that of boxes, of the thesis's cords without that of
/// edges.
double penetration(const CoupledWorld& world);
/// Returns the stretch of a rope, relative to its length.
double stretch(const CoupledWorld& world, int cord);

}  // namespace test_support
