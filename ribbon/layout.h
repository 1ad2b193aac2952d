#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Lays a cord along the corners of a path [m], before it is made: sets `positions` and `length` of a definition whose
/// `points`, `rows` and `width` are set. A ribbon's middle line follows the path, its rows lie across it, the first to
/// its right; one whose width is 0 gets the width that makes its cells square.
///
/// The columns are in equal distances as the crow flies, from the path's first corner to its last: so at rest no link
/// is too short where it cuts a corner, which a cord that does not stretch would put right with a jerk in its first
/// tick. (Where the path folds back on itself there may be no such points; then they stop up to two links before its
/// end.)
///
/// Throws DefinitionError, and changes nothing, for numbers of points or rows that no cord can have, a path of less
/// than two corners, and corners beyond ±1e9 m or less than 1e-6 m apart.
void lay_along(CordDef& def, const std::vector<Vec2>& path);

/// How to fill a ribbon's cells for drawing: three indices of points a triangle, two triangles a cell, 6·(columns −
/// 1)·(rows − 1) in all, counter-clockwise as laid out; none of a rope. The same for the life of a cord.
std::vector<int> triangle_indices(int columns, int rows);

}  // namespace ribbon
