#include "engine/draw/image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace engine {
namespace {

constexpr int max_side = 4096;

bool is_side(int n) { return n >= 1 && n <= max_side && std::has_single_bit(static_cast<unsigned>(n)); }

std::uint32_t premultiplied(Color c) {
  const auto channel = [&c](std::uint8_t value) { return static_cast<std::uint32_t>((value * c.a + 127) / 255); };
  return static_cast<std::uint32_t>(c.a) << 24U | channel(c.r) << 16U | channel(c.g) << 8U | channel(c.b);
}

std::uint32_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  std::uint32_t sum = 0;
  for (const unsigned shift : {0U, 8U, 16U, 24U}) {
    const std::uint32_t four =
        (a >> shift & 0xffU) + (b >> shift & 0xffU) + (c >> shift & 0xffU) + (d >> shift & 0xffU);
    sum |= (four + 2U) / 4U << shift;
  }
  return sum;
}

Image::Level halved(const Image::Level& whole) {
  Image::Level half;
  half.width = std::max(whole.width / 2, 1);
  half.height = std::max(whole.height / 2, 1);
  const auto at = [&whole](int x, int y) {
    const auto row = static_cast<std::size_t>(std::min(y, whole.height - 1));
    const auto column = static_cast<std::size_t>(std::min(x, whole.width - 1));
    return whole.pixels[row * static_cast<std::size_t>(whole.width) + column];
  };
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      half.pixels.push_back(
          mean(at(2 * x, 2 * y), at(2 * x + 1, 2 * y), at(2 * x, 2 * y + 1), at(2 * x + 1, 2 * y + 1)));
  return half;
}

void check_size(int width, int height, std::size_t pixels) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (!is_side(width) || !is_side(height))
    throw std::invalid_argument("an image of " + size + " pixels: each side must be a power of two, 1 to " +
                                std::to_string(max_side));
  if (pixels != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::invalid_argument("an image of " + size + " pixels was given " + std::to_string(pixels));
}

}  // namespace

Image::Image(int width, int height, std::span<const Color> pixels, Mipmaps mipmaps)
    : is_opaque_(std::all_of(pixels.begin(), pixels.end(), [](Color c) { return c.a == 255; })) {
  check_size(width, height, pixels.size());
  Level whole{width, height};
  for (const Color c : pixels) whole.pixels.push_back(premultiplied(c));
  levels_.push_back(std::move(whole));
  if (mipmaps == Mipmaps::no) return;
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halved(levels_.back()));
}

Image Image::of_premultiplied(int width, int height, std::vector<std::uint32_t> pixels) {
  check_size(width, height, pixels.size());
  Image image;
  image.is_opaque_ = std::all_of(pixels.begin(), pixels.end(), [](std::uint32_t p) { return p >> 24U == 255U; });
  image.levels_.push_back({width, height, std::move(pixels)});
  return image;
}

const Image::Level& Image::level(double texels_per_pixel) const {
  // Rounding to nearest would change the level at 2^0.5. The higher value prefers sharper levels: blur is more visible
  // than a little aliasing.
  double limit = std::exp2(0.65);
  std::size_t halvings = 0;
  for (; texels_per_pixel >= limit && halvings + 1 < levels_.size(); limit *= 2.0) ++halvings;
  return levels_[halvings];
}

}  // namespace engine
