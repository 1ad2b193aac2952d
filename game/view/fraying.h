#pragma once

#include "game/view/cords.h"
#include "game/view/pen.h"

namespace game {

/// The share of its breaking force from which a rope is drawn frayed.
inline constexpr double fraying_load = 0.7;

/// Returns the tension of the link between two columns of a rope, as a share of its breaking force; 0 for a cord that
/// does not break, and for ribbons.
double load_share(const DrawnCord& cord, int link);

/// Draws fibres that stand off a rope at the links that are near their breaking force: more, the nearer.
void draw_frays(Pen& pen, const DrawnCord& cord);

}  // namespace game
