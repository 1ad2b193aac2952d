#pragma once

#include <span>

#include "ribbon/convex/limited_rows.h"
#include "ribbon/linear/block_ldlt.h"
#include "ribbon/system/island_state.h"

// What keeps bodies from moving, IslandState::supports. With the normal n, the centre of mass X and the angle φ of the
// body, a support is
//
//     d = gap + n·(X − X₀) + lever·φ − speed·t
//
// away at the time t of the step. Of a body that was pushed, gap is that after the push, and the support goes along
// with the push: `speed` is its own velocity and that of the push together. It is a very stiff spring that can only
// push: its energy is ½·k·d² for d < 0.

namespace ribbon {

/// Adds the bodies that support those which are solved with the cords, or are supported by them.
void add_supporting_bodies(IslandState& state);
/// Adds the supports of the bodies that the cords and wheels of the island have. Their motion is known.
void add_supports(IslandState& state);

/// Finds which supports the next linear system has: those that push at the current positions. Returns whether others do
/// than in the last one.
bool find_loaded(IslandState& state);
/// Adds what supports between bodies couple to the pattern of a matrix.
void couple_supports(const IslandState& state, BlockLdlt& matrix);
/// Adds the loaded ones to the coupled system.
void load_supports(const IslandState& state, BlockLdlt& blocks, std::span<Vec2> right_side);
/// Returns whether the linear system had the supports that push at the current positions, or others whose forces move
/// no body by more than `tolerance` [m]. `inertia` is by slot, N/m.
bool are_supports_settled(const IslandState& state, std::span<const double> inertia, double tolerance);
/// Ends a stage: finds which supports push, and whether these are others than before.
void end_stage_of_supports(IslandState& state);
/// Returns the energy of the supports, J.
double support_energy(const IslandState& state);
/// Returns the part of the supports in what a stage minimises, J: that of those which the linear system has.
double support_potential(const IslandState& state, std::span<const Vec2> x);

/// Appends a row for each support.
void append_support_rows(const IslandState& state, LimitedRows& rows);

/// Writes the forces of the supports at the end of the step to their bodies.
void store_support_forces(const IslandState& state);

}  // namespace ribbon
