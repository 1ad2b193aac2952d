#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "engine/draw/row_edges.h"
#include "engine/draw/samplers.h"
#include "engine/draw/span_painter.h"

namespace engine {
namespace {

using ribbon::Vec2;

/// Two of the quantities that are interpolated over a triangle: u and v in texels, then the colour times alpha and
/// cover, 0 … 255: blue and green, red and alpha. Computed together, with the same bits as one by one.
using Two __attribute__((vector_size(16))) = double;
constexpr std::size_t pairs_of_quantities = 3;
constexpr std::size_t uv = 0;
constexpr std::size_t blue_green = 1;
constexpr std::size_t red_alpha = 2;

Two lesser(Two a, Two b) { return b < a ? b : a; }
Two greater(Two a, Two b) { return a < b ? b : a; }

/// Rounds to a multiple of 1/65536, in these units. Does not use floor, which would be a call.
std::int64_t fixed(double x) {
  const double near = x * 65536.0 + 0.5;
  const auto whole = static_cast<std::int64_t>(near);
  return whole - (static_cast<double>(whole) > near ? 1 : 0);
}

/// The corners of a triangle, sorted from the top.
template <typename Corner>
class Triangle {
 public:
  Triangle(const Corner& a, const Corner& b, const Corner& c) : corners_{&a, &b, &c} {
    const auto sort = [this](std::size_t k) {
      if (is_above(at(k + 1), at(k))) std::swap(corners_[k], corners_[k + 1]);
    };
    sort(0);
    sort(1);
    sort(0);
  }

  Vec2 at(std::size_t corner) const { return corners_[corner]->at; }
  Two value(std::size_t corner, std::size_t pair) const {
    const auto& all = corners_[corner]->values;
    return Two{all[2 * pair], all[2 * pair + 1]};
  }
  double alpha(std::size_t corner) const { return corners_[corner]->values.back(); }
  double twice_area() const { return cross(at(1) - at(0), at(2) - at(0)); }
  bool has_one_color() const {
    const auto same = [this](std::size_t k) {
      const double first = corners_[0]->values[k];
      return first == corners_[1]->values[k] && first == corners_[2]->values[k];
    };
    return same(2) && same(3) && same(4) && same(5);
  }

 private:
  std::array<const Corner*, 3> corners_;
};

/// The quantities as linear functions of x and y, clamped to the range of the corners: those of a sliver are steep, and
/// by rounding the middle of a pixel may be slightly outside the triangle.
class Planes {
 public:
  /// Computes the pairs from `first` to before `last`.
  template <typename Corner>
  Planes(const Triangle<Corner>& triangle, double twice_area, std::size_t first, std::size_t last)
      : at_(triangle.at(0)) {
    const Vec2 u = (1.0 / twice_area) * (triangle.at(1) - at_);
    const Vec2 v = (1.0 / twice_area) * (triangle.at(2) - at_);
    for (std::size_t k = first; k < last; ++k) {
      const Two a = triangle.value(0, k);
      const Two b = triangle.value(1, k);
      const Two c = triangle.value(2, k);
      const Two ub = b - a;
      const Two vc = c - a;
      origin_[k] = a;
      low_[k] = lesser(lesser(a, b), c);
      high_[k] = greater(greater(a, b), c);
      // Two pixels of a row in the triangle differ by at most the range.
      const Two range = high_[k] - low_[k];
      per_x_[k] = lesser(greater(ub * v.y - vc * u.y, -range), range);
      per_y_[k] = vc * u.x - ub * v.x;
    }
  }
  Two at(std::size_t k, double x, double y) const {
    const Two value = origin_[k] + per_x_[k] * (x - at_.x) + per_y_[k] * (y - at_.y);
    return lesser(greater(value, low_[k]), high_[k]);
  }
  Two per_x(std::size_t k) const { return per_x_[k]; }
  /// Returns whether all colours are constant along rows, as in a vertical gradient.
  bool constant_along_rows() const {
    const auto is_small = [](Two slope) { return std::abs(slope[0]) < 1e-7 && std::abs(slope[1]) < 1e-7; };
    return is_small(per_x_[blue_green]) && is_small(per_x_[red_alpha]);
  }
  /// The number of texels per pixel: the square root of the area of the image that a pixel covers.
  double texels_per_pixel() const {
    return std::sqrt(std::abs(per_x_[uv][0] * per_y_[uv][1] - per_x_[uv][1] * per_y_[uv][0]));
  }

