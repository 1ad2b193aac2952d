#include "ribbon/contact/linearised_contacts.h"

#include <algorithm>
#include <limits>

namespace ribbon {
namespace {

constexpr double linearising_margin = 0.25;  // of the contact distance, within which a pair is linearised
constexpr double missed_of_start = 0.995;    // of the distance at the start, that a pair may come nearer to

}  // namespace

void LinearisedContacts::begin_substep(const ContactScene& scene, const ContactForces& forces) {
  const std::size_t pairs = scene.pairs.capacity();
  has_forces_ = false;
  for (auto* contacts : {&contacts_, &previous_, &stored_}) contacts->reserve(pairs);
  stored_forces_.reserve(pairs);
  limiting_forces_.reserve(pairs);
  limiting_forces_ = forces.normal;
  positions_.reserve(scene.anchors.capacity());
}

void LinearisedContacts::clear() {
  contacts_.clear();
  has_forces_ = false;
}

bool LinearisedContacts::find(ContactScene& scene, const ContactSweep& sweep, const ContactForces& forces) {
  previous_.swap(contacts_);
  contacts_.clear();
  positions_.resize(scene.anchors.size());
  for (const std::size_t k : scene.candidates.pairs_to_check()) find_pair(scene, sweep, k);
  // Without it the next solve would go through a pair with a force, which would then be linearised, and so on.
  keep_previous([&forces](std::size_t pair) { return forces.normal[pair] > 0.0; });
  return !std::equal(contacts_.begin(), contacts_.end(), previous_.begin(), previous_.end(),
                     [](const ActiveContact& a, const ActiveContact& b) { return a.pair == b.pair; });
}

void LinearisedContacts::find_pair(const ContactScene& scene, const ContactSweep& sweep, std::size_t k) {
  const PairGeometry& geometry = scene.pairs.geometry(k);
  const ContactPair& pair = scene.pairs[k];
  const double near = (1.0 + linearising_margin) * pair.contact_distance;
  double fraction = 1.0;
  if (sweep.free_fraction(geometry, Clearance::passing(), 1.0) < 1.0) {
    fraction = sweep.free_fraction(geometry, Clearance::collision_free(), 1.0);
  }
  if (fraction == 1.0 && !sweep.may_end_within(geometry, near)) return;
  const Separation gap = sweep.gap_at(pair, fraction, positions_);
  if (fraction == 1.0 && !(gap.distance < near)) return;
  if (is_local_minimum(pair, gap, positions_)) contacts_.push_back({k, gap});
}

bool LinearisedContacts::find_missed(ContactScene& scene, const ContactSweep& sweep, const ContactForces& forces,
                                     double tolerance) {
  previous_.swap(contacts_);
  contacts_.clear();
  positions_.resize(scene.anchors.size());
  for (const std::size_t k : scene.candidates.pairs_to_check()) {
    const PairGeometry& geometry = scene.pairs.geometry(k);
    const ContactPair& pair = scene.pairs[k];
    if (sweep.free_fraction(geometry, {geometry.overlap_fraction, missed_of_start}, 1.0) < 1.0) {
      const double fraction = sweep.free_fraction(geometry, Clearance::collision_free(), 1.0);
      contacts_.push_back({k, sweep.gap_at(pair, fraction, positions_)});
      continue;
    }
    if (!sweep.may_end_within(geometry, pair.contact_distance)) continue;
    const Separation gap = sweep.gap_at(pair, 1.0, positions_);
    const double explained = forces.normal[k] / (stiffness_ratio_ * pair.stiffness);
    const bool is_deep = scene.pairs.depth(k, gap) > explained + tolerance;
    if (is_deep && is_local_minimum(pair, gap, positions_)) contacts_.push_back({k, gap});
  }
  const bool any = !contacts_.empty();
  keep_previous([](std::size_t) { return true; });
  return any;
}

/// Adds the previous contacts of the pairs that meet the condition and are not linearised now.
template <typename Condition>
void LinearisedContacts::keep_previous(Condition&& is_kept) {
  const auto count = static_cast<std::ptrdiff_t>(contacts_.size());
  const auto is_before = [](const ActiveContact& a, const ActiveContact& b) { return a.pair < b.pair; };
  for (const ActiveContact& previous : previous_) {
    if (!is_kept(previous.pair)) continue;
    if (std::binary_search(contacts_.begin(), contacts_.begin() + count, previous, is_before)) continue;
    contacts_.push_back(previous);
  }
  std::sort(contacts_.begin(), contacts_.end(), is_before);
}

/// N.
double LinearisedContacts::friction_limit(const ContactPairs& pairs, std::size_t pair) const {
  return pairs[pair].friction * limiting_forces_[pair];
}

void LinearisedContacts::append_rows(const ContactScene& scene, const SlipReference& reference,
                                     const ContactForces& forces, std::span<const Vec2> x, double shortening,
                                     LimitedRows& rows) {
  stiffness_ratio_ = shortening * shortening;
  scene.anchors.positions(x, KinematicTime::current, positions_);
  const AnchorState state{scene.anchors, positions_, x};
  for (const ActiveContact& contact : contacts_) {
    const ContactPair& pair = scene.pairs[contact.pair];
    const Separation& gap = contact.gap;
    const double stiffness = stiffness_ratio_ * pair.stiffness;
    const Vec2 nearest = state[pair.a] + gap.along * (state[pair.b] - state[pair.a]);
    const double separation =
        dot(gap.normal, state[pair.disc] - nearest) - scene.pairs.active_distance(scene.pairs.geometry(contact.pair));
    rows.add({normal_row(state, pair, gap), separation, 1.0 / stiffness, 0.0, std::numeric_limits<double>::infinity(),
              forces.normal[contact.pair]});
    const double limit = friction_limit(scene.pairs, contact.pair);
    if (!(limit > 0.0)) continue;
    const SlotRow tangent = tangent_row(state, pair, gap);
    const double slip = reference.elongation(state, pair, gap, tangent);
    rows.add({tangent, slip, 1.0 / (ContactPair::friction_stiffness_ratio * stiffness), -limit, limit,
              forces.friction[contact.pair]});
  }
}

void LinearisedContacts::take_forces(const ContactPairs& pairs, const LimitedRows& rows, bool updates_limits,
                                     ContactForces& forces) {
  std::fill(forces.unlimited_normal.begin(), forces.unlimited_normal.end(), 0.0);
  has_forces_ = true;
  std::size_t row = 0;
  for (const ActiveContact& contact : contacts_) {
    const std::size_t k = contact.pair;
    const double limit = friction_limit(pairs, k);
    const double force = rows.rows()[row++].force;
    forces.normal[k] = forces.unlimited_normal[k] = force;
    forces.friction[k] = limit > 0.0 ? rows.rows()[row++].force : 0.0;
    if (updates_limits) limiting_forces_[k] = force;
  }
}

void LinearisedContacts::forget_forces(ContactForces& forces) {
  for (auto* values : {&forces.normal, &forces.unlimited_normal, &forces.friction}) {
    std::fill(values->begin(), values->end(), 0.0);
  }
  has_forces_ = true;
}

void LinearisedContacts::store(const ContactForces& forces) {
  stored_ = contacts_;
  stored_forces_ = forces;
}

void LinearisedContacts::restore(ContactForces& forces) {
  contacts_ = stored_;
  forces = stored_forces_;
}

}  // namespace ribbon
