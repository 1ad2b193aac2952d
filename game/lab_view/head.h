#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "game/lab/experiment.h"
#include "game/lab_view/layout.h"
#include "game/lab_view/tick_cost.h"
#include "game/words/lab_words.h"

namespace game::lab {

/// Returns the title of a scene and what it shows.
const words::lab::SceneWords& words_of(const Scene& scene);

/// Returns one line of figures for each bench. `costs`: of the benches.
std::vector<std::string> figures_of(const Experiment& experiment, std::span<const TickCost> costs);

/// Draws the title of the scene, unless a notice is there, what it shows, and its figures.
void draw_head(engine::Canvas& canvas, const Experiment& experiment, std::span<const std::string> figures,
               const Layout& layout, bool has_notice);

}  // namespace game::lab
