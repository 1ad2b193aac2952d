#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "engine/draw/canvas_raster.h"
#include "engine/draw/lanes.h"
#include "engine/draw/samplers.h"

namespace engine {
namespace {

using ribbon::Vec2;

/// Returns the first pixel whose middle is at x or after it, clamped to low … high.
int first_pixel(double x, int low, int high) {
  // Does not use ceil, which would be a call.
  const double near = std::clamp(x - 0.5, static_cast<double>(low), static_cast<double>(high));
  const int whole = static_cast<int>(near);
  return whole + (whole < near ? 1 : 0);
}

/// The quantities that are interpolated over a triangle: u and v in texels, then the colour times alpha and cover,
/// 0 … 255, in the order of Lanes: blue, red, green, alpha.
constexpr int quantities = 6;
using Quantities = std::array<double, quantities>;
struct Corner {
  Vec2 at;
  Quantities value;
};

Corner corner_of(const TexturedVertex& v, double width, double height) {
  const double alpha = v.color.a * v.cover;
  const auto channel = [alpha](std::uint8_t c) { return c * alpha / 255.0; };
  return {v.at, {v.uv.x * width, v.uv.y * height, channel(v.color.b), channel(v.color.r), channel(v.color.g), alpha}};
}

/// An edge, to find its x at a height. Always computed from its upper end, so that two triangles that share an edge get
/// the same x: no pixel between them is missed or painted twice.
struct Edge {
  Edge(const Corner& upper, const Corner& lower)
      : at(upper.at), slope((lower.at.x - upper.at.x) / (lower.at.y - upper.at.y)) {}
  double x(double y) const { return at.x + (y - at.y) * slope; }

  Vec2 at;
  double slope;
};

bool above(const Corner& a, const Corner& b) { return a.at.y < b.at.y || (a.at.y == b.at.y && a.at.x < b.at.x); }

/// The quantities as linear functions of x and y, clamped to the range of the corners: those of a sliver are steep, and
/// by rounding the middle of a pixel may be slightly outside the triangle.
class Planes {
 public:
  Planes(const Corner& a, const Corner& b, const Corner& c) : origin_(a) {
    const Vec2 u = b.at - a.at;
    const Vec2 v = c.at - a.at;
    const double det = cross(u, v);
    for (std::size_t k = 0; k < quantities; ++k) {
      const double ub = b.value[k] - a.value[k];
      const double vc = c.value[k] - a.value[k];
      per_x_[k] = (ub * v.y - vc * u.y) / det;
      per_y_[k] = (vc * u.x - ub * v.x) / det;
      low_[k] = std::min({a.value[k], b.value[k], c.value[k]});
      high_[k] = std::max({a.value[k], b.value[k], c.value[k]});
    }
  }
  double at(std::size_t k, double x, double y) const {
    const double value = origin_.value[k] + per_x_[k] * (x - origin_.at.x) + per_y_[k] * (y - origin_.at.y);
    return std::clamp(value, low_[k], high_[k]);
  }
  double low(std::size_t k) const { return low_[k]; }
  bool flat(std::size_t k) const { return low_[k] == high_[k]; }
  /// Returns whether all colours are constant along rows, as in a vertical gradient.
  bool constant_along_rows() const {
    return std::all_of(per_x_.begin() + 2, per_x_.end(), [](double slope) { return std::abs(slope) < 1e-7; });
  }
  /// The number of texels per pixel: the square root of the area of the image that a pixel covers.
  double texels_per_pixel() const { return std::sqrt(std::abs(per_x_[0] * per_y_[1] - per_x_[1] * per_y_[0])); }