 private:
  using Pairs = std::array<Two, pairs_of_quantities>;

  Vec2 at_;
  Pairs origin_, per_x_, per_y_, low_, high_;  // set for the pairs that are computed
};

ColorRamp::Channels channels_of(Two blue_and_green, Two red_and_alpha) {
  const auto channel = [](double value) { return static_cast<std::int32_t>(fixed(value)); };
  return ColorRamp::Channels{channel(blue_and_green[0]), channel(blue_and_green[1]), channel(red_and_alpha[0]),
                             channel(red_and_alpha[1])};
}

/// The pixels of a row that are in a triangle.
struct TexelRow {
  std::uint32_t* pixel;
  int count;
  double x, y;  // the middle of the first one
};

/// The part of a mesh's painting that is the same for all its triangles.
struct Target {
  std::uint32_t* pixels;
  int width;
  int left, top, right, bottom;  // px, clipped

  /// Calls paint(row) for each row of a triangle.
  template <typename Corner, typename Paint>
  void each_row(const Triangle<Corner>& triangle, Paint paint) const {
    const Edge whole(triangle.at(0), triangle.at(2));
    const Edge upper(triangle.at(0), triangle.at(1));
    const Edge lower(triangle.at(1), triangle.at(2));
    const double bend = triangle.at(1).y;
    const int last = first_pixel(triangle.at(2).y, top, bottom);
    for (int y = first_pixel(triangle.at(0).y, top, bottom); y < last; ++y) {
      const double middle = y + 0.5;
      const double long_x = whole.x(middle);
      const double short_x = middle < bend ? upper.x(middle) : lower.x(middle);
      const int begin = first_pixel(std::min(long_x, short_x), left, right);
      const int end = first_pixel(std::max(long_x, short_x), left, right);
      if (begin < end)
        paint(TexelRow{pixels + static_cast<std::ptrdiff_t>(y) * width + begin, end - begin, begin + 0.5, middle});
    }
  }
};

/// The quantities of a triangle along its rows.
class RowRamps {
 public:
  /// `scales` convert texels of the image to those of the sampler's level.
  template <typename Corner>
  RowRamps(const Planes& planes, const Triangle<Corner>& triangle, bool has_one_color, Two scales)
      : planes_(planes), scales_(scales), varies_(!has_one_color) {
    color_.here = channels_of(triangle.value(0, blue_green), triangle.value(0, red_alpha));
    if (has_one_color || planes.constant_along_rows()) return;
    color_.step = channels_of(planes.per_x(blue_green), planes.per_x(red_alpha));
  }

  /// The position in the image.
  struct Position {
    Ramp u, v;
  };
  Position position(const TexelRow& row) const {
    const Two here = scales_ * planes_.at(uv, row.x, row.y);
    const Two step = scales_ * planes_.per_x(uv);
    return {{fixed(here[0]), fixed(step[0])}, {fixed(here[1]), fixed(step[1])}};
  }
  ColorRamp color(const TexelRow& row) const {
    ColorRamp color = color_;
    if (varies_) color.here = channels_of(planes_.at(blue_green, row.x, row.y), planes_.at(red_alpha, row.x, row.y));
    return color;
  }

