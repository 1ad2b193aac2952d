#pragma once

#include <string>

#include "engine/draw/canvas.h"
#include "game/simulation/simulation.h"
#include "game/view/view.h"

namespace game {

/// Draws time, keys, messages, and the figures of the debug view.
void draw_hud(engine::Canvas& canvas, const Simulation& simulation, const ViewOptions& options);

/// Draws a message at the bottom right.
void draw_notice(engine::Canvas& canvas, const std::string& notice, double text_scale);

/// Returns ticks as seconds: "12.35 s".
std::string seconds_in_words(int ticks);

}  // namespace game