 private:
  Corner origin_;
  Quantities per_x_{}, per_y_{}, low_{}, high_{};
};

/// A quantity along a row, in units of 1/65536.
struct Ramp {
  std::int64_t here = 0;
  std::int64_t step = 0;  // per pixel
};

/// Rounds down. Does not use floor, which would be a call.
std::int64_t whole_below(double x) {
  const auto whole = static_cast<std::int64_t>(x);
  return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

std::int64_t fixed(double x) { return whole_below(x * 65536.0 + 0.5); }

Ramp ramp_of(double first, double last, int pixels) {
  return {fixed(first), pixels > 1 ? (fixed(last) - fixed(first)) / (pixels - 1) : 0};
}

/// The pixels of a row that are in the triangle, and the quantities along them.
struct Span {
  std::uint32_t* pixel;
  int count;
  std::array<Ramp, quantities> ramp;
};

void blend(std::uint32_t& pixel, Lanes color) {
  if (color >= 0x00ff000000000000U) {
    pixel = packed(color) & 0xffffffU;
  } else if (color != 0) {
    pixel = over(color, pixel);
  }
}

/// Paints the image with all its colours changed by `change`, which is constant along the row.
template <typename Sample, typename Change>
void paint_evenly(Span span, Sample sample, Change change) {
  auto [u, v] = std::array{span.ramp[0], span.ramp[1]};
  for (std::uint32_t* const end = span.pixel + span.count; span.pixel != end; ++span.pixel) {
    blend(*span.pixel, change(sample(u.here, v.here)));
    u.here += u.step;
    v.here += v.step;
  }
}

template <typename Sample>
void paint_tinted(Span span, Sample sample) {
  auto& [u, v, b, r, g, a] = span.ramp;
  for (std::uint32_t* const end = span.pixel + span.count; span.pixel != end; ++span.pixel) {
    if (const Lanes color = sample(u.here, v.here); color != 0)
      blend(*span.pixel, tinted(color, b.here, r.here, g.here, a.here));
    for (Ramp& ramp : span.ramp) ramp.here += ramp.step;
  }
}

/// Paints an image with the cheapest method for the colours of the row. `flat`: they are constant along it.
template <typename Sample>
void paint_image(const Span& span, const Sample& sample, bool flat) {
  const auto& [u, v, b, r, g, a] = span.ramp;
  if (!flat) return paint_tinted(span, sample);
  constexpr std::int64_t white = 255 << 16;
  const bool grey = b.here == r.here && b.here == g.here;
  if (grey && b.here == a.here) {
    if (a.here == white) return paint_evenly(span, sample, [](Lanes color) { return color; });
    const auto scale = static_cast<Lanes>(a.here * 257 >> 24U);
    return paint_evenly(span, sample, [scale](Lanes color) { return scaled(color, scale); });
  }
  if (grey && a.here == white) {
    const auto scale = static_cast<Lanes>(b.here * 257 >> 24U);
    return paint_evenly(span, sample, [scale](Lanes color) { return darkened(color, scale); });
  }
  paint_evenly(span, sample, [b = b.here, r = r.here, g = g.here, a = a.here](Lanes color) {
    return color != 0 ? tinted(color, b, r, g, a) : color;
  });
}

void paint_flat(Span span, Lanes color) {
  if (color >> 48U == 255U) {
    std::fill_n(span.pixel, span.count, packed(color) & 0xffffffU);
    return;
  }
  for (std::uint32_t* const end = span.pixel + span.count; span.pixel != end; ++span.pixel)
    *span.pixel = over(color, *span.pixel);
}

/// Copies a row of texels, one for each pixel.
void copy_texels(Span span, const std::uint32_t* texel) {
  for (std::uint32_t* const end = span.pixel + span.count; span.pixel != end; ++span.pixel, ++texel) {
    if (const std::uint32_t alpha = *texel >> 24U; alpha == 255U) {
      *span.pixel = *texel & 0xffffffU;
    } else if (alpha != 0U) {
      *span.pixel = over(spread(*texel), *span.pixel);
    }
  }
}

/// Paints an opaque image that repeats, its colours multiplied by scale / 256. The same as paint_evenly with darkened,
/// in half the instructions.
void paint_opaque(Span span, const NearestRow& sample, std::uint32_t scale) {
  Ramp u = span.ramp[0];
  const std::int64_t mask = sample.texels.width() - 1;
  for (std::uint32_t* const end = span.pixel + span.count; span.pixel != end; ++span.pixel, u.here += u.step) {
    const std::uint32_t texel = sample.row[u.here >> 16 & mask];
    *span.pixel = ((texel & 0xff00ffU) * scale >> 8U & 0xff00ffU) | ((texel & 0xff00U) * scale >> 8U & 0xff00U);
  }
}

/// Paints an image row by row. Where a texel covers exactly a pixel and has its own colour, it is copied.
void paint_nearest_row(const Span& span, const NearestRow& sample, bool flat) {
  constexpr std::int64_t white = 255 << 16;
  constexpr std::int64_t one_texel = 1 << 16;
  const auto& [u, v, b, r, g, a] = span.ramp;
  const std::int64_t first = u.here >> 16;
  const bool own_color = flat && b.here == white && r.here == white && g.here == white && a.here == white;
  if (own_color && u.step == one_texel && first >= 0 && first + span.count <= sample.texels.width())
    return copy_texels(span, sample.row + first);
  const bool grey = flat && b.here == r.here && b.here == g.here && a.here == white;
  if (grey && sample.texels.is_opaque() && sample.texels.repeats_along_u())
    return paint_opaque(span, sample, b.here == white ? 256U : static_cast<std::uint32_t>(b.here * 257 >> 24U));
  paint_image(span, sample, flat);
}

Lanes first_color(const Span& span) {
  const auto& [u, v, b, r, g, a] = span.ramp;
  return tinted(white_lanes, b.here, r.here, g.here, a.here);
}

/// `flat`: the colours are constant along the row.
template <typename Sample>
void paint_span(const Span& span, const Sample& sample, bool flat) {
  if constexpr (std::is_same_v<Sample, Plain>) {
    if (flat) {
      paint_flat(span, first_color(span));
    } else {
      paint_tinted(span, sample);
    }
  } else if (std::is_same_v<Sample, Linear> && span.ramp[1].step == 0) {
    paint_image(span, LinearRow(sample.texels, span.ramp[1].here), flat);
  } else if (std::is_same_v<Sample, Nearest> && span.ramp[1].step == 0) {
    paint_nearest_row(span, NearestRow(sample.texels, span.ramp[1].here), flat);
  } else {
    paint_image(span, sample, flat);
  }
}

}  // namespace

/// Paints one mesh on a raster's pixels.
class Raster::Painter {
 public:
  Painter(Raster& raster, const Texture& texture, const PixelBox& clip)
      : pixels_(raster.pixels_.data()),
        width_(raster.width_),
        texture_(texture),
        left_(std::max(clip.left, 0)),
        top_(std::max(clip.top, 0)),
        right_(std::min(clip.right, raster.width_)),
        bottom_(std::min(clip.bottom, raster.height_)) {}

