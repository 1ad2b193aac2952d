#include "ribbon/contact/contact_rows.h"

#include "ribbon/linear/reserve_more.h"

namespace ribbon {

SlotRow normal_row(const AnchorState& state, const ContactPair& pair, const Separation& gap) {
  SlotRow row;
  state.add_derivative(row, pair.disc, gap.normal, state.lever(pair.disc));
  state.add_derivative(row, pair.a, -(1.0 - gap.along) * gap.normal, state.lever(pair.a));
  state.add_derivative(row, pair.b, -gap.along * gap.normal, state.lever(pair.b));
  return row;
}

SlotRow tangent_row(const AnchorState& state, const ContactPair& pair, const Separation& gap) {
  const Vec2 to_axis = pair.contact_distance * gap.normal;
  SlotRow row;
  state.add_derivative(row, pair.disc, gap.tangent, state.lever(pair.disc) - to_axis);
  state.add_derivative(row, pair.a, -(1.0 - gap.along) * gap.tangent, state.lever(pair.a) + to_axis);
  state.add_derivative(row, pair.b, -gap.along * gap.tangent, state.lever(pair.b) + to_axis);
  return row;
}

SlotRow rotation_row(const AnchorState& state, const ContactPair& pair, const Separation& gap) {
  const Vec2 across = (gap.distance / gap.length) * gap.normal;
  SlotRow row;
  state.add_derivative(row, pair.disc, gap.tangent, state.lever(pair.disc));
  state.add_derivative(row, pair.a, -across - (1.0 - gap.along) * gap.tangent, state.lever(pair.a));
  state.add_derivative(row, pair.b, across - gap.along * gap.tangent, state.lever(pair.b));
  return row;
}

SlotRow slots_of(const ContactAnchors& anchors, const ContactPair& pair) {
  const AnchorState state{anchors, {}, {}};
  SlotRow row;
  for (const int anchor : {pair.disc, pair.a, pair.b}) state.add_derivative(row, anchor, {}, {});
  return row;
}

void SlipReference::set(const ContactAnchors& anchors, std::span<const Vec2> x) {
  anchors.positions(x, KinematicTime::current, positions_);
  reserve_more(slots_, x.size());
  slots_.assign(x.begin(), x.end());
  time_ = anchors.time();
  const std::span<const BodyAnchor> bodies = anchors.bodies();
  angles_.reserve(anchors.body_capacity());
  angles_.resize(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) angles_[k] = bodies[k].angle;
}

double SlipReference::elongation(const AnchorState& state, const ContactPair& pair, const Separation& gap,
                                 const SlotRow& tangent) const {
  double slip = pair.touch.stuck;
  for (std::size_t i = 0; i < tangent.slots().size(); ++i) {
    const auto slot = static_cast<std::size_t>(tangent.slot[i]);
    slip += dot(tangent.by[i], state.x[slot] - slots_[slot]);
  }
  const auto add_kinematic = [&](int anchor, double weight, double radius) {
    if (!state.anchors.is_kinematic(anchor)) return;
    const double turned = state.anchors.body(anchor).angle - angles_[state.anchors.body_index(anchor)];
    const Vec2 moved = state[anchor] - positions_[static_cast<std::size_t>(anchor)];
    slip += weight * (dot(gap.tangent, moved) + radius * turned);
  };
  const double axis = pair.contact_distance * cross(gap.tangent, gap.normal);
  add_kinematic(pair.disc, 1.0, axis);
  add_kinematic(pair.a, -(1.0 - gap.along), -axis);
  add_kinematic(pair.b, -gap.along, -axis);
  if (pair.tangent_speed == 0.0) return slip;
  return slip + pair.tangent_speed * (state.anchors.time() - time_) * cross(gap.normal, gap.tangent);
}

}  // namespace ribbon
