#pragma once

#include "ribbon/box2d/coupling_state.h"

namespace engine {

/// Moves a grip to a column of its cord, 0 … columns − 1, at the same row: to the nearest end if the column is beyond
/// it, and nowhere if it is not a number. Within 1e-9 of a point it is at the point.
void set_column(GripMemory& grip, double column, int columns, int rows);

}  // namespace engine
