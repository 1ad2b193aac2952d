#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/draw/canvas_mesh.h"
#include "engine/draw/textured_mesh.h"

namespace engine {

/// A picture in memory with a rasteriser for meshes and masks.
///
/// SDL's software renderer is not used because it rounds the corners of triangles to whole pixels, which prevents
/// antialiasing. Also, the window and saved files get the same picture this way.
class Raster {
 public:
  /// Makes a black picture of width × height pixels, 1 or more each.
  Raster(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  /// The pixels row by row from the top, without padding, 0x00RRGGBB.
  const std::vector<std::uint32_t>& pixels() const { return pixels_; }

  /// Overwrites the upper `rows` rows, clamped to 0 … height, with those of a copy of pixels().
  void put(const std::vector<std::uint32_t>& pixels, int rows) {
    const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(std::clamp(rows, 0, height_)) * width_;
    std::copy_n(pixels.begin(), count, pixels_.begin());
  }

  /// Fills a row, 0 … height − 1, with one colour.
  void fill_row(int row, std::uint32_t rgb);
  /// Blends the colour once over each pixel whose middle the mesh covers, with the largest cover of its triangles there
  /// times opacity (0 … 255) (raster_cover.cpp). The mesh must be paintable.
  void fill(const Mesh& mesh, std::uint32_t rgb, int opacity);
  /// Blends the triangles of the mesh in order (raster_textured.cpp). The mesh must be paintable.
  void fill(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip = {});
  /// Fills what is below or above a line (raster_skyline.cpp): see Canvas::skyline. `end`: the first row that is not
  /// filled.
  struct Skyline {
    double top, bottom;  // px, of the gradient
    std::uint32_t upper, lower;
    int end;
    bool is_above;
  };
  void fill(std::span<const ribbon::Vec2> line, const Skyline& look);
  /// Blends the colour with a mask of opacities, row by row, with its top left corner at pixel (left, top); clips it.
  void stamp(std::span<const std::uint8_t> mask, int mask_width, int left, int top, std::uint32_t rgb, int opacity);

 private:
  struct Range {
    int begin = 0;
    int end = 0;
    void add(int from, int to) {
      *this = begin == end ? Range{from, to} : Range{begin < from ? begin : from, end > to ? end : to};
    }
  };
  /// A corner of a textured triangle: its position in the image in texels, and its colour.
  struct Corner {
    ribbon::Vec2 at;
    std::array<double, 6> values;
  };
  class Painter;
  class CoverPainter;

  void find_edges(std::span<const ribbon::Vec2> line, float none);
  void mark(int y, int begin, int end);
  void blend_row(int y, std::uint32_t rgb, int opacity);

  int width_;
  int height_;
  std::vector<std::uint32_t> pixels_;
  std::vector<std::uint8_t> cover_;    // zero between two fills
  std::vector<float> edges_;           // the y of a line at the middle of each column
  std::vector<std::uint32_t> texels_;  // scratch memory for a row of an image
  std::vector<Corner> corners_;        // scratch memory for a mesh
  std::vector<std::uint64_t> marks_;   // a bit for each block of each row, set where the cover may be non-zero
  Range touched_;                      // the rows with marks
};

}  // namespace engine
