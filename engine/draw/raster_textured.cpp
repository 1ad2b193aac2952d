#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "engine/draw/row_edges.h"
#include "engine/draw/samplers.h"
#include "engine/draw/span_painter.h"

namespace engine {
namespace {

using ribbon::Vec2;

/// The quantities that are interpolated over a triangle: u and v in texels, then the colour times alpha and cover,
/// 0 … 255: blue, green, red, alpha.
constexpr std::size_t quantities = 6;
constexpr std::size_t positions = 2;  // of them
using Quantities = std::array<double, quantities>;
struct Corner {
  Vec2 at;
  Quantities value;
};

Corner corner_of(const TexturedVertex& v, double width, double height) {
  const double alpha = v.color.a * v.cover;
  const double part = alpha / 255.0;
  return {v.at, {v.uv.x * width, v.uv.y * height, part * v.color.b, part * v.color.g, part * v.color.r, alpha}};
}

/// Rounds to a multiple of 1/65536, in these units. Does not use floor, which would be a call.
std::int64_t fixed(double x) {
  const double near = x * 65536.0 + 0.5;
  const auto whole = static_cast<std::int64_t>(near);
  return whole - (static_cast<double>(whole) > near ? 1 : 0);
}

/// The quantities as linear functions of x and y, clamped to the range of the corners: those of a sliver are steep, and
/// by rounding the middle of a pixel may be slightly outside the triangle.
class Planes {
 public:
  /// Computes the quantities from `first` to before `last`.
  Planes(const std::array<Corner, 3>& corners, double twice_area, std::size_t first, std::size_t last)
      : origin_(corners[0]) {
    const auto& [a, b, c] = corners;
    const Vec2 u = (1.0 / twice_area) * (b.at - a.at);
    const Vec2 v = (1.0 / twice_area) * (c.at - a.at);
    for (std::size_t k = first; k < last; ++k) {
      const double ub = b.value[k] - a.value[k];
      const double vc = c.value[k] - a.value[k];
      low_[k] = std::min({a.value[k], b.value[k], c.value[k]});
      high_[k] = std::max({a.value[k], b.value[k], c.value[k]});
      // Two pixels of a row in the triangle differ by at most the range.
      const double range = high_[k] - low_[k];
      per_x_[k] = std::clamp(ub * v.y - vc * u.y, -range, range);
      per_y_[k] = vc * u.x - ub * v.x;
    }
  }
  double at(std::size_t k, double x, double y) const {
    const double value = origin_.value[k] + per_x_[k] * (x - origin_.at.x) + per_y_[k] * (y - origin_.at.y);
    return std::clamp(value, low_[k], high_[k]);
  }
  double per_x(std::size_t k) const { return per_x_[k]; }
  /// Returns whether all colours are constant along rows, as in a vertical gradient.
  bool constant_along_rows() const {
    return std::all_of(per_x_.begin() + positions, per_x_.end(), [](double slope) { return std::abs(slope) < 1e-7; });
  }
  /// The number of texels per pixel: the square root of the area of the image that a pixel covers.
  double texels_per_pixel() const { return std::sqrt(std::abs(per_x_[0] * per_y_[1] - per_x_[1] * per_y_[0])); }

 private:
  const Corner& origin_;
  Quantities per_x_{}, per_y_{}, low_{}, high_{};
};

bool have_one_color(const std::array<Corner, 3>& corners) {
  const auto same = [&corners](std::size_t k) {
    return corners[0].value[k] == corners[1].value[k] && corners[0].value[k] == corners[2].value[k];
  };
  return same(2) && same(3) && same(4) && same(5);
}

ColorRamp color_at(const Corner& corner) {
  ColorRamp color;
  for (std::size_t k = 0; k < 4; ++k) color.here[k] = static_cast<std::int32_t>(fixed(corner.value[positions + k]));
  return color;
}

/// The pixels of a row that are in a triangle.
struct Row {
  std::uint32_t* pixel;
  int count;
  double x, y;  // the middle of the first one
};

/// The part of a mesh's painting that is the same for all its triangles.
struct Target {
  std::uint32_t* pixels;
  int width;
  int left, top, right, bottom;  // px, clipped

  /// Calls paint(row) for each row of a triangle whose corners are sorted from the top.
  template <typename Paint>
  void each_row(const std::array<Corner, 3>& v, Paint paint) const {
    const Edge whole(v[0].at, v[2].at);
    const Edge upper(v[0].at, v[1].at);
    const Edge lower(v[1].at, v[2].at);
    const int last = first_pixel(v[2].at.y, top, bottom);
    for (int y = first_pixel(v[0].at.y, top, bottom); y < last; ++y) {
      const double middle = y + 0.5;
      const double long_x = whole.x(middle);
      const double short_x = middle < v[1].at.y ? upper.x(middle) : lower.x(middle);
      const int begin = first_pixel(std::min(long_x, short_x), left, right);
      const int end = first_pixel(std::max(long_x, short_x), left, right);
      if (begin < end)
        paint(Row{pixels + static_cast<std::ptrdiff_t>(y) * width + begin, end - begin, begin + 0.5, middle});
    }
  }
};

/// The quantities of a triangle along its rows.
class RowRamps {
 public:
  /// `u_scale` and `v_scale` convert texels of the image to those of the sampler's level.
  RowRamps(const Planes& planes, const Corner& corner, bool has_one_color, double u_scale, double v_scale)
      : planes_(planes), scales_{u_scale, v_scale}, varies_(!has_one_color), color_(color_at(corner)) {
    for (std::size_t k = 0; k < positions; ++k) steps_[k] = fixed(scales_[k] * planes.per_x(k));
    if (has_one_color || planes.constant_along_rows()) return;
    for (std::size_t k = 0; k < 4; ++k) color_.step[k] = static_cast<std::int32_t>(fixed(planes.per_x(positions + k)));
  }