  void triangle(const TexturedVertex& a, const TexturedVertex& b, const TexturedVertex& c) {
    if (left_ >= right_ || top_ >= bottom_ || is_outside(a, b, c)) return;
    const Image* const image = texture_.image;
    const double width = image != nullptr ? image->width() : 1.0;
    const double height = image != nullptr ? image->height() : 1.0;
    std::array<Corner, 3> v{corner_of(a, width, height), corner_of(b, width, height), corner_of(c, width, height)};
    std::sort(v.begin(), v.end(), above);
    if (cross(v[1].at - v[0].at, v[2].at - v[0].at) == 0.0) return;
    const Planes planes(v[0], v[1], v[2]);
    if (image == nullptr) {
      paint(v, planes, 1.0, 1.0, Plain{});
      return;
    }
    const Image::Level& level = image->level(planes.texels_per_pixel());
    const double u_scale = level.width / width;
    const double v_scale = level.height / height;
    const Texels texels(level, texture_);
    if (texture_.filter == Filter::linear) {
      paint(v, planes, u_scale, v_scale, Linear{texels});
    } else {
      paint(v, planes, u_scale, v_scale, Nearest{texels});
    }
  }

 private:
  bool is_outside(const TexturedVertex& a, const TexturedVertex& b, const TexturedVertex& c) const {
    const auto [x_low, x_high] = std::minmax({a.at.x, b.at.x, c.at.x});
    const auto [y_low, y_high] = std::minmax({a.at.y, b.at.y, c.at.y});
    return x_high < left_ || x_low > right_ || y_high < top_ || y_low > bottom_;
  }

  /// Paints a triangle whose corners are sorted from the top. `u_scale` and `v_scale` convert texels of the image to
  /// those of the sampler's level.
  template <typename Sample>
  void paint(const std::array<Corner, 3>& v, const Planes& planes, double u_scale, double v_scale,
             const Sample& sample) {
    const bool flat = planes.flat(2) && planes.flat(3) && planes.flat(4) && planes.flat(5);
    if (flat && planes.low(5) == 0.0) return;
    std::array<Ramp, 4> colors;
    for (std::size_t k = 0; k < colors.size(); ++k) colors[k].here = fixed(planes.low(k + 2));
    const bool constant = flat || planes.constant_along_rows();
    const Edge whole(v[0], v[2]);
    const Edge upper(v[0], v[1]);
    const Edge lower(v[1], v[2]);
    const int last = first_pixel(v[2].at.y, top_, bottom_);
    for (int y = first_pixel(v[0].at.y, top_, bottom_); y < last; ++y) {
      const double middle = y + 0.5;
      const double long_x = whole.x(middle);
      const double short_x = middle < v[1].at.y ? upper.x(middle) : lower.x(middle);
      const int begin = first_pixel(std::min(long_x, short_x), left_, right_);
      const int end = first_pixel(std::max(long_x, short_x), left_, right_);
      if (begin >= end) continue;
      Span span{pixels_ + static_cast<std::ptrdiff_t>(y) * width_ + begin, end - begin, {}};
      const auto ramp = [&](std::size_t k, double scale) {
        return ramp_of(scale * planes.at(k, begin + 0.5, middle), scale * planes.at(k, end - 0.5, middle), span.count);
      };
      if (flat) {
        std::copy(colors.begin(), colors.end(), span.ramp.begin() + 2);
      } else if (constant) {
        for (std::size_t k = 2; k < quantities; ++k) span.ramp[k].here = fixed(planes.at(k, begin + 0.5, middle));
      } else {
        for (std::size_t k = 2; k < quantities; ++k) span.ramp[k] = ramp(k, 1.0);
      }
      if constexpr (!std::is_same_v<Sample, Plain>) {
        span.ramp[0] = ramp(0, u_scale);
        span.ramp[1] = ramp(1, v_scale);
      }
      paint_span(span, sample, constant);
    }
  }

  std::uint32_t* pixels_;
  int width_;
  const Texture& texture_;
  int left_, top_, right_, bottom_;
};

void Raster::fill(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) {
  Painter painter(*this, texture, clip);
  const auto vertex = [&mesh](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(mesh.indices[i])]; };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    painter.triangle(vertex(i), vertex(i + 1), vertex(i + 2));
}

}  // namespace engine
