#pragma once

#include <cstdint>

#include "engine/draw/canvas_raster.h"

namespace test_support {

/// Returns the pixel in column x and row y, from the top left.
inline std::uint32_t pixel(const engine::Raster& raster, int x, int y) {
  return raster.pixels().at(static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width()) +
                            static_cast<std::size_t>(x));
}

}  // namespace test_support
