#pragma once

#include "ribbon/system/cord_parts.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

// What is impossible stretches an inextensible rope: a drag or a kinematic body that pulls at what is pinned, or a
// speed that leaves no time to solve its motion. All that it is too long by, taken back in one step, moves its points
// further than contacts can be linearised, and the motion would be stopped at once. So such a rope is reeled in, over
// some steps, by drives that leave it no speed: they would be thousands of metres per second.

/// Returns the length [m] that the links of a cord regain in a step because they are overstretched: longer than at rest
/// by more than a twentieth. 0 for a ribbon, an extensible cord and one with pulleys. O(points).
double regained_length(const CordParts& cord);
/// Sets the rest lengths of overstretched links in the step: from their lengths at its start to three quarters of the
/// excess at its end. Call it when reels have set theirs.
void load_overstretch(IslandState& state, const Member& member);
/// Gives the cord its own rest lengths again: those at the start of the step, or those at its end.
void reset_overstretch(CordParts& cord);
void store_overstretch(CordParts& cord);

}  // namespace ribbon
