#include "engine/draw/canvas_raster.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace engine {
namespace {

/// Blends a colour over a pixel, alpha 0 … 255. Exact for 0 and 255, within one level otherwise.
std::uint32_t blend(std::uint32_t below, std::uint32_t color, int alpha) {
  const auto over = static_cast<std::uint32_t>(alpha + (alpha >> 7));  // 0 … 256
  const std::uint32_t under = 256U - over;
  // Red and blue are computed together: the bits between them take the carries.
  const std::uint32_t red_blue = (color & 0xff00ffU) * over + (below & 0xff00ffU) * under + 0x800080U;
  const std::uint32_t green = (color & 0x00ff00U) * over + (below & 0x00ff00U) * under + 0x008000U;
  return ((red_blue >> 8) & 0xff00ffU) | ((green >> 8) & 0x00ff00U);
}

/// Returns cover · opacity; 255 stands for 1.
int alpha_of(std::uint8_t cover, int opacity) { return (cover * opacity + 127) / 255; }

constexpr unsigned marked_pixels = 32;  // px of a row that share a mark

/// Returns how many words the marks of a row have.
std::size_t words_of(int width) {
  return (static_cast<std::size_t>(width) + 64 * marked_pixels - 1) / (64 * marked_pixels);
}

void blend_one(std::uint32_t& pixel, std::uint8_t cover, std::uint32_t rgb, int opacity) {
  if (cover > 0) pixel = blend(pixel, rgb, alpha_of(cover, opacity));
}

/// Blends the colour over a row of pixels, eight at a time where the cover is full or zero, which is most of a shape.
void blend_covered(std::uint32_t* pixel, std::span<const std::uint8_t> cover, std::uint32_t rgb, int opacity) {
  constexpr std::size_t together = 8;
  std::size_t x = 0;
  for (; x + together <= cover.size(); x += together) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, &cover[x], together);
    if (eight == 0) continue;
    if (eight == ~std::uint64_t{0} && opacity == 255) {
      std::fill_n(pixel + x, together, rgb);
    } else if (eight == ~std::uint64_t{0}) {
      for (std::size_t k = x; k < x + together; ++k) pixel[k] = blend(pixel[k], rgb, opacity);
    } else {
      for (std::size_t k = x; k < x + together; ++k) blend_one(pixel[k], cover[k], rgb, opacity);
    }
  }
  for (; x < cover.size(); ++x) blend_one(pixel[x], cover[x], rgb, opacity);
}

}  // namespace

Raster::Raster(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      cover_(pixels_.size()),
      marks_(words_of(width) * static_cast<std::size_t>(height)) {}

void Raster::fill_row(int row, std::uint32_t rgb) {
  std::fill_n(pixels_.begin() + static_cast<std::ptrdiff_t>(row) * width_, width_, rgb);
}

/// Marks the blocks of a row that have these pixels, at least one.
void Raster::mark(int y, int begin, int end) {
  std::uint64_t* const row = marks_.data() + words_of(width_) * static_cast<std::size_t>(y);
  const auto first = static_cast<unsigned>(begin) / marked_pixels;
  const auto last = static_cast<unsigned>(end - 1) / marked_pixels;
  for (unsigned word = first / 64; word <= last / 64; ++word) {
    const unsigned low = word == first / 64 ? first % 64 : 0;
    const unsigned high = word == last / 64 ? last % 64 : 63;
    row[word] |= ~std::uint64_t{0} >> (63 - high) & ~std::uint64_t{0} << low;
  }
}

void Raster::blend_row(int y, std::uint32_t rgb, int opacity) {
  const std::ptrdiff_t line = static_cast<std::ptrdiff_t>(y) * width_;
  std::uint64_t* const row = marks_.data() + words_of(width_) * static_cast<std::size_t>(y);
  for (std::size_t word = 0; word < words_of(width_); ++word) {
    for (; row[word] != 0; row[word] &= row[word] - 1) {
      const int begin =
          static_cast<int>((word * 64 + static_cast<unsigned>(std::countr_zero(row[word]))) * marked_pixels);
      const int count = std::min(static_cast<int>(marked_pixels), width_ - begin);
      std::uint8_t* const cover = cover_.data() + line + begin;
      blend_covered(pixels_.data() + line + begin, {cover, static_cast<std::size_t>(count)}, rgb, opacity);
      std::fill_n(cover, count, std::uint8_t{0});
    }
  }
}

void Raster::stamp(std::span<const std::uint8_t> mask, int mask_width, int left, int top, std::uint32_t rgb,
                   int opacity) {
  if (mask_width <= 0) return;
  const int mask_height = static_cast<int>(mask.size()) / mask_width;
  for (int y = std::max(top, 0); y < std::min(top + mask_height, height_); ++y) {
    const std::uint8_t* from = mask.data() + static_cast<std::ptrdiff_t>(y - top) * mask_width;
    std::uint32_t* pixel = pixels_.data() + static_cast<std::ptrdiff_t>(y) * width_;
    for (int x = std::max(left, 0); x < std::min(left + mask_width, width_); ++x)
      if (from[x - left] > 0) pixel[x] = blend(pixel[x], rgb, alpha_of(from[x - left], opacity));
  }
}

}  // namespace engine
