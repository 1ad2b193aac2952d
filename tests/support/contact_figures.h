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

/// Links of cords' outlines that cross: of each with itself, and of all with each other.
int self_crossings(const CoupledWorld& world);
int mutual_crossings(const CoupledWorld& world);
/// Cells of ribbons with a corner that is turned inside out.
int inverted_cells(const CoupledWorld& world);
/// m, the deepest that a cord's link is in a circle or an edge of the world, its radius counted; 0 if none is. An edge
/// that is crossed counts as deep as the nearer end of what crosses it; for the thesis's cords there are no edges.
double penetration(const CoupledWorld& world);
/// Of a rope, as a share of its length.
double stretch(const CoupledWorld& world, int cord);

}  // namespace test_support
