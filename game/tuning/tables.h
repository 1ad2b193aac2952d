#pragma once

#include "game/simulation/meter.h"
#include "game/simulation/simulation.h"

namespace game {

/// How many cells of a cord of two rows and more are inside out.
int inverted_cells(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);
/// N, the greatest of a rope's links; 0 of what has none.
double greatest_tension(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// Adds to the ImGui window that is open what a tick costs, what the points' colours mean, and the figures of all cords
/// and of what they are solved with.
void show_tables(const Simulation& simulation, const Meter& meter);

}  // namespace game
