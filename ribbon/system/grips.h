#pragma once

#include <array>
#include <span>

#include "ribbon/convex/limited_rows.h"
#include "ribbon/system/island_state.h"

// The bodies that hold cords, IslandState::held: where they hold them, and their part in the linear system.

namespace ribbon {

/// Adds the grips of a member. A body that cannot be pushed and holds a point drives that point; all other bodies are
/// solved with the cord.
void add_grips(IslandState& state, Member& member);
/// Moves grips that climb to where they are at the end of the stage. Returns whether one moved.
bool move_climbing_grips(IslandState& state, const Member& member);

/// Returns the slots that a grip couples: both points, the body's centre and its angle.
std::array<int, 4> grip_slots(const IslandState& state, const HeldBody& held);
/// Returns how far the cord is at `x` from the anchor on the body that holds it, m.
Vec2 grip_separation(const IslandState& state, const HeldBody& held, std::span<const Vec2> x);
/// Returns the direction in which a grip slips: that of the cord where it is held, or round a point.
Vec2 grip_tangent(const IslandState& state, const HeldBody& held, std::span<const Vec2> x);
/// Returns the pull of the cord on the body, N, from an array of tensions.
Vec2 grip_pull(const IslandState& state, std::span<const double> tensions, std::size_t grip);
/// Returns the same; if the system is not coupled, from the motion of the body in the step.
Vec2 grip_reaction(const IslandState& state, std::size_t grip);

/// Adds the grips to the coupled system. The pull λ on the body is an unknown.
void load_grips(const IslandState& state, std::span<const double> inertia, BlockLdlt& blocks,
                std::span<Vec2> right_side);
/// Writes the pulls of a solution to `next`. Returns whether a grip has begun to slip.
bool update_grips(IslandState& state, std::span<const Vec2> solution, std::span<double> next);
/// Returns the part of the grips in what a stage minimises, J. `max_tensions` are the slopes of the exact penalty.
double grip_potential(const IslandState& state, std::span<const double> max_tensions, std::span<const Vec2> x);

/// Appends a row for each grip that may slip: a very stiff spring along the cord, limited to its strength.
void append_slip_rows(const IslandState& state, std::span<const double> inertia, LimitedRows& rows);
/// Takes over the forces of these rows, which are the last ones, and whether the grips slip.
void take_slip_rows(IslandState& state, const LimitedRows& rows);

/// Returns the largest work, J, that anchors which move on their bodies or along a cord can have done in the substep.
/// It is twice the pull times the displacement. The pull is that at the end, or the mean one if it is not coupled.
double grip_work(const IslandState& state);

}  // namespace ribbon
