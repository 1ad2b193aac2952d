#pragma once

#include "game/view/textures.h"

namespace game {

/// The strands of a rope.
struct RopeLook {
  int strands = 3;      ///< in the length of the image
  double slant = 1.0;   ///< turns across the rope
  double fibres = 0.1;  ///< roughness
  double shine = 0.0;   ///< 0 … 1, of a wet or tarred rope
};

/// Computes the image of a rope.
engine::Image rope_image(const RopeLook& look);

/// Computes the images of a place.
PlaceImages make_place_images(const Palette& colors, Place place);

}  // namespace game
