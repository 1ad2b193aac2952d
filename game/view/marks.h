#pragma once

#include <span>
#include <string_view>

#include "game/simulation/area.h"
#include "game/view/pen.h"

namespace game {

/// Draws a flag whose foot is the middle of the lower edge of the goal. It waves more when the goal is reached.
void draw_goal(Pen& pen, const Area& goal, bool reached);

/// Draws a banner on a post whose foot is the middle of the lower edge of the checkpoint. It is up when reached.
void draw_checkpoint(Pen& pen, ribbon::Vec2 center, ribbon::Vec2 size, bool reached);

/// Draws a hook. It is highlighted if a throw would reach it.
void draw_hook(Pen& pen, ribbon::Vec2 at, bool in_range);

/// Draws where a line would stick to a surface.
void draw_aim(Pen& pen, ribbon::Vec2 at);

/// Draws a wooden board on posts that stand at the height of `foot`. `text`: lines separated by '\n'; `start`: m, the
/// feet of the player at the start, which does not stand before the board; `height`: of the letters, m. Adds the board
/// to the labels of the pen.
void draw_sign(Pen& pen, ribbon::Vec2 foot, std::string_view text, ribbon::Vec2 start, double height = 0.32);

/// Draws an iron weight with its mass in kg.
void draw_weight(Pen& pen, ribbon::Vec2 center, double radius, double angle, double mass);

/// Draws a mass in kg as text that fits into a disc.
void draw_mass(Pen& pen, ribbon::Vec2 center, double radius, double mass);

/// Draws a thrown line from the hand to its tip. `slack`: 0 … 1, how much it sags.
void draw_thrown_line(Pen& pen, ribbon::Vec2 hand, ribbon::Vec2 tip, double slack);

}  // namespace game
