#pragma once

#include <array>
#include <utility>

#include "engine/draw/image.h"
#include "game/simulation/place.h"
#include "game/view/palette.h"

namespace game {

/// The images that are the same in all places. They are grey, to be multiplied with a colour.
struct CommonImages {
  engine::Image cord;   ///< thin and braided; its length is four widths
  engine::Image cloth;  ///< woven, with a hem along both edges; as long as wide
  engine::Image wood;   ///< grain along u
  engine::Image stone;  ///< blocks in rows
  engine::Image shade;  ///< light and shadow of a ball, drawn over it
  engine::Image ball;   ///< stripes of a ball, rotated with it
  engine::Image iron;   ///< a round weight
  engine::Image glow;   ///< white, fading from the middle
  std::array<engine::Image, 3> clouds;
};

/// The images of a place. Soil and props have the colours of the palette; the others are grey.
struct PlaceImages {
  engine::Image rope;                  ///< twisted strands; its length is four widths of the rope
  engine::Image soil;                  ///< earth, rock or masonry; repeats in both directions
  engine::Image grass;                 ///< the upper rim of the ground, transparent elsewhere; repeats horizontally
  std::array<engine::Image, 2> props;  ///< of the backdrop: trees, crystals, a crane and a ship
};

/// The images that are drawn with.
struct Textures {
  Textures(PlaceImages place, const CommonImages& common)
      : rope(std::move(place.rope)),
        soil(std::move(place.soil)),
        grass(std::move(place.grass)),
        props(std::move(place.props)),
        cord(common.cord),
        cloth(common.cloth),
        wood(common.wood),
        stone(common.stone),
        shade(common.shade),
        ball(common.ball),
        iron(common.iron),
        glow(common.glow),
        clouds(common.clouds) {}

  engine::Image rope, soil, grass;
  std::array<engine::Image, 2> props;
  const engine::Image &cord, &cloth, &wood, &stone, &shade, &ball, &iron, &glow;
  const std::array<engine::Image, 3>& clouds;
};

/// Returns the images of a place, which are computed on the first call.
const Textures& textures(bool colour_safe, Place place);

}  // namespace game