 private:
  const Planes& planes_;
  Two scales_;
  bool varies_;
  ColorRamp color_;
};

/// Paints a row of an image with interpolation. `u` and `v`: relative to the middles of texels.
template <bool repeats>
void paint_linear(const TexelRow& row, const Texels& texels, const Ramp& u, const Ramp& v, const ColorRamp& color) {
  if (is_inside(u, row.count, texels.width()) && is_inside(v, row.count, texels.height())) {
    const NeighboursInside inside{texels.data(), static_cast<std::ptrdiff_t>(texels.width())};
    paint_image(row.pixel, row.count, Linear(inside, u, v), color, texels.is_opaque());
  } else {
    paint_image(row.pixel, row.count, Linear(NeighboursAnywhere<repeats>{texels}, u, v), color, texels.is_opaque());
  }
}

/// Paints a row of an image. `repeats`: along u.
template <bool repeats>
void paint_row(const TexelRow& row, const Texels& texels, Filter filter, const RowRamps& ramps,
               std::vector<std::uint32_t>& store) {
  const auto [u, v] = ramps.position(row);
  const ColorRamp color = ramps.color(row);
  const bool is_opaque = texels.is_opaque();
  if (filter == Filter::nearest && v.step == 0)
    return paint_nearest_row(row.pixel, row.count, NearestRow<repeats>{texels, texels.row(v.here >> 16), u}, color);
  if (filter == Filter::nearest)
    return paint_image(row.pixel, row.count, Nearest<repeats>{texels, u, v}, color, is_opaque);
  if (v.step == 0 && LinearRow::suits(u, row.count))
    return paint_image(row.pixel, row.count, LinearRow(texels, u, v.here, row.count, store), color, is_opaque);
  paint_linear<repeats>(row, texels, {texels.wrapped_u(u.here - half_texel), u.step},
                        {texels.wrapped_v(v.here - half_texel), v.step}, color);
}

/// Paints a row without an image.
void paint_plain(const TexelRow& row, const ColorRamp& color) {
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
        image_size_{1.0, 1.0},
        store_(raster.texels_) {
    if (texture.image != nullptr) image_size_ = {1.0 * texture.image->width(), 1.0 * texture.image->height()};
  }

  Corner corner_of(const TexturedVertex& v) const {
    const double alpha = v.color.a * v.cover;
    const double part = alpha / 255.0;
    return {
        v.at,
        {v.uv.x * image_size_.x, v.uv.y * image_size_.y, part * v.color.b, part * v.color.g, part * v.color.r, alpha}};
  }

  void triangle(const Corner& a, const Corner& b, const Corner& c) {
    if (target_.left >= target_.right || target_.top >= target_.bottom || is_outside(a, b, c)) return;
    const Triangle triangle(a, b, c);
    const double twice_area = triangle.twice_area();
    if (twice_area == 0.0) return;
    const bool has_one_color = triangle.has_one_color();
    if (has_one_color && triangle.alpha(0) == 0.0) return;
    const Image* const image = texture_.image;
    const Planes planes(triangle, twice_area, image != nullptr ? uv : blue_green,
                        has_one_color ? blue_green : pairs_of_quantities);
    if (image == nullptr) {
      const RowRamps ramps(planes, triangle, has_one_color, Two{1.0, 1.0});
      return target_.each_row(triangle, [&](const TexelRow& row) { paint_plain(row, ramps.color(row)); });
    }
    const Image::Level& level = image->level(planes.texels_per_pixel());
    const RowRamps ramps(planes, triangle, has_one_color,
                         Two{level.width / image_size_.x, level.height / image_size_.y});
    const Texels texels(level, texture_);
    const auto paint_rows = [&](auto paint) {
      target_.each_row(triangle, [&](const TexelRow& row) { paint(row, texels, texture_.filter, ramps, store_); });
    };
    texels.repeats_along_u() ? paint_rows(paint_row<true>) : paint_rows(paint_row<false>);
  }

 private:
  bool is_outside(const Corner& a, const Corner& b, const Corner& c) const {
    return std::max({a.at.x, b.at.x, c.at.x}) < target_.left || std::min({a.at.x, b.at.x, c.at.x}) > target_.right ||
           std::max({a.at.y, b.at.y, c.at.y}) < target_.top || std::min({a.at.y, b.at.y, c.at.y}) > target_.bottom;
  }

  Target target_;
  const Texture& texture_;
  Vec2 image_size_;  // texels
  std::vector<std::uint32_t>& store_;
};

void Raster::fill(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) {
  Painter painter(*this, texture, clip);
  corners_.clear();
  for (const TexturedVertex& vertex : mesh.vertices) corners_.push_back(painter.corner_of(vertex));
  const auto corner = [&](std::size_t i) -> const Corner& {
    return corners_[static_cast<std::size_t>(mesh.indices[i])];
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    painter.triangle(corner(i), corner(i + 1), corner(i + 2));
}

}  // namespace engine
