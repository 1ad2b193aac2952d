#pragma once

#include <span>

#include "ribbon/thesis/broad_phase.h"
#include "ribbon/thesis/mesh.h"

namespace ribbon {

/// Marks the columns near crossings of the cord with itself by 1, all others by 0, and returns the number of marked
/// columns. `broad_phase` is the current broad phase of the cord's own point circles.
///
/// Contact would hold a crossing for ever, because it pushes points to either side that have to slide through. So
/// contact must be off there until springs and gravity have removed the crossing.
int find_tangled_columns(const Mesh& mesh, std::span<const Vec2> positions, const BroadPhase& broad_phase,
                         std::span<char> tangled);

}  // namespace ribbon
