#pragma once

#include <span>

#include "game/simulation/simulation.h"
#include "game/view/pen.h"

namespace game {

/// Draws the wheels of pulleys, which turn with the rope in their grooves.
void draw_wheels(Pen& pen, std::span<const Snapshot::Wheel> wheels);

}  // namespace game
