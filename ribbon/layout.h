#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Places a cord along a polyline. Sets `positions` and `length` of a definition whose `points`, `rows` and `width` are
/// set. The middle line of a ribbon follows the path, and its first row is on the right. A ribbon of width 0 gets the
/// width that makes its cells square.
///
/// Neighbouring columns have equal straight-line distances, from the first corner to the last. So every link has its
/// rest length, also where it cuts a corner; otherwise an inextensible cord would jerk in its first step. (If the path
/// folds back on itself, such points may not exist. Then the cord ends up to two links before the end of the path.)
///
/// Throws DefinitionError, and changes nothing, for an invalid number of points or rows, a path of less than two
/// corners, a corner [m] beyond ±1e9 and neighbouring corners less than 1e-6 m apart.
void lay_along(CordDef& def, const std::vector<Vec2>& path);

/// Returns triangles that fill the cells of a ribbon, for drawing: three point indices per triangle, two triangles per
/// cell, 6·(columns − 1)·(rows − 1) indices in all. They are counter-clockwise in the initial layout and never change.
/// A rope has none.
std::vector<int> triangle_indices(int columns, int rows);

}  // namespace ribbon
