#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/contact/contacts.h"
#include "ribbon/system/island_state.h"

// The outline of a cord: the points around which it can be touched, and the links between them. Indices of points and
// links count along the outline; that of a ribbon is closed.

namespace ribbon {

/// Returns the number of links.
int outline_links(const CordParts& cord);
/// Returns the slot of an outline's point, k = −1 … points + 1; indices wrap around.
std::size_t outline_slot(const Member& member, int k);
/// Returns a contact pair with link k as its segment.
ContactPair pair_with_link(const Member& member, int k);
/// Returns a contact pair with point k as its segment, which has no length.
ContactPair pair_with_point(const Member& member, int k);
/// Links along the outline, within which points move nearly alike, so that their difference has a bound of its own.
inline constexpr int close_links = 6;
/// Returns whether point k and both ends of a link are at most `close_links` apart; see MotionBounds::near_of.
bool are_close(const CordParts& cord, int k, int link);
/// Returns whether point k is an end of a link, −1 … points. The outline is taken for closed.
bool is_end_of_link(const CordDef& def, int k, int link);
/// Returns where the points of the outline are in the straight cord, m.
void list_rest_positions(const CordDef& def, std::vector<Vec2>& positions);
/// Returns whether point k and a link are so near each other in the straight cord that contact could not part them.
bool are_neighbours(const CordDef& def, int k, int link);
/// Returns the same, with the positions of list_rest_positions().
bool are_neighbours(const CordDef& def, std::span<const Vec2> rest, int k, int link);
/// Returns false only if point k is no neighbour of a link or of the links before and behind it.
bool may_be_neighbours(const CordDef& def, std::span<const Vec2> rest, int k, int link);

/// Returns whether a point or a link of a rope is on the wheel of a pulley, where it touches nothing.
bool is_on_wheel(const CordParts& cord, int k, bool is_point);

/// Returns the same as are_neighbours for point k of a cord and a link of the cord that it was cut from, or a piece of
/// it that begins or ends there.
bool were_neighbours(const Member& member, int k, const Member& other, int link);
/// Returns the same for point k of a cord and a link of another one, near a tie of the two.
bool are_tied(const IslandState& state, const Member& member, int k, const Member& other, int link);

}  // namespace ribbon
