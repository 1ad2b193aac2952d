#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/draw/canvas_mesh.h"
#include "engine/draw/textured_mesh.h"

namespace engine {

/// A picture in memory, and the two ways of putting something on it: a mesh, and a mask of letters.
///
/// It exists because SDL's own software renderer moves the corners of triangles to whole pixels, which undoes any
/// antialiasing. Drawing here also gives the window and the saved file the same picture.
class Raster {
 public:
  /// Black. Width and height in pixels, 1 or more.
  Raster(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Row by row from the top, without padding; 0x00RRGGBB each.
  const std::vector<std::uint32_t>& pixels() const { return pixels_; }

  /// Takes all pixels from a copy of pixels().
  void put(const std::vector<std::uint32_t>& pixels) { std::copy(pixels.begin(), pixels.end(), pixels_.begin()); }

  /// Fills the row, 0 … height − 1, with one colour.
  void fill_row(int row, std::uint32_t rgb);
  /// Blends the colour once over every pixel whose middle the mesh covers, by the largest cover of its triangles there
  /// times opacity (0 … 255). The mesh's indices are in range, its corners finite.
  void fill(const Mesh& mesh, std::uint32_t rgb, int opacity);
  /// Blends the mesh's triangles over what is there, one after the other (raster_textured.cpp). The mesh is paintable.
  void fill(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip = {});
  /// Blends the colour by a mask of width × (its size / width) bytes, its top left corner at this pixel; parts outside
  /// are cut off.
  void stamp(std::span<const std::uint8_t> mask, int mask_width, int left, int top, std::uint32_t rgb, int opacity);

 private:
  struct Range {
    int begin = 0;
    int end = 0;
    void add(int from, int to) {
      *this = begin == end ? Range{from, to} : Range{begin < from ? begin : from, end > to ? end : to};
    }
  };
  class Painter;

  void cover_triangle(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c);
  void blend_row(int y, std::uint32_t rgb, int opacity);

  int width_;
  int height_;
  std::vector<std::uint32_t> pixels_;
  std::vector<std::uint8_t> cover_;  // all zero between two fills
  std::vector<Range> rows_;          // the pixels of the cover buffer that may be non-zero, row by row
  Range touched_;                    // the rows of which that is so
};

}  // namespace engine
