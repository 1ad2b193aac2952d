#include "game/view/trail.h"

#include <algorithm>
#include <cmath>

#include "game/view/backdrop_parts.h"
#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr double trail_width = 0.62;  // m, at the player
constexpr int wind_lines = 7;
constexpr double wind_reach = 1.5;  // m, to either side of the way

/// Adds lines of wind around the player, which pass it backwards.
void add_wind(Pen& pen, Vec2 at, Vec2 along, double strength) {
  const Vec2 side = perp(along);
  for (int k = 0; k < wind_lines; ++k) {
    const double passing = 2.4 * pen.time + scatter(k, 1, 801);
    const int round = static_cast<int>(std::floor(passing));
    const double t = passing - round;
    const double away = wind_reach * (2.0 * scatter(k, round, 802) - 1.0);
    const Vec2 head = at + (2.2 - 4.4 * t) * along + away * side;
    const Vec2 tail = head - (0.7 + 1.0 * strength) * along;
    const double fade = strength * std::min({1.0, 4.0 * t, 4.0 * (1.0 - t)});
    const Color pale = with_alpha({255, 255, 255}, static_cast<int>(120.0 * fade));
    const Color gone = with_alpha(pale, 0);
    const Vec2 thin = 0.016 * side;
    const auto pixel = [&](Vec2 p) { return pen.canvas.to_pixels(p); };
    add_quad(pen.mesh, {{{pixel(head - thin), pale},
                         {pixel(head + thin), pale},
                         {pixel(tail + thin), gone},
                         {pixel(tail - thin), gone}}});
  }
}

}  // namespace

void Trail::add(Vec2 at) {
  std::copy_backward(way_.begin(), way_.end() - 1, way_.end());
  way_.front() = at;
  count_ = std::min(count_ + 1, max_count);
}

double Trail::strength(double speed) {
  const double t = std::clamp((speed - first_speed) / (full_speed - first_speed), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

void Trail::draw(Pen& pen, Vec2 at, Vec2 velocity) const {
  const double speed = length(velocity);
  const double strength = Trail::strength(speed);
  if (pen.reduced_motion || strength <= 0.0) return;
  pen.mesh.clear();
  Vec2 before = at;
  for (std::size_t k = 0; k < count_; ++k) {
    const Vec2 step = way_[k] - before;
    if (length(step) < 1e-6) continue;
    const double old = static_cast<double>(k) / max_count;
    const double older = static_cast<double>(k + 1) / max_count;
    const Vec2 side = (0.5 * trail_width / length(step)) * perp(step);
    const auto light = [&](double age) {
      return with_alpha(pen.colors.sun, static_cast<int>(130.0 * strength * (1.0 - age)));
    };
    const auto pixel = [&](Vec2 p) { return pen.canvas.to_pixels(p); };
    add_quad(pen.mesh, {{{pixel(before + (1.0 - old) * side), with_alpha(light(old), 0)},
                         {pixel(before), light(old)},
                         {pixel(way_[k]), light(older)},
                         {pixel(way_[k] + (1.0 - older) * side), with_alpha(light(older), 0)}}});
    add_quad(pen.mesh, {{{pixel(before), light(old)},
                         {pixel(before - (1.0 - old) * side), with_alpha(light(old), 0)},
                         {pixel(way_[k] - (1.0 - older) * side), with_alpha(light(older), 0)},
                         {pixel(way_[k]), light(older)}}});
    before = way_[k];
  }
  add_wind(pen, at, (1.0 / speed) * velocity, strength);
  pen.canvas.textured(pen.mesh, {});
}

}  // namespace game
