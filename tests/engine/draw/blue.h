#pragma once

#include "engine/draw/canvas_raster.h"
#include "tests/support/pixels.h"

namespace engine {

/// Returns the blue part of a pixel, 0 … 255.
inline int blue(const Raster& raster, int x, int y) {
  return static_cast<int>(test_support::pixel(raster, x, y) & 0xffU);
}

}  // namespace engine
