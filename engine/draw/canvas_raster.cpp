#include "engine/draw/canvas_raster.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "engine/draw/row_edges.h"

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

/// Rounds 0 … 1 to 0 … 255. Does not use lround, which would be a call for each pixel.
std::uint8_t byte_of(double cover) {
  constexpr double half = 0.5;
  return static_cast<std::uint8_t>(std::clamp(cover, 0.0, 1.0) * 255.0 + half);
}

/// The cover of a triangle as a linear function of x and y.
struct CoverPlane {
  CoverPlane(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) : origin(a) {
    const ribbon::Vec2 u = b.at - a.at;
    const ribbon::Vec2 v = c.at - a.at;
    const double det = cross(u, v);
    per_x = ((b.cover - a.cover) * v.y - (c.cover - a.cover) * u.y) / det;
    per_y = ((c.cover - a.cover) * u.x - (b.cover - a.cover) * v.x) / det;
  }
  double at(double x, double y) const { return origin.cover + per_x * (x - origin.at.x) + per_y * (y - origin.at.y); }
  bool flat() const { return per_x == 0.0 && per_y == 0.0; }

  MeshVertex origin;
  double per_x;
  double per_y;
};

/// Raises the cover of a row of pixels to that of the plane where it is lower. (x, y) is the middle of the first pixel.
void raise(std::span<std::uint8_t> cover, const CoverPlane& plane, double x, double y) {
  if (plane.flat()) {
    const std::uint8_t value = byte_of(plane.origin.cover);
    if (value == 255) {
      std::fill(cover.begin(), cover.end(), value);
    } else {
      for (std::uint8_t& c : cover) c = std::max(c, value);
    }
    return;
  }
  double here = plane.at(x, y);
  for (std::uint8_t& c : cover) {
    c = std::max(c, byte_of(here));
    here += plane.per_x;
  }
}

}  // namespace

Raster::Raster(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      cover_(pixels_.size()),
      rows_(static_cast<std::size_t>(height)) {}

void Raster::fill_row(int row, std::uint32_t rgb) {
  std::fill_n(pixels_.begin() + static_cast<std::ptrdiff_t>(row) * width_, width_, rgb);
}

void Raster::fill(const Mesh& mesh, std::uint32_t rgb, int opacity) {
  const auto vertex = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(mesh.indices[i])]; };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) cover_triangle(vertex(i), vertex(i + 1), vertex(i + 2));
  for (int y = touched_.begin; y < touched_.end; ++y) blend_row(y, rgb, opacity);
  touched_ = {};
}

void Raster::cover_triangle(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
  std::array<MeshVertex, 3> v{a, b, c};
  std::sort(v.begin(), v.end(),
            [](const MeshVertex& one, const MeshVertex& other) { return is_above(one.at, other.at); });
  // Meshes have no triangles without area, but far outside rounding can give 0 in the sorted order.
  if (cross(v[1].at - v[0].at, v[2].at - v[0].at) == 0.0) return;
  const int first = first_pixel(v[0].at.y, 0, height_);
  const int last = first_pixel(v[2].at.y, 0, height_);
  if (first >= last) return;
  const CoverPlane plane(v[0], v[1], v[2]);
  const Edge whole(v[0].at, v[2].at);
  const Edge upper(v[0].at, v[1].at);
  const Edge lower(v[1].at, v[2].at);
  touched_.add(first, last);
  for (int y = first; y < last; ++y) {
    const double middle = y + 0.5;
    const double long_x = whole.x(middle);
    const double short_x = middle < v[1].at.y ? upper.x(middle) : lower.x(middle);
    const int begin = first_pixel(std::min(long_x, short_x), 0, width_);
    const int end = first_pixel(std::max(long_x, short_x), 0, width_);
    if (begin >= end) continue;
    rows_[static_cast<std::size_t>(y)].add(begin, end);
    std::uint8_t* line = cover_.data() + static_cast<std::ptrdiff_t>(y) * width_;
    raise({line + begin, line + end}, plane, begin + 0.5, middle);
  }
}

void Raster::blend_row(int y, std::uint32_t rgb, int opacity) {
  Range& row = rows_[static_cast<std::size_t>(y)];
  const std::ptrdiff_t line = static_cast<std::ptrdiff_t>(y) * width_;
  std::uint8_t* cover = cover_.data() + line;
  std::uint32_t* pixel = pixels_.data() + line;
  // Eight pixels at a time where the cover is full or zero, which is most of a shape.
  for (int x = row.begin; x < row.end;) {
    std::uint64_t eight = 1;
    if (x + 8 <= row.end) std::memcpy(&eight, cover + x, 8);
    const bool full = opacity == 255 && eight == ~std::uint64_t{0};
    if (full) std::fill_n(pixel + x, 8, rgb);
    if (full || eight == 0) {
      x += 8;
    } else {
      if (cover[x] > 0) pixel[x] = blend(pixel[x], rgb, alpha_of(cover[x], opacity));
      ++x;
    }
  }
  std::fill(cover + row.begin, cover + row.end, std::uint8_t{0});
  row = {};
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
