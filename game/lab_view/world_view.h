#pragma once

#include "engine/draw/canvas.h"
#include "game/lab/experiment.h"
#include "game/lab_view/layout.h"
#include "game/lab_view/picture.h"

namespace game::lab {

/// Sets the view of a canvas so that a part of it shows the whole scene.
void set_view(engine::Canvas& canvas, const Scene& scene, const Rectangle& place);
/// Returns the place in the world of a pixel, with the same view, m.
ribbon::Vec2 to_world(const Scene& scene, const Rectangle& place, ribbon::Vec2 pixel);

/// Draws the benches of an experiment where the picture has them, with a grid of metres. Set the view before. It fills
/// the whole canvas: what is beside the world has to be drawn later.
void draw_world(engine::Canvas& canvas, const Experiment& experiment, const Picture& picture, const Layout& layout);

}  // namespace game::lab
