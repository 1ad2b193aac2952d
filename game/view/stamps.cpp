#include "game/view/stamps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/draw/lanes.h"

namespace game {
namespace {

using engine::Color;
using engine::Image;
using engine::Lanes;

/// Returns the colour of a premultiplied one.
Color unmultiplied(Lanes lanes) {
  const auto alpha = static_cast<unsigned>(lanes >> 48U);
  if (alpha == 0) return {0, 0, 0, 0};
  const auto channel = [&](unsigned shift) {
    return static_cast<std::uint8_t>(
        std::min(255U, (static_cast<unsigned>(lanes >> shift & 0xffU) * 255U + alpha / 2U) / alpha));
  };
  return {channel(16), channel(32), channel(0), static_cast<std::uint8_t>(alpha)};
}

/// Samples a level of an image at a position 0 … 1 by linear interpolation, without a repetition.
Lanes sample(const Image::Level& level, double u, double v) {
  const double x = std::clamp(u * level.width - 0.5, 0.0, level.width - 1.0);
  const double y = std::clamp(v * level.height - 0.5, 0.0, level.height - 1.0);
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const auto at = [&](int column, int row) {
    return engine::spread(level.pixels[static_cast<std::size_t>(std::min(row, level.height - 1) * level.width +
                                                                std::min(column, level.width - 1))]);
  };
  const auto right = static_cast<Lanes>(256.0 * (x - i));
  const auto down = static_cast<Lanes>(256.0 * (y - j));
  return engine::mixed(engine::mixed(at(i, j), at(i + 1, j), right),
                       engine::mixed(at(i, j + 1), at(i + 1, j + 1), right), down);
}

Stamps::Stamp make(const Image& image, int width, int height, Color color) {
  const auto power = [](int n) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(n))); };
  const double shrink = std::sqrt(1.0 * image.width() * image.height() / (1.0 * width * height));
  const Image::Level& level = image.level(shrink);
  std::vector<Color> pixels(static_cast<std::size_t>(power(width)) * static_cast<std::size_t>(power(height)),
                            Color{0, 0, 0, 0});
  const auto times = [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a * b + 127) / 255); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Color own = unmultiplied(sample(level, (x + 0.5) / width, (y + 0.5) / height));
      pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(power(width)) + static_cast<std::size_t>(x)] = {
          times(own.r, color.r), times(own.g, color.g), times(own.b, color.b), times(own.a, color.a)};
    }
  }
  return {Image(power(width), power(height), pixels, engine::Mipmaps::no), width, height};
}

}  // namespace

const Stamps::Stamp& Stamps::get(const Image& image, int width, int height, Color color) {
  const Key key{&image, width, height, color.r, color.g, color.b, color.a};
  if (const auto found = made_.find(key); found != made_.end()) return found->second;
  if (made_.size() >= max_count) made_.clear();
  return made_.emplace(key, make(image, std::clamp(width, 1, 4096), std::clamp(height, 1, 4096), color)).first->second;
}

}  // namespace game
