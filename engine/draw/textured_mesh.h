#pragma once

#include <limits>
#include <span>
#include <vector>

#include "engine/draw/canvas_mesh.h"
#include "engine/draw/color.h"
#include "engine/draw/image.h"
#include "ribbon/vec2.h"

namespace engine {

/// A corner of a textured mesh. All fields but `at` are interpolated over the triangle.
struct TexturedVertex {
  ribbon::Vec2 at;             ///< px, y down
  ribbon::Vec2 uv{};           ///< position in the image: (0, 0) is its top left corner, (1, 1) its bottom right one
  Color color{255, 255, 255};  ///< multiplied with the image
  double cover = 1.0;          ///< 0 … 1; falls to 0 over a border one pixel wide for antialiasing
};

/// Triangles, three indices each, in either order, painted one after the other. A pixel belongs to the triangle that
/// contains its middle; on a shared edge, to one of the two only, so that translucent triangles have no seams.
struct TexturedMesh {
  std::vector<TexturedVertex> vertices;
  std::vector<int> indices;

  void clear() {
    vertices.clear();
    indices.clear();
  }
};

/// Between the middles of texels: the colour of the nearest texel, or interpolation of four.
enum class Filter { nearest, linear };
/// Beyond the edge of the image: repetition, or the colour at the edge.
enum class Wrap { repeat, clamp };

/// How a mesh samples an image.
struct Texture {
  const Image* image = nullptr;  ///< null: only the colours of the vertices
  Filter filter = Filter::linear;
  Wrap along_u = Wrap::repeat;
  Wrap along_v = Wrap::repeat;
};

/// The pixels [left, right) × [top, bottom).
struct PixelBox {
  int left = std::numeric_limits<int>::min();
  int top = std::numeric_limits<int>::min();
  int right = std::numeric_limits<int>::max();
  int bottom = std::numeric_limits<int>::max();
};

/// Returns whether all indices are in range, coordinates within ±1e12 px, uv within ±1e6 and covers 0 … 1.
bool is_paintable(const TexturedMesh& mesh);

/// Texture coordinates of a point p in pixels: uv = ((p − origin) · u_axis, (p − origin) · v_axis).
struct UvMap {
  ribbon::Vec2 origin{};           ///< px
  ribbon::Vec2 u_axis{0.01, 0.0};  ///< 1/px
  ribbon::Vec2 v_axis{0.0, 0.01};  ///< 1/px
};
/// Adds the triangles of a shape, which do not overlap: add_convex, add_rounded_rectangle.
void add_shape(TexturedMesh& mesh, const Mesh& shape, const UvMap& map, Color color);
/// Adds an upright rectangle, in pixels, whose colours run from `top` to `bottom`, with the part of the image from (0,
/// 0) to `uv_end` on it.
void add_rectangle(TexturedMesh& mesh, ribbon::Vec2 top_left, ribbon::Vec2 size, Color top, Color bottom,
                   ribbon::Vec2 uv_end = {1.0, 1.0});
/// Adds a disc, in pixels. Adds nothing for numbers that cannot be drawn.
void add_disc(TexturedMesh& mesh, ribbon::Vec2 center, double radius, const UvMap& map, Color color);

/// The appearance of a band along a line.
struct BandLook {
  double width = 1.0;               ///< px
  double u_per_pixel = 0.01;        ///< change of u per pixel along the line
  double u_start = 0.0;             ///< u at the first point
  Color color{255, 255, 255};       ///< multiplied with the image
  std::span<const Color> colors{};  ///< one per point; replaces `color` unless empty
};

/// Adds a band of constant width along a line, in pixels. u runs along it; v across it, for a line to the right from 0
/// on the upper side to 1 on the lower side. Bends are round outside; the ends are cut straight. Triangles overlap only
/// in bends that are tighter than the band or at pieces shorter than its width: the later triangle is above, and there
/// are no gaps. Points closer than 0.01 px are merged, and those on a straight part, within 0.03 px, are left out
/// unless each has a colour. Adds nothing for less than two distinct points or numbers that cannot be drawn.
void add_band(TexturedMesh& mesh, std::span<const ribbon::Vec2> points, const BandLook& look);

}  // namespace engine
