#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/draw/color.h"

namespace engine {

/// Whether an image has mipmaps: copies at 1/2, 1/4, … of its size, for drawing it small.
enum class Mipmaps : bool { no, yes };

/// A texture. It does not change.
class Image {
 public:
  /// Copies `pixels`, row by row from the top. Throws std::invalid_argument unless both sides are powers of two,
  /// 1 … 4096, and there are width · height pixels.
  Image(int width, int height, std::span<const Color> pixels, Mipmaps mipmaps = Mipmaps::yes);

  /// Makes an image of premultiplied pixels, 0xAARRGGBB, without mipmaps. Throws like the constructor.
  static Image of_premultiplied(int width, int height, std::vector<std::uint32_t> pixels);

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }

  /// One level of the mipmap.
  struct Level {
    int width = 1;   ///< a power of two
    int height = 1;  ///< a power of two
    /// 0xAARRGGBB, premultiplied, row by row.
    std::vector<std::uint32_t> pixels{};
  };
  /// Whether all pixels have alpha 255.
  bool is_opaque() const { return is_opaque_; }
  /// Returns the level with about one texel per pixel, where the full image has `texels_per_pixel`.
  const Level& level(double texels_per_pixel) const;

 private:
  Image() = default;

  std::vector<Level> levels_;
  bool is_opaque_ = false;
};

}  // namespace engine
