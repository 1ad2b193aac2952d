#include "game/view/figure.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr Color skin{244, 200, 160};
constexpr Color hair{84, 52, 44};
constexpr Color boots{58, 42, 44};
constexpr Clothes clothes_of_first{.jacket = {58, 128, 168},
                                   .jacket_far = {42, 92, 126},
                                   .scarf = {250, 104, 66},
                                   .scarf_shade = {204, 66, 52},
                                   .trousers = {112, 84, 78},
                                   .trousers_far = {82, 62, 62}};
constexpr Clothes clothes_of_second{.jacket = {246, 202, 92},
                                    .jacket_far = {200, 156, 62},
                                    .scarf = {96, 60, 130},
                                    .scarf_shade = {70, 42, 98},
                                    .trousers = {112, 84, 78},
                                    .trousers_far = {82, 62, 62}};
constexpr double figure_outline = 0.055;  // m, half of it on each side
constexpr double head_radius = 0.19;

struct DrawnLimb {
  std::array<Vec2, 3> joints;
  double width;  // m
  Color color;
};

/// Returns the limbs from far to near.
std::vector<DrawnLimb> limbs_of(const Pose& pose, const Clothes& clothes) {
  const Vec2 chest = 0.5 * (pose.hip + pose.neck);
  const auto boot = [&pose](std::size_t k) {
    return DrawnLimb{
        {pose.foot[k], pose.foot[k] + Vec2{0.06 * pose.side, -0.005}, pose.foot[k] + Vec2{0.12 * pose.side, -0.01}},
        0.13,
        boots};
  };
  return {{{pose.shoulder[0], pose.elbow[0], pose.hand[0]}, 0.115, clothes.jacket_far},
          {{pose.hip, pose.knee[0], pose.foot[0]}, 0.15, clothes.trousers_far},
          boot(0),
          {{pose.hip, pose.knee[1], pose.foot[1]}, 0.16, clothes.trousers},
          boot(1),
          {{pose.hip, chest, pose.neck - Vec2{0.0, 0.06}}, 0.32, clothes.jacket},
          {{pose.shoulder[1], pose.elbow[1], pose.hand[1]}, 0.12, clothes.jacket}};
}

void add_limb(Pen& pen, std::span<const Vec2> joints, double width) {
  std::vector<Vec2> pixels;
  for (const Vec2 p : joints) pixels.push_back(pen.canvas.to_pixels(p));
  engine::add_polyline(pen.shape, pixels, width * pen.scale());
}

void add_ball(Pen& pen, Vec2 center, double radius) {
  engine::add_disc(pen.shape, pen.canvas.to_pixels(center), radius * pen.scale());
}

/// Sets pen.shape to the whole figure, wider by `wider` m.
void add_silhouette(Pen& pen, const Pose& pose, const std::vector<DrawnLimb>& limbs, double wider) {
  pen.shape.clear();
  for (const DrawnLimb& limb : limbs) add_limb(pen, limb.joints, limb.width + wider);
  for (const Vec2 hand : pose.hand) add_ball(pen, hand, 0.065 + 0.5 * wider);
  add_ball(pen, pose.head, head_radius + 0.5 * wider);
  add_limb(pen, pose.scarf, 0.075 + wider);
}

void draw_head(Pen& pen, const Pose& pose) {
  engine::Canvas& canvas = pen.canvas;
  const double side = pose.side;
  canvas.circle(pose.head, head_radius, hair);
  canvas.circle(pose.head + Vec2{0.045 * side, -0.03}, 0.145, skin);
  canvas.circle(pose.head + Vec2{-0.03 * side, 0.09}, 0.115, hair);
  canvas.circle(pose.head + Vec2{0.10 * side, 0.10}, 0.07, hair);
  canvas.circle(pose.head + Vec2{0.115 * side, 0.0}, 0.028, pen.colors.ink);
  canvas.circle(pose.head + Vec2{0.04 * side, -0.005}, 0.026, pen.colors.ink);
  canvas.circle(pose.head + Vec2{0.065 * side, -0.075}, 0.03, {236, 150, 128});
}

void draw_scarf(Pen& pen, const Pose& pose, const Clothes& clothes) {
  pen.canvas.polyline(pose.scarf, 0.085, clothes.scarf_shade);
  pen.canvas.polyline(pose.scarf, 0.05, clothes.scarf);
}

}  // namespace

const Clothes& clothes_of(int player) { return player == 0 ? clothes_of_first : clothes_of_second; }

void draw_figure(Pen& pen, const Pose& pose, const Clothes& clothes) {
  const std::vector<DrawnLimb> limbs = limbs_of(pose, clothes);
  add_silhouette(pen, pose, limbs, figure_outline);
  pen.canvas.mesh(pen.shape, pen.colors.figure_rim);
  draw_scarf(pen, pose, clothes);
  for (std::size_t k = 0; k < limbs.size(); ++k) {
    pen.canvas.polyline(limbs[k].joints, limbs[k].width, limbs[k].color);
    if (k == 0) pen.canvas.circle(pose.hand[0], 0.065, mix(skin, pen.colors.ink, 0.15));
    if (k == 5) {  // after the chest
      const Vec2 collar = pose.neck - Vec2{0.0, 0.02};
      pen.canvas.polyline(std::array{collar - Vec2{0.09, 0.0}, collar + Vec2{0.09, 0.0}}, 0.12, clothes.scarf);
      draw_head(pen, pose);
    }
  }
  pen.canvas.circle(pose.hand[1], 0.065, skin);
}

GhostColors ghost_colors(const Palette& colors) {
  return {with_alpha(colors.ink, 180), with_alpha(mix(colors.sky_middle, {255, 255, 255}, 0.7), 165)};
}

void draw_ghost(Pen& pen, const Pose& pose) {
  const GhostColors colors = ghost_colors(pen.colors);
  const std::vector<DrawnLimb> limbs = limbs_of(pose, clothes_of(0));
  add_silhouette(pen, pose, limbs, figure_outline);
  pen.canvas.mesh(pen.shape, colors.outline);
  add_silhouette(pen, pose, limbs, -0.02);
  pen.canvas.mesh(pen.shape, colors.body);
}

}  // namespace game
