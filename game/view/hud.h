#pragma once

#include <span>
#include <string>

#include "engine/draw/canvas.h"
#include "game/simulation/simulation.h"
#include "game/view/free_space.h"
#include "game/view/view.h"

namespace game {

/// What the HUD keeps clear of, px.
struct HudObstacles {
  std::span<const Rectangle> labels{};  ///< texts of the level
  Rectangle player{};
};

/// Draws time, keys, messages, the legend of strain and the figures of the debug view. No box covers another one or a
/// label of the level, as of a sign, and large ones do not cover the player; one that fits nowhere is left out.
/// `places` is of the frame before.
void draw_hud(engine::Canvas& canvas, const Simulation& simulation, const ViewOptions& options,
              const HudObstacles& obstacles, HudPlaces& last_places);

/// Draws a message in the strip that menus leave free at the top.
void draw_notice(engine::Canvas& canvas, const std::string& notice, double text_scale);
/// The height of this strip in units of text.
inline constexpr double notice_strip = 44.0;

/// Returns ticks as seconds: "12.35 s".
std::string seconds_in_words(int ticks);

}  // namespace game
