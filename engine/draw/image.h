#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/draw/color.h"

namespace engine {

/// Whether an image keeps copies of itself at half the size, a quarter, and so on, for where it is drawn small.
enum class Mipmaps : bool { no, yes };

/// A picture to lay on meshes. It is copied in and does not change.
class Image {
 public:
  /// `pixels` row by row from the top. Throws std::invalid_argument unless both sides are powers of two, 1 to 4096, and
  /// there are width · height pixels.
  Image(int width, int height, std::span<const Color> pixels, Mipmaps mipmaps = Mipmaps::yes);

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }

  /// The picture, or a smaller copy of it.
  struct Level {
    int width = 1;   ///< a power of two
    int height = 1;  ///< a power of two
    /// 0xAARRGGBB, the colours multiplied by the alpha, row by row.
    std::vector<std::uint32_t> pixels{};
  };
  /// The copy that has about one texel a pixel where the whole picture has this many.
  const Level& level(double texels_a_pixel) const;

 private:
  std::vector<Level> levels_;
};

}  // namespace engine
