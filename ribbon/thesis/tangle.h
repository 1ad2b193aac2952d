#pragma once

#include <span>

#include "ribbon/thesis/broad_phase.h"
#include "ribbon/thesis/mesh.h"

namespace ribbon {

/// Marks with 1 the columns around each place where the cord crosses itself, all others with 0; returns how many.
/// `near` is the up-to-date broad phase of the cord's own point circles.
///
/// A cord that has been thrown through itself crosses itself, and contact then holds the crossing for ever, since it
/// drives out to either side what would have to slide through. So contact has to rest there until springs and gravity
/// have pulled the crossing out.
int find_tangled_columns(const Mesh& mesh, std::span<const Vec2> positions, const BroadPhase& near,
                         std::span<char> tangled);

}  // namespace ribbon
