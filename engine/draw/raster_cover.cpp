#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/draw/canvas_raster.h"
#include "engine/draw/row_edges.h"

namespace engine {
namespace {

using ribbon::Vec2;

/// Cover along a row is in units of 2^-20 of 1/255: integers, which the compiler computes several at a time.
constexpr int unit_bits = 20;
constexpr double units = 255.0 * (1 << unit_bits);
constexpr double max_units = 1 << 30;

std::uint8_t byte_of(double cover) {
  const double above = std::clamp(cover, 0.0, 1.0) * 255.0 + 0.5;  // lround would be a call
  return static_cast<std::uint8_t>(above);
}

using CoverRow = std::span<std::uint8_t>;

/// Raises the cover of a row of pixels to a value where it is lower.
void raise(CoverRow cover, std::uint8_t value) {
  constexpr std::size_t many = 32;
  if (value == 255 && cover.size() >= many) {
    std::fill(cover.begin(), cover.end(), value);
  } else {
    for (std::uint8_t& c : cover) c = std::max(c, value);
  }
}

/// Raises it to a value that changes along the row. `first`: at the first pixel, `per_x`: per pixel.
void raise(CoverRow cover, double first, double per_x) {
  const double here = units * first;
  const double step = units * per_x;
  const double last = here + step * static_cast<double>(cover.size());
  if (!(std::abs(here) < max_units && std::abs(last) < max_units)) {  // a sliver
    for (std::size_t k = 0; k < cover.size(); ++k)
      cover[k] = std::max(cover[k], byte_of(first + per_x * static_cast<double>(k)));
    return;
  }
  auto level = static_cast<std::int32_t>(here) + (1 << (unit_bits - 1));
  const auto change = static_cast<std::int32_t>(step);
  for (std::uint8_t& c : cover) {
    c = std::max(c, static_cast<std::uint8_t>(std::clamp(level >> unit_bits, 0, 255)));
    level += change;
  }
}

/// The cover of a triangle as a linear function of x and y.
struct CoverPlane {
  CoverPlane(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) : origin(a) {
    const Vec2 u = b.at - a.at;
    const Vec2 v = c.at - a.at;
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

/// A part of a row, px.
struct Part {
  double begin, end;
};

Part common(Part a, Part b) { return {std::max(a.begin, b.begin), std::min(a.end, b.end)}; }

/// A distance that changes linearly along a row.
struct Slope {
  explicit Slope(double per_pixel) : per_x(per_pixel), inverse(1.0 / per_pixel), is_level(std::abs(per_pixel) < 1e-9) {}

  /// Returns where it is from `low` to `high`. `at_origin`: its value at x = 0.
  Part where(double at_origin, double low, double high) const {
    constexpr double everywhere = 1e15;
    if (is_level) return low <= at_origin && at_origin <= high ? Part{-everywhere, everywhere} : Part{0.0, 0.0};
    const double a = (low - at_origin) * inverse;
    const double b = (high - at_origin) * inverse;
    return {std::min(a, b), std::max(a, b)};
  }

  double per_x;
  double inverse;
  bool is_level;
};

/// The pixels of a row that are in a bar.
struct BarRow {
  CoverRow cover;
  double x;                  // the middle of the first one, from the start of the bar
  int core_begin, core_end;  // from the first one
};

/// `distance`: at x = 0, `per_x`: its change per pixel.
void raise_across(const BarRow& row, double distance, double per_x, const Profile& profile) {
  const auto count = static_cast<int>(row.cover.size());
  const auto begin = static_cast<std::size_t>(std::clamp(row.core_begin, 0, count));
  const auto end = std::max(begin, static_cast<std::size_t>(std::clamp(row.core_end, 0, count)));
  const double scale = profile.cover / (profile.outer - profile.core);
  const auto cover_at = [&](std::size_t k) {
    return scale * (profile.outer - std::abs(distance + per_x * (row.x + static_cast<double>(k))));
  };
  if (begin > 0) raise(row.cover.first(begin), cover_at(0), scale * std::abs(per_x));
  if (begin < end) raise(row.cover.subspan(begin, end - begin), byte_of(profile.cover));
  if (end < row.cover.size()) raise(row.cover.subspan(end), cover_at(end), -scale * std::abs(per_x));
}

/// Raises the cover along a row that crosses a circle. `x` and `y`: the first pixel, from its middle.
void raise_around(CoverRow cover, double x, double y, const MeshRing& ring) {
  const double scale = ring.profile.cover / (ring.profile.outer - ring.profile.core);
  const double squared = y * y;
  for (std::size_t k = 0; k < cover.size(); ++k) {
    const double across = x + static_cast<double>(k);
    const double distance = std::abs(std::sqrt(across * across + squared) - ring.radius);
    const double value = std::min(scale * (ring.profile.outer - distance), ring.profile.cover);
    cover[k] = std::max(cover[k], byte_of(value));
  }
}

/// Returns half of the chord of a circle at a distance from its middle; 0 beside it.
double half_chord(double radius, double distance) {
  const double squared = radius * radius - distance * distance;
  return radius > 0.0 && squared > 0.0 ? std::sqrt(squared) : 0.0;
}

}  // namespace

/// Collects the cover of one mesh.
class Raster::CoverPainter {
 public:
  explicit CoverPainter(Raster& raster) : raster_(raster) {}