  Ramp position(std::size_t k, const Row& row) const {
    return {fixed(scales_[k] * planes_.at(k, row.x, row.y)), steps_[k]};
  }
  ColorRamp color(const Row& row) const {
    ColorRamp color = color_;
    for (std::size_t k = 0; varies_ && k < 4; ++k)
      color.here[k] = static_cast<std::int32_t>(fixed(planes_.at(positions + k, row.x, row.y)));
    return color;
  }

 private:
  const Planes& planes_;
  std::array<double, positions> scales_;
  std::array<std::int64_t, positions> steps_{};
  bool varies_;
  ColorRamp color_;
};

/// Paints a row of an image. `repeats`: along u.
template <bool repeats>
void paint_row(const Row& row, const Texels& texels, Filter filter, const RowRamps& ramps,
               std::vector<std::uint32_t>& store) {
  const Ramp u = ramps.position(0, row);
  const Ramp v = ramps.position(1, row);
  const ColorRamp color = ramps.color(row);
  const bool is_opaque = texels.is_opaque();
  if (filter == Filter::nearest && v.step == 0)
    return paint_nearest_row(row.pixel, row.count, NearestRow<repeats>{texels, texels.row(v.here >> 16), u}, color);
  if (filter == Filter::nearest)
    return paint_image(row.pixel, row.count, Nearest<repeats>{texels, u, v}, color, is_opaque);
  if (v.step == 0 && LinearRow::suits(u, row.count))
    return paint_image(row.pixel, row.count, LinearRow(texels, u, v.here, row.count, store), color, is_opaque);
  paint_image(row.pixel, row.count, Linear<repeats>{texels, u, v}, color, is_opaque);
}

/// Paints a row without an image.
void paint_plain(const Row& row, const ColorRamp& color) {
  if (color.is_constant()) return paint_flat(row.pixel, row.count, EvenTint(color)(Plain{}.pair()));
  paint_pairs<false>(row.pixel, row.count, Plain{}, RampTint(color));
}

}  // namespace

/// Paints one mesh on a raster's pixels.
class Raster::Painter {
 public:
  Painter(Raster& raster, const Texture& texture, const PixelBox& clip)
      : target_{raster.pixels_.data(),
                raster.width_,
                std::max(clip.left, 0),
                std::max(clip.top, 0),
                std::min(clip.right, raster.width_),
                std::min(clip.bottom, raster.height_)},
        texture_(texture),
        store_(raster.texels_) {}

  void triangle(const TexturedVertex& a, const TexturedVertex& b, const TexturedVertex& c) {
    if (target_.left >= target_.right || target_.top >= target_.bottom || is_outside(a, b, c)) return;
    std::array<const TexturedVertex*, 3> sorted{&a, &b, &c};
    std::sort(sorted.begin(), sorted.end(),
              [](const auto* one, const auto* other) { return is_above(one->at, other->at); });
    const Image* const image = texture_.image;
    const double width = image != nullptr ? image->width() : 1.0;
    const double height = image != nullptr ? image->height() : 1.0;
    const std::array<Corner, 3> v{corner_of(*sorted[0], width, height), corner_of(*sorted[1], width, height),
                                  corner_of(*sorted[2], width, height)};
    const double twice_area = cross(v[1].at - v[0].at, v[2].at - v[0].at);
    if (twice_area == 0.0) return;
    const bool has_one_color = have_one_color(v);
    if (has_one_color && v[0].value[5] == 0.0) return;
    const Planes planes(v, twice_area, image != nullptr ? 0 : positions, has_one_color ? positions : quantities);
    if (image == nullptr) {
      const RowRamps ramps(planes, v[0], has_one_color, 1.0, 1.0);
      return target_.each_row(v, [&](const Row& row) { paint_plain(row, ramps.color(row)); });
    }
    const Image::Level& level = image->level(planes.texels_per_pixel());
    const RowRamps ramps(planes, v[0], has_one_color, level.width / width, level.height / height);
    const Texels texels(level, texture_);
    const auto paint_rows = [&](auto paint) {
      target_.each_row(v, [&](const Row& row) { paint(row, texels, texture_.filter, ramps, store_); });
    };
    texels.repeats_along_u() ? paint_rows(paint_row<true>) : paint_rows(paint_row<false>);
  }

 private:
  bool is_outside(const TexturedVertex& a, const TexturedVertex& b, const TexturedVertex& c) const {
    const auto [x_low, x_high] = std::minmax({a.at.x, b.at.x, c.at.x});
    const auto [y_low, y_high] = std::minmax({a.at.y, b.at.y, c.at.y});
    return x_high < target_.left || x_low > target_.right || y_high < target_.top || y_low > target_.bottom;
  }

  Target target_;
  const Texture& texture_;
  std::vector<std::uint32_t>& store_;
};

void Raster::fill(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) {
  Painter painter(*this, texture, clip);
  const auto vertex = [&mesh](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(mesh.indices[i])]; };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    painter.triangle(vertex(i), vertex(i + 1), vertex(i + 2));
}

}  // namespace engine
