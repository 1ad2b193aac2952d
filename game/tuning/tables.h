#pragma once

#include "game/simulation/meter.h"
#include "game/simulation/simulation.h"
#include "game/tuning/frame_times.h"

namespace game {

/// Returns the number of inverted cells of a cord.
int inverted_cells(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);
/// Returns the largest tension of a rope's links in N; 0 for ribbons and cords of the thesis's solver.
double greatest_tension(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// Adds the cost of a tick, a legend of the points' colours, and figures of all cords and of Box2D to the current ImGui
/// window.
void show_tables(const Simulation& simulation, const Meter& meter, const FrameTimes& times);

}  // namespace game
