#include "game/view/wheels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace game {
namespace {

using ribbon::Vec2;

constexpr int spokes = 5;
constexpr double min_hub = 0.05;  // m

void draw_wheel(Pen& pen, const Snapshot::Wheel& wheel) {
  const double radius = wheel.radius;
  const double rim = 0.22 * radius;
  const double hub = std::max(0.2 * radius, min_hub);
  pen.canvas.circle(wheel.center, radius + 0.02, pen.colors.ink);
  pen.disc(pen.images.wood, wheel.center, radius, mix(pen.colors.wood, {255, 255, 255}, 0.15), wheel.angle);
  pen.canvas.circle(wheel.center, radius - rim, mix(pen.colors.wood, pen.colors.ink, 0.72));
  for (int k = 0; k < spokes; ++k) {
    const double angle = wheel.angle + 2.0 * std::numbers::pi * k / spokes;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    const std::array spoke = {wheel.center + 0.5 * hub * out, wheel.center + (radius - 0.5 * rim) * out};
    pen.canvas.polyline(spoke, 0.16 * radius, mix(pen.colors.wood, {255, 255, 255}, 0.1));
  }
  pen.canvas.circle(wheel.center, hub + 0.02, pen.colors.ink);
  pen.disc(pen.images.iron, wheel.center, hub, pen.colors.iron);
  pen.disc(pen.images.shade, wheel.center, radius, {255, 255, 255});
}

}  // namespace

void draw_wheels(Pen& pen, std::span<const Snapshot::Wheel> wheels) {
  for (const Snapshot::Wheel& wheel : wheels) {
    if (wheel.radius > 0.0 && pen.sees(wheel.center, wheel.radius)) draw_wheel(pen, wheel);
  }
}

}  // namespace game
