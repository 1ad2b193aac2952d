#pragma once

#include <vector>

#include "game/view/cords.h"
#include "game/view/pen.h"

namespace game {

/// A cord of several rows as a piece of cloth, as thick as it collides, drawn smooth in `steps` pieces between two
/// columns, with a dark edge. `colors`, one a column, count instead of `color` if there are any.
void draw_cloth(Pen& pen, const DrawnCord& cord, int steps, engine::Color color,
                const std::vector<engine::Color>& colors);

}  // namespace game
