#pragma once

#include "engine/draw/canvas.h"
#include "game/view/free_space.h"

namespace game {

/// Returns the camera for a run that is shown in a part of the canvas, beside a menu or panel. `part`: px. `of_part`:
/// the camera for a canvas of its size. `player`, `level`: the position of the player and the size of the level, m. The
/// part shows what that canvas would show, but keeps the player away from its sides.
engine::View view_in(const Rectangle& part, const engine::Canvas& canvas, const engine::View& of_part,
                     ribbon::Vec2 player, ribbon::Vec2 level);

}  // namespace game
