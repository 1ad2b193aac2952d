#include "game/view/backdrop_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr int period = 4096;             // hills, after which the outline repeats
constexpr double sampling = 1.0 / 64.0;  // heights of the canvas, between two points of an outline
constexpr int prop_sizes = 5;
constexpr double spike_pitch = 0.085;  // heights of the canvas, between two spikes

/// Returns the length of the spike at x: each has a place, a width and a length of its own.
double spike(const Range& range, double x) {
  const int cell = static_cast<int>(std::floor(x / spike_pitch));
  double longest = 0.0;
  for (int k = cell - 1; k <= cell + 1; ++k) {
    const double size = scatter(k, 1, range.seed);
    const double middle = spike_pitch * (k + 0.2 + 0.6 * scatter(k, 2, range.seed));
    const double half = spike_pitch * (0.28 + 0.40 * size);
    const double near = std::max(1.0 - std::abs(x - middle) / half, 0.0);
    longest = std::max(longest, range.spikes * size * size * std::pow(near, 1.7));
  }
  return longest;
}

double height_at(const Range& range, double x) {
  const double swell = range.swell * (tiled_noise(x / range.length, 0.0, period, range.seed) - 0.5);
  const double jag = range.jag * (tiled_noise(8.0 * x / range.length, 0.0, period, range.seed + 50) - 0.5);
  return swell + jag + (range.spikes > 0.0 ? spike(range, x) : 0.0);
}

/// Returns the y in px of the outline at a place of the layer.
double y_of(const Pen& pen, const Range& range, double place) {
  const double high = pen.canvas.height();
  const double up = range.climb * (1.0 - range.follow) * camera_offset(pen).y;
  const double height = range.height + height_at(range, place);
  return range.hangs ? high * (height + up) : high * (1.0 - height + up);
}

}  // namespace

Vec2 camera_offset(const Pen& pen) {
  const double high = pen.canvas.height() / pen.scale();
  const Vec2 at = pen.canvas.view().center;
  return (1.0 / high) * Vec2{at.x, at.y - 0.5 * high};
}

double shift_of(const Pen& pen, const Range& range) { return (1.0 - range.follow) * camera_offset(pen).x; }

double outline_at(const Pen& pen, const Range& range, double x) {
  return y_of(pen, range, x / pen.canvas.height() + shift_of(pen, range));
}

