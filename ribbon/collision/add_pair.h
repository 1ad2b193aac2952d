#pragma once

#include "ribbon/collision/stored_touches.h"
#include "ribbon/contact/contacts.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// Links: a circle with at least this contact distance touches points instead of links.
inline constexpr double large_circle = 10.0;

/// Adds an anchor at the end of an arm [m] from the centre of mass of a body, which is solved with the cords if it can
/// be pushed. Returns the anchor's index.
int add_anchor(IslandState& state, Contacts& contacts, int body, Vec2 arm);
/// Returns the distance [m] of the pair's disc from its segment at the start of the step, or infinity if it is surely
/// more than their contact distance.
double initial_distance(const IslandState& state, const Contacts& contacts, const ContactPair& pair);
/// What a contact pair of a member depends on besides the pair's own fields.
struct PairSurfaces {
  const Member& member;          // it stores the contact from step to step
  const StoredTouches& touches;  // of the member
  double mass;                   // kg, what may press
  double friction;               // of the other surface
  double restitution;            // of the other surface
};
/// Adds a pair with its distance [m] at the start of the step. Completes the fields of the pair that its surfaces
/// determine.
void add_pair(const IslandState& state, Contacts& contacts, const PairSurfaces& surfaces, double distance,
              ContactPair& pair);

}  // namespace ribbon
