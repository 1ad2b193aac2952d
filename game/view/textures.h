#pragma once

#include <array>

#include "engine/draw/image.h"
#include "game/view/palette.h"

namespace game {

/// The images of the game. Soil and trees have the colours of the palette; the others are grey, to be multiplied with a
/// colour.
struct Textures {
  engine::Image rope;                  ///< three strands; its length is four widths of the rope
  engine::Image cord;                  ///< thin and braided; its length is four widths
  engine::Image cloth;                 ///< woven, with a hem along both edges; as long as wide
  engine::Image soil;                  ///< earth with stones; repeats in both directions
  engine::Image grass;                 ///< blades above, roots below, transparent elsewhere; repeats horizontally
  engine::Image wood;                  ///< grain along u
  engine::Image stone;                 ///< blocks in rows
  engine::Image shade;                 ///< light and shadow of a ball, drawn over it
  engine::Image ball;                  ///< stripes of a ball, rotated with it
  engine::Image iron;                  ///< a round weight
  engine::Image glow;                  ///< white, fading from the middle
  std::array<engine::Image, 2> trees;  ///< firs on the nearer hills
  std::array<engine::Image, 3> clouds;
};

/// Returns the images, which are computed on the first call.
const Textures& textures(const Palette& palette);

}  // namespace game