Outline outline_of(const Pen& pen, const Range& range) {
  const double high = pen.canvas.height();
  const double step = range.spikes > 0.0 ? 0.5 * sampling : sampling;
  const double shift = shift_of(pen, range);
  const int first = static_cast<int>(std::floor(shift / step));
  const int last = static_cast<int>(std::ceil((shift + pen.canvas.width() / high) / step));
  Outline outline;
  for (int k = first; k <= last; ++k) outline.points.push_back({high * (step * k - shift), y_of(pen, range, step * k)});
  const auto [top, bottom] =
      std::minmax_element(outline.points.begin(), outline.points.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
  outline.highest = top->y;
  outline.lowest = bottom->y;
  return outline;
}

void draw_range(Pen& pen, const Outline& outline, Color color, Color mist, double cut) {
  engine::SkylineLook look;
  look.top = outline.highest;
  look.bottom = std::max(outline.highest + 0.30 * pen.canvas.height(), outline.lowest + 1.0);
  look.upper = color;
  look.lower = mix(color, mist, 0.75);
  look.end = cut;
  if (outline.highest < cut) pen.canvas.skyline(outline.points, look);
}

void draw_ceiling(Pen& pen, const Outline& outline, Color color, Color mist) {
  engine::SkylineLook look;
  look.bottom = outline.lowest;
  look.top = std::min(outline.lowest - 0.30 * pen.canvas.height(), outline.highest - 1.0);
  look.upper = mix(color, mist, 0.75);
  look.lower = color;
  look.is_above = true;
  if (outline.lowest > 0.0) pen.canvas.skyline(outline.points, look);
}

void draw_props(Pen& pen, const Range& range, const engine::Image& image, const Stand& stand) {
  const double high = pen.canvas.height();
  // Few sizes, for which copies are stored.
  const auto tall_of = [&](double size) { return std::round(high * stand.size * (0.6 + 0.2 * size)); };
  for (int size = 0; pen.prepares && size < prop_sizes; ++size)
    pen.prepare(image, {stand.aspect * tall_of(size), tall_of(size)}, {255, 255, 255});
  const double shift = shift_of(pen, range);
  const int first = static_cast<int>(std::floor(shift / stand.spacing)) - 1;
  const int last = static_cast<int>(std::ceil((shift + pen.canvas.width() / high) / stand.spacing)) + 1;
  for (int k = first; k <= last; ++k) {
    if (tiled_noise(0.21 * k, 0.5, period, range.seed + 7) < stand.dense) continue;  // groups trees into woods
    const double place = stand.spacing * (k + 0.7 * scatter(k, 1, range.seed));
    const double tall = tall_of(std::floor(prop_sizes * scatter(k, 2, range.seed)));
    const double y = std::round(y_of(pen, range, place) + 0.06 * tall);
    if (y - tall > high) continue;
    pen.stamp(image, {high * (place - shift), y - 0.5 * tall}, {stand.aspect * tall, tall}, {255, 255, 255});
  }
}

void add_quad(engine::TexturedMesh& mesh, const std::array<Corner, 4>& corners) {
  const int v = static_cast<int>(mesh.vertices.size());
  for (const Corner& corner : corners) mesh.vertices.push_back({corner.at, {}, corner.color});
  mesh.indices.insert(mesh.indices.end(), {v, v + 1, v + 2, v, v + 2, v + 3});
}

void draw_clouds(Pen& pen, const Clouds& clouds) {
  const double high = pen.canvas.height();
  const double wide = pen.canvas.width() / high;
  // Each image in a small and a large size; large clouds are fainter.
  const auto size_of = [&](int kind) {
    return std::round(high * (clouds.size + (kind < 3 ? 0.25 : 0.85) * clouds.growth));
  };
  const auto color_of = [&](int kind) {
    return with_alpha(pen.colors.cloud, kind < 3 ? (255 + clouds.opacity) / 2 : clouds.opacity);
  };
  const auto image_of = [&](int kind) -> const engine::Image& {
    return pen.images.clouds.at(static_cast<std::size_t>(kind % 3));
  };
  for (int kind = 0; pen.prepares && kind < 6; ++kind)
    pen.prepare(image_of(kind), {size_of(kind), 0.5 * size_of(kind)}, color_of(kind));
  const double drift = pen.reduced_motion ? 0.0 : clouds.drift * pen.time;
  const double shift = 0.05 * camera_offset(pen).x - drift;
  const int first = static_cast<int>(std::floor(shift / clouds.spacing)) - 2;
  const int last = static_cast<int>(std::ceil((shift + wide) / clouds.spacing)) + 1;
  for (int k = first; k <= last; ++k) {
    if (scatter(k, 5, clouds.seed) < 0.25) continue;
    const int kind = static_cast<int>(6.0 * scatter(k, 4, clouds.seed));
    const double x = clouds.spacing * (k + 0.6 * scatter(k, 2, clouds.seed)) - shift;
    const double y = clouds.top + clouds.depth * scatter(k, 3, clouds.seed) + 0.05 * camera_offset(pen).y;
    pen.stamp(image_of(kind), high * Vec2{x, y}, {size_of(kind), 0.5 * size_of(kind)}, color_of(kind));
  }
}

void draw_sun(Pen& pen, Vec2 at, double glow, double disc) {
  const double high = pen.canvas.height();
  const Vec2 middle{at.x * pen.canvas.width(), at.y * high};
  pen.sprite(pen.images.glow, middle, {glow * high, glow * high}, with_alpha(pen.colors.sun, 130));
  pen.shape.clear();
  engine::add_disc(pen.shape, middle, disc * high);
  pen.canvas.mesh(pen.shape, pen.colors.sun);
}

}  // namespace game
