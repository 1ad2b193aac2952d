#pragma once

#include <array>

#include "engine/draw/image.h"
#include "game/view/palette.h"

namespace game {

/// The images of everything. Those of which there is much have their palette's colours; the others are grey, and get
/// theirs from what they are laid on.
struct Textures {
  engine::Image rope;   ///< three strands; as long as four times the rope's width
  engine::Image cord;   ///< a thin braided one, likewise
  engine::Image cloth;  ///< woven, with a hem along both edges; as long as wide
  engine::Image soil;   ///< earth with stones, the same beyond all its edges
  engine::Image grass;  ///< a fringe of blades above, roots below, clear beyond; comes again to its right
  engine::Image wood;   ///< grain along it
  engine::Image stone;  ///< blocks in rows
  engine::Image shade;  ///< a ball's light and shadow, to be laid over it
  engine::Image ball;   ///< a ball's stripes, grey, to be turned with it
  engine::Image iron;   ///< a round weight
  engine::Image glow;   ///< white, fading from the middle
  std::array<engine::Image, 2> trees;  ///< firs, of the nearer hills
  std::array<engine::Image, 3> clouds;
};

/// Computed when they are first asked for.
const Textures& textures(const Palette& palette);

}  // namespace game
