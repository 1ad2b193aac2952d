#include "ribbon/contact/impacts.h"

#include <algorithm>

namespace ribbon {
namespace {

constexpr double min_impact_speed = 0.1;       // m/s
constexpr double min_restitution_speed = 0.5;  // m/s

}  // namespace

void Impacts::clear() {
  for (auto* values : {&impulses_, &start_impulses_}) values->clear();
  for (auto* values : {&pushes_, &start_pushes_}) values->clear();
  places_.clear();
}

void Impacts::begin_substep(const ContactPairs& pairs) {
  const auto begin = [&pairs](auto& values, auto& start) {
    values.reserve(pairs.capacity());
    values.resize(pairs.size());
    start.reserve(pairs.capacity());
    start = values;
  };
  begin(impulses_, start_impulses_);
  places_.reserve(pairs.capacity());
  places_.resize(pairs.size());
  if (records_pushes_) begin(pushes_, start_pushes_);
}

void Impacts::return_to_start() {
  impulses_ = start_impulses_;
  if (records_pushes_) pushes_ = start_pushes_;
}

void Impacts::record(std::size_t pair, double impulse, const Place& place) {
  impulses_[pair] += impulse;
  places_[pair] = place;
}

void Impacts::record_push(std::size_t pair, Vec2 push, const Place& place) {
  pushes_[pair] += push;
  places_[pair] = place;
}

void Impacts::scale_impulses(double factor) {
  for (double& impulse : impulses_) impulse = factor == 0.0 ? 0.0 : factor * impulse;
  for (Vec2& push : pushes_) push = factor == 0.0 ? Vec2{} : factor * push;
}

bool Impacts::any() const {
  return std::any_of(impulses_.begin(), impulses_.end(), [](double impulse) { return impulse > 0.0; });
}

bool Impacts::touch_kinematic(const ContactScene& scene) const {
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const ContactPair& pair = scene.pairs[k];
    if (!is_hit(k)) continue;
    if (scene.anchors.is_kinematic(pair.disc) || scene.anchors.is_kinematic(pair.a)) return true;
  }
  return false;
}

bool Impacts::touch_belt(const ContactScene& scene) const {
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    if (is_hit(k) && scene.pairs[k].tangent_speed != 0.0) return true;
  }
  return false;
}

bool Impacts::touch_moving(const ContactScene& scene, Vec2 frame) const {
  const auto drives = [&](int anchor) {
    if (!scene.anchors.is_kinematic(anchor)) return false;
    const BodyAnchor& body = scene.anchors.body(anchor);
    return !is_at_rest(body.velocity, frame) || body.angular_velocity != 0.0;
  };
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const ContactPair& pair = scene.pairs[k];
    if (is_hit(k) && (drives(pair.disc) || drives(pair.a))) return true;
  }
  return false;
}

/// A push moves a body but gives it no velocity. In the substep it had one, u, and so has what it took along. Without u
/// the pair opens faster than it should, and the impulse that closes it again gives the body back what it has lost.
bool Impacts::find_restitution(const ContactScene& scene, std::span<const Vec2> x, const ImpactVelocities& velocities,
                               double dt, ActiveContacts& active) {
  active.begin_other(scene.anchors, x);
  separations_.clear();
  separations_.reserve(scene.pairs.capacity());
  const AnchorState state = active.state(scene.anchors, x);
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const ContactPair& pair = scene.pairs[k];
    if (!is_hit(k)) continue;
    const Separation gap = separation_of(pair, state[pair.disc], state[pair.a], state[pair.b]);
    if (!(gap.distance < 2.0 * pair.contact_distance) || !is_local_minimum(pair, gap, state.positions)) continue;
    const SlotRow normal = normal_row(state, pair, gap);
    const double kinematic = kinematic_speed(pair, gap, state);
    const double push = velocities.pushes.empty() ? 0.0 : normal.along(velocities.pushes);
    const double approach = -(normal.along(velocities.before) - push + kinematic);
    const double after = normal.along(velocities.after);
    const bool is_thrown_apart = push < 0.0 && after - push + kinematic > std::max(0.0, -approach);
    if (approach < min_impact_speed && !is_thrown_apart) continue;
    const double wanted = approach > min_restitution_speed ? pair.restitution * approach : std::max(0.0, -approach);
    active.add({k, gap});
    separations_.push_back(dt * (wanted - after - kinematic + push));
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
    restitution_.push_back({k, (pairs[k].stiffness * left) * gap.normal, {gap.normal, point}});
  }
}

void Impacts::record_restitution(double share, double dt) {
  if (!records_pushes_) return;
  for (const Push& push : restitution_) record_push(push.pair, (share * dt) * push.force, push.place);
}

}  // namespace ribbon
