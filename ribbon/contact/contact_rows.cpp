// How gaps, and what slides along them, change with everything that moves.

#include <algorithm>
#include <cmath>

#include "ribbon/contact/contacts.h"
#include "ribbon/contact/held_body.h"
#include "ribbon/geometry/rotation.h"

namespace ribbon {

void Contacts::add_place(Row& row, int anchor, Vec2 by, Vec2 lever) const {
  if (at(anchor) < points_) {
    row.add(anchor, by);
  } else if (const int center = spot(anchor).center; center >= 0) {
    row.add(center, by);
    row.add(center + 1, {cross(lever, by), 0.0});
  }
}

/// From the centre of the body to the spot.
Vec2 Contacts::lever(int anchor, std::span<const Vec2> x) const {
  return is_moved_spot(anchor) ? anchors_[at(anchor)] - x[at(spot(anchor).center)] : Vec2{};
}

/// δd.
Contacts::Row Contacts::normal_row(const ContactPair& pair, const Separation& gap, std::span<const Vec2> x) const {
  Row row;
  add_place(row, pair.disc, gap.normal, lever(pair.disc, x));
  add_place(row, pair.a, -(1.0 - gap.along) * gap.normal, lever(pair.a, x));
  add_place(row, pair.b, -gap.along * gap.normal, lever(pair.b, x));
  return row;
}

/// How far one slides along the other, at the cord's axis, for its points cannot take a torque.
Contacts::Row Contacts::tangent_row(const ContactPair& pair, const Separation& gap, std::span<const Vec2> x) const {
  const Vec2 to_axis = pair.reach * gap.normal;
  Row row;
  add_place(row, pair.disc, gap.tangent, lever(pair.disc, x) - to_axis);
  add_place(row, pair.a, -(1.0 - gap.along) * gap.tangent, lever(pair.a, x) + to_axis);
  add_place(row, pair.b, -gap.along * gap.tangent, lever(pair.b, x) + to_axis);
  return row;
}

/// d·E/L − U: −δ²d = ((d·E/L − U)² − U²)/d, of which the first is the part that makes no matrix indefinite.
Contacts::Row Contacts::turning_row(const ContactPair& pair, const Separation& gap, std::span<const Vec2> x) const {
  const Vec2 across = (gap.distance / gap.length) * gap.normal;
  Row row;
  add_place(row, pair.disc, gap.tangent, lever(pair.disc, x));
  add_place(row, pair.a, -across - (1.0 - gap.along) * gap.tangent, lever(pair.a, x));
  add_place(row, pair.b, across - gap.along * gap.tangent, lever(pair.b, x));
  return row;
}

/// Of friction's anchor: how far the disc has slid since the substep began, and what was left from before.
double Contacts::stretch(const Active& active, const Row& tangent, std::span<const Vec2> x) const {
  const ContactPair& pair = pairs_[active.pair];
  double slip = pair.touch.stuck;
  for (int i = 0; i < tangent.size; ++i) {
    const std::size_t slot = at(tangent.slot[at(i)]);
    slip += dot(tangent.by[at(i)], x[slot] - slots_then_[slot]);
  }
  const auto add_led = [&](int anchor, double weight, double radius) {
    if (at(anchor) < points_ || spot(anchor).center >= 0) return;
    const double turned = spot(anchor).turned - turned_then_[at(anchor) - points_];
    slip += weight * (dot(active.gap.tangent, anchors_[at(anchor)] - starts_[at(anchor)]) + radius * turned);
  };
  const double axis = pair.reach * cross(active.gap.tangent, active.gap.normal);
  add_led(pair.disc, 1.0, axis);
  add_led(pair.a, -(1.0 - active.gap.along), -axis);
  add_led(pair.b, -active.gap.along, -axis);
  return slip;
}

Contacts::Row Contacts::slots_of(const ContactPair& pair) const {
  Row row;
  for (const int anchor : {pair.disc, pair.a, pair.b}) add_place(row, anchor, {}, {});
  return row;
}

}  // namespace ribbon
