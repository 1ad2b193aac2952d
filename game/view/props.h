#pragma once

#include "engine/draw/image.h"

namespace game {

/// Computes images of things in the backdrop, in their colours.
engine::Image fir_image(engine::Color color);
/// A fir in a strong wind from the left.
engine::Image bent_tree_image(engine::Color color);
/// A cluster of crystals that stands on the lower edge.
engine::Image crystal_image(engine::Color color, int seed);
/// A harbour crane.
engine::Image crane_image(engine::Color color);
/// A sailing ship with furled sails; its water line is the lower edge.
engine::Image ship_image(engine::Color color);

}  // namespace game
