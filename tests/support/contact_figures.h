#pragma once

#include <span>
#include <vector>

#include "ribbon/cord.h"
#include "tests/support/coupled_world.h"

namespace test_support {

/// Whether two segments cross in their insides. What only touches does not cross.
bool is_crossing(ribbon::Vec2 a, ribbon::Vec2 b, ribbon::Vec2 c, ribbon::Vec2 d);
/// Pairs of links of one line that cross; `closed` adds the link from its last point to its first.
int self_crossings(std::span<const ribbon::Vec2> line, bool closed);
/// Pairs of a link of one and a link of the other that cross.
int mutual_crossings(std::span<const ribbon::Vec2> a, bool a_closed, std::span<const ribbon::Vec2> b, bool b_closed);

/// The closed outline of a ribbon of so many rows, or a rope's points.
std::vector<ribbon::Vec2> outline_of(std::span<const ribbon::Vec2> points, int rows);

/// Links of cords' outlines that cross: of each with itself, and of all with each other.
int self_crossings(const CoupledWorld& world);
int mutual_crossings(const CoupledWorld& world);
/// Cells of ribbons with a corner that is turned inside out.
int inverted_cells(const CoupledWorld& world);
/// Whether what has this filter can touch the fixture, by Box2D's rule; sensors and disabled bodies it cannot.
bool meets(const b2Fixture& fixture, const b2Filter& filter);
/// What of a cord can be touched: `radius` [m] around the links between points.
struct Outline {
  std::vector<ribbon::Vec2> points;
  bool closed = false;  ///< from its last point to its first, as a ribbon's is
  double radius = 0.0;
};
/// m, how deep the segment a b is in a circle, an edge or a polygon, less than 0 where it is outside. Box2D's skin of
/// edges and polygons is not counted. An edge that is crossed counts as deep as the nearer end of what crosses it.
double depth(const b2Fixture& fixture, ribbon::Vec2 a, ribbon::Vec2 b);
/// m, the deepest that an outline is in a circle, an edge or a polygon of the world that `filter` lets it meet, its
/// radius counted; 0 if it is in none.
double penetration(const b2World& world, const Outline& outline, const b2Filter& filter);
/// The deepest of its cords; of chains, without the boxes, and of the thesis's, without edges.
double penetration(const CoupledWorld& world);
/// Of a rope, as a share of its length.
double stretch(const CoupledWorld& world, int cord);

}  // namespace test_support
