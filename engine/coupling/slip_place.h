#pragma once

#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_state.h"

// Where a grip that may slip holds its cord. The solver lets it slide along the line of one link in a substep, so it
// can end beside its cord: beyond a bend, or where Box2D pushed its body.

namespace ribbon::box2d {

/// The place that a step is to hold.
struct SlipPlace {
  int point = 0;           ///< index of the point, or of the one before the place
  double along = 0.0;      ///< share of the link after it, 0 … 1
  Vec2 across{};           ///< unit vector, in which it holds at a point; zero: across its link
  bool stops = false;      ///< at an end that it cannot leave, it is held in all directions
  bool is_caught = false;  ///< so it is in a bend, unless its cord runs through it
};

/// Moves a grip downhill to the nearest place of its cord, if `hand` [m], its anchor in the world, is beside the cord.
void move_to_nearest(GripMemory& grip, const CoupledCord& cord, Vec2 hand);

/// Returns how the cord holds a grip that may slip, at its place. `stops` tells that it is at an end of the cord at
/// which it stops.
SlipPlace slip_place(const GripMemory& grip, const CoupledCord& cord, Vec2 hand, bool stops);

}  // namespace ribbon::box2d
