#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/draw/image.h"
#include "engine/math/smoothstep.h"

namespace game {

/// Functions from which the images of the game are computed.

using engine::smoothstep;

/// Multiplies the channels; the alpha is that of `light`.
inline engine::Color tinted(engine::Color light, engine::Color color) {
  const auto channel = [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a * b + 127) / 255); };
  return {channel(light.r, color.r), channel(light.g, color.g), channel(light.b, color.b), light.a};
}

inline double fraction(double x) { return x - std::floor(x); }

/// Converts 0 … 1 to 0 … 255.
inline std::uint8_t byte(double x) { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(x, 0.0, 1.0))); }
inline engine::Color grey(double light, double opacity = 1.0) {
  return {byte(light), byte(light), byte(light), byte(opacity)};
}

/// Makes an image with the colours shade(u, v) at the middles of the texels; u and v are 0 … 1.
template <typename Shade>
engine::Image drawn(int width, int height, Shade shade) {
  std::vector<engine::Color> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.push_back(shade((x + 0.5) / width, (y + 0.5) / height));
  return {width, height, pixels};
}

/// Returns the brightness of a round bar at −1 … 1 across it, lit from the front.
inline double roundness(double across) { return std::sqrt(std::max(1.0 - across * across, 0.0)); }

}  // namespace game
