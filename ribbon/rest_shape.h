#pragma once

#include "ribbon/cord_def.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Moves the positions of a definition to where the cord hangs at rest from its pins, under gravity [m/s²] and its own
/// stiffness alone: without contacts, media, masses and bodies. A cord that starts there does not move. It begins from
/// the positions that are set, as lay_along leaves them, and ends within a micrometre for each metre of the cord. (A
/// straight cord that stands on its pin is at rest too.) A rope takes about a millisecond; a wide ribbon of thousands
/// of points takes seconds. Throws DefinitionError, and changes nothing, for an invalid definition, for one without
/// positions or pins, for gravity that is not finite, and for a cord that does not come to rest in 300 steps, such as a
/// short rod that is a thousand times stiffer than its weight and does not fit between its pins.
void lay_at_rest(CordDef& def, Vec2 gravity);

}  // namespace ribbon