  void triangle(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    std::array<const MeshVertex*, 3> v{&a, &b, &c};
    if (is_above(v[1]->at, v[0]->at)) std::swap(v[0], v[1]);
    if (is_above(v[2]->at, v[1]->at)) std::swap(v[1], v[2]);
    if (is_above(v[1]->at, v[0]->at)) std::swap(v[0], v[1]);
    // Meshes have no triangles without area, but far outside rounding can give 0 in the sorted order.
    if (cross(v[1]->at - v[0]->at, v[2]->at - v[0]->at) == 0.0) return;
    const CoverPlane plane(*v[0], *v[1], *v[2]);
    const Edge whole(v[0]->at, v[2]->at);
    const Edge upper(v[0]->at, v[1]->at);
    const Edge lower(v[1]->at, v[2]->at);
    each_row(v[0]->at.y, v[2]->at.y, [&](int y, double middle) {
      const double long_x = whole.x(middle);
      const double short_x = middle < v[1]->at.y ? upper.x(middle) : lower.x(middle);
      const Pixels own = pixels(0.0, {std::min(long_x, short_x), std::max(long_x, short_x)});
      if (own.begin >= own.end) return;
      if (plane.flat()) return raise(row(y, own), byte_of(plane.origin.cover));
      raise(row(y, own), plane.at(own.begin + 0.5, middle), plane.per_x);
    });
  }

  void bar(const MeshBar& bar) {
    const double long_side = length(bar.to - bar.from);
    const Vec2 along = (1.0 / long_side) * (bar.to - bar.from);
    const Vec2 across = perp(along);
    const Profile& profile = bar.profile;
    const Slope advance(along.x);
    const Slope aside(across.x);
    const double reach = profile.outer * std::abs(across.y);
    const auto [top, bottom] = std::minmax(bar.from.y, bar.to.y);
    each_row(top - reach, bottom + reach, [&](int y, double middle) {
      // Parts are relative to the start of the bar.
      const double down = middle - bar.from.y;
      const double distance = down * across.y;
      const Pixels own = pixels(bar.from.x, common(advance.where(down * along.y, 0.0, long_side),
                                                   aside.where(distance, -profile.outer, profile.outer)));
      if (own.begin >= own.end) return;
      if (aside.is_level) return raise(row(y, own), byte_of(profile.at(std::abs(distance))));
      const Pixels core = pixels(bar.from.x, aside.where(distance, -profile.core, profile.core));
      raise_across({row(y, own), own.begin + 0.5 - bar.from.x, core.begin - own.begin, core.end - own.begin}, distance,
                   aside.per_x, profile);
    });
  }

  void ring(const MeshRing& ring) {
    const Profile& profile = ring.profile;
    const double outer = ring.radius + profile.outer;
    each_row(ring.center.y - outer, ring.center.y + outer, [&](int y, double middle) {
      const double down = middle - ring.center.y;
      const double half = half_chord(outer, down);
      const Pixels own = pixels(ring.center.x, {-half, half});
      if (own.begin >= own.end) return;
      // What needs no distances: the core of a disc, or the hole of a ring.
      const bool is_disc = ring.radius == 0.0;
      const double inner = half_chord(is_disc ? profile.core : ring.radius - profile.outer, down);
      Pixels middle_part = pixels(ring.center.x, {-inner, inner});
      middle_part.begin = std::clamp(middle_part.begin, own.begin, own.end);
      middle_part.end = std::clamp(middle_part.end, middle_part.begin, own.end);
      if (is_disc && middle_part.begin < middle_part.end) raise(row(y, middle_part), byte_of(profile.cover));
      for (const Pixels side : {Pixels{own.begin, middle_part.begin}, Pixels{middle_part.end, own.end}}) {
        if (side.begin < side.end) raise_around(row(y, side), side.begin + 0.5 - ring.center.x, down, ring);
      }
    });
  }

 private:
  struct Pixels {
    int begin, end;
  };
  /// Returns the pixels with their middles in a part of a row, which is relative to `origin`.
  Pixels pixels(double origin, Part part) const {
    return {first_pixel(origin + part.begin, 0, raster_.width_), first_pixel(origin + part.end, 0, raster_.width_)};
  }
  /// Returns the cover of at least one pixel of a row.
  CoverRow row(int y, Pixels pixels) {
    raster_.mark(y, pixels.begin, pixels.end);
    std::uint8_t* const line = raster_.cover_.data() + static_cast<std::ptrdiff_t>(y) * raster_.width_;
    return {line + pixels.begin, line + pixels.end};
  }
  /// Calls cover(y, middle of the row) for each row.
  template <typename Cover>
  void each_row(double top, double bottom, Cover cover) {
    const int first = first_pixel(top, 0, raster_.height_);
    const int last = first_pixel(bottom, 0, raster_.height_);
    if (first >= last) return;
    raster_.touched_.add(first, last);
    for (int y = first; y < last; ++y) cover(y, y + 0.5);
  }

  Raster& raster_;
};

void Raster::fill(const Mesh& mesh, std::uint32_t rgb, int opacity) {
  CoverPainter painter(*this);
  const auto vertex = [&](std::size_t i) -> const MeshVertex& {
    return mesh.vertices[static_cast<std::size_t>(mesh.indices[i])];
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    painter.triangle(vertex(i), vertex(i + 1), vertex(i + 2));
  for (const MeshBar& bar : mesh.bars) painter.bar(bar);
  for (const MeshRing& ring : mesh.rings) painter.ring(ring);
  for (int y = touched_.begin; y < touched_.end; ++y) blend_row(y, rgb, opacity);
  touched_ = {};
}

}  // namespace engine
