#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "engine/draw/lanes.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr float beyond = 1e9F;  // px, outside any canvas

/// Returns the colour of the gradient at the middle of a row.
std::uint32_t color_at(const Raster::Skyline& look, int row) {
  const double t = std::clamp((row + 0.5 - look.top) / (look.bottom - look.top), 0.0, 1.0);
  return packed(mixed(spread(look.upper), spread(look.lower), static_cast<Lanes>(std::lround(256.0 * t))));
}

int column(double x, int width) { return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, 1.0 * width)); }

constexpr std::size_t block_columns = 32;  // px, columns that are compared with a row together

/// The smallest and the largest y of the line in each block of columns.
struct Block {
  float least = beyond;
  float most = -beyond;
};

std::vector<Block> blocks_of(const std::vector<float>& edges) {
  std::vector<Block> blocks((edges.size() + block_columns - 1) / block_columns);
  for (std::size_t x = 0; x < edges.size(); ++x) {
    Block& own = blocks[x / block_columns];
    own = {std::min(own.least, edges[x]), std::max(own.most, edges[x])};
  }
  return blocks;
}

/// Fills the pixels of a row where the line is above the row, or, for a ceiling, below it.
void fill_where(std::uint32_t* pixel, const std::vector<float>& edges, const std::vector<Block>& blocks, int row,
                bool is_above, std::uint32_t rgb) {
  const auto upper = static_cast<float>(row);
  const auto lower = static_cast<float>(row + 1);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Block own = blocks[k];
    if (is_above ? own.most < lower : own.least > upper) continue;
    const std::size_t begin = k * block_columns;
    const std::size_t end = std::min(begin + block_columns, edges.size());
    if (is_above ? own.least >= lower : own.most <= upper) {
      std::fill(pixel + begin, pixel + end, rgb);
    } else if (is_above) {
      for (std::size_t x = begin; x < end; ++x) pixel[x] = edges[x] >= lower ? rgb : pixel[x];
    } else {
      for (std::size_t x = begin; x < end; ++x) pixel[x] = edges[x] <= upper ? rgb : pixel[x];
    }
  }
}

}  // namespace

/// Sets edges_. Columns beside the line get `none`.
void Raster::find_edges(std::span<const Vec2> line, float none) {
  edges_.assign(static_cast<std::size_t>(width_), none);
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vec2 a = line[k - 1];
    const Vec2 b = line[k];
    if (b.x <= a.x) continue;
    const double slope = (b.y - a.y) / (b.x - a.x);
    const int last = column(b.x, width_);
    for (int x = column(a.x, width_); x < last; ++x) {
      const double y = std::clamp(a.y + (x + 0.5 - a.x) * slope, -1e6, 1e6);
      edges_[static_cast<std::size_t>(x)] = static_cast<float>(y);
    }
  }
}

void Raster::fill(std::span<const Vec2> line, const Skyline& look) {
  find_edges(line, look.is_above ? -beyond : beyond);
  const int end = std::clamp(look.end, 0, height_);
  const auto [low, high] = std::minmax_element(edges_.begin(), edges_.end());
  const auto row_of = [end](float y) {
    return static_cast<int>(std::clamp(std::floor(y), 0.0F, static_cast<float>(end)));
  };
  // The rows with pixels on both sides of the line; those on one side of it are filled whole.
  const int first = row_of(*low);
  const int last = std::min(row_of(*high) + 1, end);
  for (int y = look.is_above ? 0 : last; y < (look.is_above ? first : end); ++y) fill_row(y, color_at(look, y));
  const std::vector<Block> blocks = blocks_of(edges_);
  for (int y = first; y < last; ++y) {
    fill_where(pixels_.data() + static_cast<std::ptrdiff_t>(y) * width_, edges_, blocks, y, look.is_above,
               color_at(look, y));
  }
  for (int x = 0; x < width_; ++x) {  // the pixels on the line
    const float edge = edges_[static_cast<std::size_t>(x)];
    if (edge < 0.0F || edge >= static_cast<float>(end)) continue;
    const int y = static_cast<int>(edge);
    const float cover = look.is_above ? edge - static_cast<float>(y) : static_cast<float>(y + 1) - edge;
    std::uint32_t& pixel =
        pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    pixel = packed(mixed(spread(pixel), spread(color_at(look, y)), static_cast<Lanes>(256.0F * cover))) & 0xffffffU;
  }
}

}  // namespace engine
