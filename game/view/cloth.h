#pragma once

#include <vector>

#include "game/view/cords.h"
#include "game/view/pen.h"

namespace game {

/// Draws a cord of several rows as cloth with its collision thickness, as a smooth curve of `steps` pieces between two
/// columns, with a dark edge. `colors`: one per column; replaces `color` unless empty.
void draw_cloth(Pen& pen, const DrawnCord& cord, int steps, engine::Color color,
                const std::vector<engine::Color>& colors);

}  // namespace game
