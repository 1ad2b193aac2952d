#pragma once

#include <limits>
#include <span>
#include <vector>

#include "engine/draw/canvas_mesh.h"
#include "engine/draw/color.h"
#include "engine/draw/image.h"
#include "ribbon/vec2.h"

namespace engine {

/// A corner of a textured mesh. Everything but its place is interpolated over the triangle.
struct TexturedVertex {
  ribbon::Vec2 at;             ///< px, y down
  ribbon::Vec2 uv{};           ///< of the image: (0, 0) is its top left corner, (1, 1) its bottom right one
  Color color{255, 255, 255};  ///< multiplied with the image's
  double cover = 1.0;          ///< 0 … 1; a border a pixel wide along which it falls to 0 is the antialiasing
};

/// Triangles, three indices each, in either order, painted one after the other. A pixel belongs to the triangle that
/// its middle is in; on an edge that two share, to one of them only, so that translucent ones show no seam.
struct TexturedMesh {
  std::vector<TexturedVertex> vertices;
  std::vector<int> indices;

  void clear() {
    vertices.clear();
    indices.clear();
  }
};

/// Between the middles of texels: the nearest one's colour, or mixed from the four around.
enum class Filter { nearest, linear };
/// Beyond the image's edge: over again, or the colour at the edge.
enum class Wrap { repeat, clamp };

/// How an image is laid on a mesh.
struct Texture {
  const Image* image = nullptr;  ///< none: the colours of the vertices alone
  Filter filter = Filter::linear;
  Wrap along_u = Wrap::repeat;
  Wrap along_v = Wrap::repeat;
};

/// The pixels from left to right and top to bottom, without right and bottom themselves.
struct PixelBox {
  int left = std::numeric_limits<int>::min();
  int top = std::numeric_limits<int>::min();
  int right = std::numeric_limits<int>::max();
  int bottom = std::numeric_limits<int>::max();
};

/// True if all indices are in range and all numbers such that it can be painted: places within ±1e12 px, uv within
/// ±1e6, covers 0 … 1.
bool is_paintable(const TexturedMesh& mesh);

/// Adds a shape that is made of triangles that do not overlap (add_disc, add_convex, add_rounded_rectangle). A point p
/// of it, in pixels, gets uv = ((p − origin) · u_axis, (p − origin) · v_axis).
struct UvMap {
  ribbon::Vec2 origin{};           ///< px
  ribbon::Vec2 u_axis{0.01, 0.0};  ///< 1/px
  ribbon::Vec2 v_axis{0.0, 0.01};  ///< 1/px
};
void add_shape(TexturedMesh& mesh, const Mesh& shape, const UvMap& map, Color color);

/// How a band along a line looks.
struct BandLook {
  double width = 1.0;               ///< px
  double u_per_pixel = 0.01;        ///< how much of the image goes along a pixel of the line's length
  double u_start = 0.0;             ///< at its first point
  Color color{255, 255, 255};       ///< of the whole, multiplied with the image's
  std::span<const Color> colors{};  ///< or of each point; as many as there are points
};

/// Adds a band of constant width along a line, in pixels. u runs along it; v across it, from 0 on the upper side of a
/// line that goes to the right to 1 on its lower side. Bends are round outside. Where the line bends wider than the
/// band and its pieces are longer than the band is wide at a corner, no two triangles overlap; elsewhere the later one
/// lies above, and nothing is left open. The ends are cut straight. Points closer than a hundredth of a pixel are one.
/// Adds nothing for less than two of them, or a number that cannot be drawn.
void add_band(TexturedMesh& mesh, std::span<const ribbon::Vec2> points, const BandLook& look);

}  // namespace engine
