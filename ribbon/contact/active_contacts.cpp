#include "ribbon/contact/active_contacts.h"

#include <algorithm>

namespace ribbon {
namespace {

constexpr double shallow_fraction = 0.01;  // of the contact distance

}  // namespace

void ActiveContacts::clear() {
  active_.clear();
  is_active_.clear();
  is_current_ = false;
}

void ActiveContacts::begin_substep(ContactScene& scene, std::span<const Vec2> x) {
  active_.reserve(scene.pairs.capacity());
  was_active_.reserve(scene.pairs.capacity());
  compared_.reserve(scene.anchors.capacity());
  find(scene, x);
  was_active_ = is_active_;
}

void ActiveContacts::update(ContactScene& scene, std::span<const Vec2> x) {
  if (!is_found_at(scene.anchors, x)) find(scene, x);
}

bool ActiveContacts::is_found_at(const ContactAnchors& anchors, std::span<const Vec2> x) {
  if (!is_current_) return false;
  anchors.positions(x, KinematicTime::current, compared_);
  return compared_ == positions_;
}

void ActiveContacts::find(ContactScene& scene, std::span<const Vec2> x, std::span<const double> forces, double margin) {
  scene.anchors.positions(x, KinematicTime::current, positions_);
  scene.list_candidates(positions_, positions_);
  is_current_ = margin == 0.0;
  active_.clear();
  assign_by_pair(is_active_, scene.pairs, '\0');
  const auto at = [this](int anchor) { return positions_[static_cast<std::size_t>(anchor)]; };
  for (const std::size_t k : scene.candidates.pairs_to_check()) {
    const PairGeometry& pair = scene.pairs.geometry(k);
    double distance = scene.pairs.active_distance(pair);
    if (margin > 0.0 && forces[k] > 0.0) distance += margin * pair.contact_distance;
    const Vec2 disc = at(pair.disc);
    const Vec2 a = at(pair.a);
    const Vec2 b = at(pair.b);
    if (!may_be_within(distance, disc, a, b)) continue;
    const Separation gap = separation_of(scene.pairs[k], disc, a, b);
    if (!(gap.distance < distance) || !is_local_minimum(scene.pairs[k], gap, positions_)) continue;
    active_.push_back({k, gap});
    is_active_[k] = 1;
  }
}

void ActiveContacts::begin_other(const ContactAnchors& anchors, std::span<const Vec2> x) {
  anchors.positions(x, KinematicTime::current, positions_);
  is_current_ = false;
  active_.clear();
}

bool ActiveContacts::are_shallow(const ContactPairs& pairs) const {
  return std::all_of(active_.begin(), active_.end(), [&pairs](const ActiveContact& contact) {
    return contact.gap.distance > (1.0 - shallow_fraction) * pairs[contact.pair].contact_distance;
  });
}

bool ActiveContacts::are_coupled(const ContactScene& scene, const BlockLdlt& matrix) const {
  return std::all_of(active_.begin(), active_.end(), [&](const ActiveContact& contact) {
    return slots_of(scene.anchors, scene.pairs[contact.pair]).is_coupled(matrix);
  });
}

void ActiveContacts::couple(const ContactScene& scene, BlockLdlt& matrix) const {
  for (const ActiveContact& contact : active_) slots_of(scene.anchors, scene.pairs[contact.pair]).couple(matrix);
}

}  // namespace ribbon
