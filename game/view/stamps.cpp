#include "game/view/stamps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/draw/lanes.h"

namespace game {
namespace {

using engine::Color;
using engine::Image;
using engine::Lanes;

/// The two texels around a position along one side of an image, and the weight of the second, 0 … 256.
struct Between {
  std::size_t first, second;
  Lanes weight;
};

/// Returns them for each of `count` pixels that share a side of `texels`.
std::vector<Between> spread_over(int texels, int count) {
  std::vector<Between> all;
  for (int k = 0; k < count; ++k) {
    const double x = std::clamp((k + 0.5) * texels / count - 0.5, 0.0, texels - 1.0);
    const auto first = static_cast<std::size_t>(x);
    const std::size_t second = std::min(first + 1, static_cast<std::size_t>(texels) - 1);
    all.push_back({first, second, static_cast<Lanes>(256.0 * (x - static_cast<double>(first)))});
  }
  return all;
}

Stamps::Stamp make(const Image& image, int width, int height, Color color) {
  const double shrink = std::sqrt(1.0 * image.width() * image.height() / (1.0 * width * height));
  const Image::Level& level = image.level(shrink);
  const std::vector<Between> columns = spread_over(level.width, width);
  const std::vector<Between> rows = spread_over(level.height, height);
  const auto stride = std::bit_ceil(static_cast<unsigned>(width));
  const auto lines = std::bit_ceil(static_cast<unsigned>(height));
  std::vector<std::uint32_t> pixels(std::size_t{stride} * lines);
  const auto premultiplied = [&](std::uint8_t channel) {
    return static_cast<std::int64_t>(channel * color.a / 255) << 16;
  };
  const bool is_white = color == Color{255, 255, 255, 255};
  for (std::size_t y = 0; y < rows.size(); ++y) {
    const std::uint32_t* const upper = level.pixels.data() + rows[y].first * static_cast<std::size_t>(level.width);
    const std::uint32_t* const lower = level.pixels.data() + rows[y].second * static_cast<std::size_t>(level.width);
    const auto at = [&](std::size_t x) {
      return upper[x] == 0U && lower[x] == 0U
                 ? Lanes{0}
                 : engine::mixed(engine::spread(upper[x]), engine::spread(lower[x]), rows[y].weight);
    };
    for (std::size_t x = 0; x < columns.size(); ++x) {
      const Lanes left = at(columns[x].first);
      const Lanes right = at(columns[x].second);
      if (left == 0U && right == 0U) continue;
      const Lanes own = engine::mixed(left, right, columns[x].weight);
      pixels[y * stride + x] =
          engine::packed(is_white ? own
                                  : engine::tinted(own, premultiplied(color.b), premultiplied(color.r),
                                                   premultiplied(color.g), std::int64_t{color.a} << 16));
    }
  }
  return {Image::of_premultiplied(static_cast<int>(stride), static_cast<int>(lines), std::move(pixels)), width, height};
}

}  // namespace

const Stamps::Stamp& Stamps::get(const Image& image, int width, int height, Color color) {
  const Key key{&image, width, height, color.r, color.g, color.b, color.a};
  if (const auto found = made_.find(key); found != made_.end()) return found->second;
  if (made_.size() >= max_count) made_.clear();
  return made_.emplace(key, make(image, std::clamp(width, 1, 4096), std::clamp(height, 1, 4096), color)).first->second;
}

}  // namespace game
