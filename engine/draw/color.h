#pragma once

#include <cstdint>

namespace engine {

/// Red, green, blue and alpha, 0 … 255 each, not premultiplied; alpha 255 is opaque.
struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  constexpr bool operator==(const Color&) const = default;
};

}  // namespace engine
