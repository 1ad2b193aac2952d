#include "ribbon/box2d/debug_draw.h"

#include <array>
#include <cstddef>
#include <span>
#include <variant>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling_parts.h"
#include "ribbon/box2d/slot.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/pulley.h"

namespace ribbon::box2d {
namespace {

// Those of b2World::DebugDraw and of Box2D's testbed.
const b2Color awake(0.9F, 0.7F, 0.7F);
const b2Color asleep(0.6F, 0.6F, 0.6F);
const b2Color disabled(0.5F, 0.5F, 0.3F);
const b2Color pinned(0.5F, 0.9F, 0.5F);
const b2Color dragged(0.5F, 0.5F, 0.9F);
const b2Color grip_color(0.5F, 0.8F, 0.8F);
const b2Color box_color(0.9F, 0.3F, 0.9F);
const b2Color contact_color(0.3F, 0.95F, 0.3F);
const b2Color normal_color(0.9F, 0.9F, 0.9F);
constexpr double normal_length = 0.3;  // m

// px
constexpr float free_size = 3.0F;
constexpr float driven_size = 6.0F;
constexpr float grip_size = 4.0F;
constexpr float contact_size = 5.0F;

b2Color color_of(const CoupledCord& cord) {
  if (!cord.enabled) return disabled;
  return cord.is_direct() && cord.direct().is_asleep() ? asleep : awake;
}

/// Draws the links of a row of points, or of a column: every `stride`-th point from `first` to `last`.
void draw_links(std::span<const Vec2> positions, int first, int last, int stride, const b2Color& color, b2Draw& draw) {
  for (int p = first; p < last; p += stride) {
    draw.DrawSegment(to_float(positions[slot(p)]), to_float(positions[slot(p + stride)]), color);
  }
}

void draw_outline(const CoupledCord& cord, const b2Color& color, b2Draw& draw) {
  const auto [columns, rows, thickness, braced] = cord.shape();
  const int last = (columns - 1) * rows;  // the first point of the last column
  draw_links(cord.positions(), 0, last, rows, color, draw);
  if (rows == 1) return;
  draw_links(cord.positions(), rows - 1, last + rows - 1, rows, color, draw);
  draw_links(cord.positions(), 0, rows - 1, 1, color, draw);
  draw_links(cord.positions(), last, last + rows - 1, 1, color, draw);
}

template <typename OfSolver>
void draw_points(const OfSolver& cord, const b2Color& color, b2Draw& draw) {
  for (std::size_t p = 0; p < cord.positions().size(); ++p) {
    const b2Vec2 position = to_float(cord.positions()[p]);
    switch (cord.kind(static_cast<int>(p))) {
      case PointKind::free: draw.DrawPoint(position, free_size, color); break;
      case PointKind::operated: draw.DrawPoint(position, driven_size, dragged); break;
      case PointKind::constrained: draw.DrawPoint(position, driven_size, pinned); break;
    }
  }
}

void draw_wheel(const BodyPulley& pulley, const CoupledCord& cord, b2Draw& draw) {
  const Pulley& of_cord = pulleys_of(cord.direct())[static_cast<std::size_t>(pulley.index)];
  const b2Vec2 center = pulley.body->GetWorldPoint(pulley.local_anchor);
  const b2Vec2 spoke = to_float(of_cord.def.radius * rotation(of_cord.angle));
  draw.DrawCircle(center, static_cast<float>(of_cord.def.radius), grip_color);
  draw.DrawSegment(center, center + spoke, grip_color);
}

void draw_grip(const BodyGrip& grip, const CoupledCord& cord, b2Draw& draw) {
  const b2Vec2 anchor = grip.body->GetWorldPoint(grip.local_anchor);
  const b2Vec2 place = to_float(cord.position(grip.point, grip.along));
  draw.DrawSegment(grip.body->GetPosition(), anchor, grip_color);
  draw.DrawSegment(anchor, place, grip_color);
  draw.DrawPoint(place, grip_size, grip_color);
}

void draw_box(const Box& box, b2Draw& draw) {
  const b2Vec2 low = to_float(box.low);
  const b2Vec2 high = to_float(box.high);
  const std::array<b2Vec2, 4> corners{low, b2Vec2(high.x, low.y), high, b2Vec2(low.x, high.y)};
  draw.DrawPolygon(corners.data(), static_cast<int32>(corners.size()), box_color);
}

void draw_contacts(const Cord& cord, b2Draw& draw) {
  for (const Touch& touch : cord.touches()) {
    const b2Vec2 point = to_float(touch.point);
    draw.DrawPoint(point, contact_size, contact_color);
    draw.DrawSegment(point, to_float(touch.point + normal_length * touch.normal), normal_color);
  }
}

}  // namespace

void debug_draw(const Coupling& coupling, b2Draw& draw) {
  const CouplingParts& parts = *coupling.parts_;
  const uint32 flags = draw.GetFlags();
  for (const CoupledCord& cord : parts.cords) {
    const b2Color color = color_of(cord);
    if ((flags & b2Draw::e_shapeBit) != 0) {
      draw_outline(cord, color, draw);
      std::visit([&](const auto& of_solver) { draw_points(of_solver, color, draw); }, cord.cord);
    }
    if (!cord.enabled) continue;
    const bool was_gathered = !(cord.swept_aabb == Box{});
    if ((flags & b2Draw::e_aabbBit) != 0 && was_gathered) draw_box(cord.swept_aabb, draw);
    if ((flags & b2Draw::e_pairBit) != 0 && cord.is_direct()) draw_contacts(cord.direct(), draw);
  }
  if ((flags & b2Draw::e_jointBit) == 0) return;
  for (const BodyGrip& grip : parts.grips.all()) {
    if (parts.finder.exists(grip.seen)) draw_grip(grip, parts.cords.at(grip.cord), draw);
  }
  for (const BodyPulley& pulley : parts.pulleys.all()) {
    if (parts.finder.exists(pulley.seen)) draw_wheel(pulley, parts.cords.at(pulley.cord), draw);
  }
}

}  // namespace ribbon::box2d
