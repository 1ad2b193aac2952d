#pragma once

#include <vector>

#include "game/simulation/simulation.h"
#include "game/view/cords.h"
#include "game/view/pen.h"

namespace game {

/// Draws blades, fires, spikes, chasers and the coins that are left, between the last two ticks with `alpha`, 0 … 1.
void draw_hazards(Pen& pen, const Simulation& simulation, double alpha);

/// Draws the rails of the circles that follow paths.
void draw_rails(Pen& pen, const Level& level);

/// Adds the colours of the columns of a cord that was in a fire, blackened; none for another cord.
void add_char(const Pen& pen, const DrawnCord& cord, const Burning& burning, std::vector<engine::Color>& colors);

/// Draws flames at the places of a cord that are hot.
void draw_flames_on(Pen& pen, const DrawnCord& cord, const Burning& burning);

}  // namespace game
