#pragma once

#include <span>
#include <string_view>

#include "game/view/pen.h"

namespace game {

/// A flag in the middle of the goal's rectangle, on its lower edge. It waves harder once it is reached.
void draw_goal(Pen& pen, ribbon::Vec2 center, ribbon::Vec2 size, bool reached);

/// A banner on a post with its foot in the middle of the rectangle's lower edge, up if it is reached.
void draw_checkpoint(Pen& pen, ribbon::Vec2 center, ribbon::Vec2 size, bool reached);

/// A ring that a line can be thrown at, shining if it is in reach.
void draw_hook(Pen& pen, ribbon::Vec2 at, bool in_reach);

/// A wooden board on posts whose feet are at this height, its lines parted by '\n', the letters `height` m high.
void draw_sign(Pen& pen, ribbon::Vec2 foot, std::string_view text, double height = 0.32);

/// A weight of iron with its mass written on it, kg.
void draw_weight(Pen& pen, ribbon::Vec2 center, double radius, double angle, double mass);

/// A mass [kg] in letters that fit into a disc.
void draw_mass(Pen& pen, ribbon::Vec2 center, double radius, double mass);

/// The line that the player throws, from hand to hook: a thin cord with a claw at its tip. `slack` (0 … 1) of it hangs
/// through.
void draw_thrown_line(Pen& pen, ribbon::Vec2 hand, ribbon::Vec2 tip, double slack);

}  // namespace game
