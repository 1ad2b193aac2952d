#pragma once

#include "ribbon/contact/contacts.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// Links: a circle with at least this contact distance touches points instead of links.
inline constexpr double large_circle = 10.0;

/// Adds an anchor at the end of an arm [m] from the centre of mass of a body, which is solved with the cords if it can
/// be pushed. Returns the anchor's index.
int add_anchor(IslandState& state, Contacts& contacts, int body, Vec2 arm);
/// Adds a pair, of which the member stores the contact from step to step. `mass` [kg] is what may press; friction and
/// restitution are those of the other surface. Completes the other fields of the pair.
void add_pair(const IslandState& state, Contacts& contacts, const Member& member, ContactPair& pair, double mass,
              double friction, double restitution);

}  // namespace ribbon
