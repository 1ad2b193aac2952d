#include "ribbon/contact/impacts.h"

#include <algorithm>

namespace ribbon {
namespace {

constexpr double min_impact_speed = 0.1;       // m/s
constexpr double min_restitution_speed = 0.5;  // m/s

}  // namespace

void Impacts::clear() {
  is_hit_.clear();
  impulses_.clear();
  pushes_.clear();
}

void Impacts::begin_substep(const ContactPairs& pairs) {
  assign_by_pair(is_hit_, pairs, '\0');
  impulses_.reserve(pairs.capacity());
  impulses_.resize(pairs.size());
  if (!records_pushes_) return;
  pushes_.reserve(pairs.capacity());
  pushes_.resize(pairs.size());
}

void Impacts::record(std::size_t pair, double impulse) {
  is_hit_[pair] = 1;
  impulses_[pair] += impulse;
}

void Impacts::record_push(std::size_t pair, const Push& push) {
  const Vec2 before = pushes_[pair].impulse;
  pushes_[pair] = push;
  pushes_[pair].impulse += before;
}

void Impacts::scale_impulses(double factor) {
  for (double& impulse : impulses_) impulse = factor == 0.0 ? 0.0 : factor * impulse;
  for (Push& push : pushes_) push.impulse = factor == 0.0 ? Vec2{} : factor * push.impulse;
}

bool Impacts::any() const { return std::find(is_hit_.begin(), is_hit_.end(), 1) != is_hit_.end(); }

bool Impacts::touch_kinematic(const ContactScene& scene) const {
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const ContactPair& pair = scene.pairs[k];
    if (is_hit_[k] == 0) continue;
    if (scene.anchors.is_kinematic(pair.disc) || scene.anchors.is_kinematic(pair.a)) return true;
  }
  return false;
}

bool Impacts::find_restitution(const ContactScene& scene, std::span<const Vec2> x, std::span<const Vec2> before,
                               std::span<const Vec2> after, double dt, ActiveContacts& active) {
  active.begin_other(scene.anchors, x);
  separations_.clear();
  separations_.reserve(scene.pairs.capacity());
  const AnchorState state = active.state(scene.anchors, x);
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const ContactPair& pair = scene.pairs[k];
    if (is_hit_[k] == 0) continue;
    const Separation gap = find_separation(state[pair.disc], state[pair.a], state[pair.b]);
    if (!(gap.distance < 2.0 * pair.contact_distance) || !is_local_minimum(pair, gap, state.positions)) continue;
    const SlotRow normal = normal_row(state, pair, gap);
    const double kinematic = kinematic_speed(pair, gap, state);
    const double approach = -(normal.along(before) + kinematic);
    if (approach < min_impact_speed) continue;
    const double e = approach > min_restitution_speed ? pair.restitution : 0.0;
    active.add({k, gap});
    separations_.push_back(dt * (e * approach - normal.along(after) - kinematic));
  }
  return active.any();
}

/// The part of the separation speed that comes from kinematic bodies, m/s.
double Impacts::kinematic_speed(const ContactPair& pair, const Separation& gap, const AnchorState& state) {
  const auto along_normal = [&](int anchor) {
    if (!state.anchors.is_kinematic(anchor)) return 0.0;
    const BodyAnchor& body = state.anchors.body(anchor);
    return dot(gap.normal, body.velocity + body.angular_velocity * perp(state[anchor] - body.body_position));
  };
  return along_normal(pair.disc) - (1.0 - gap.along) * along_normal(pair.a) - gap.along * along_normal(pair.b);
}

void Impacts::load(const ContactPairs& pairs, const ActiveContacts& active, const AnchorState& state, BlockLdlt& matrix,
                   std::span<Vec2> force) const {
  const std::span<const ActiveContact> contacts = active.all();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactPair& pair = pairs[contacts[i].pair];
    const SlotRow normal = normal_row(state, pair, contacts[i].gap);
    normal.push(pair.stiffness * separations_[i], force);
    matrix.add_outer(pair.stiffness, normal.slots(), normal.derivatives());
  }
}

void Impacts::take_restitution(const ContactPairs& pairs, const ActiveContacts& active, const AnchorState& state,
                               std::span<const Vec2> step) {
  if (!records_pushes_) return;
  restitution_.clear();
  restitution_.reserve(pairs.capacity());
  const std::span<const ActiveContact> contacts = active.all();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [k, gap] = contacts[i];
    const double left = separations_[i] - normal_row(state, pairs[k], gap).along(step);
    const Vec2 point = state[pairs[k].disc] - pairs[k].disc_radius * gap.normal;
    restitution_.emplace_back(k, Push{(pairs[k].stiffness * left) * gap.normal, gap.normal, point});
  }
}

void Impacts::record_restitution(double share, double dt) {
  if (!records_pushes_) return;
  for (const auto& [pair, push] : restitution_) {
    record_push(pair, {(share * dt) * push.impulse, push.normal, push.point});
  }
}

}  // namespace ribbon
