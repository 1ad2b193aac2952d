#include "ribbon/contact/contacts.h"

namespace ribbon {
namespace {

constexpr double separation_margin = 0.25;  // of the contact distance: further apart, a pair with a force has separated

}  // namespace

void Contacts::clear(std::size_t points) {
  scene.clear(points);
  active.clear();
  impacts.clear();
}

void Contacts::begin_substep(std::span<const Vec2> x, double fraction) {
  scene.begin_substep(fraction);
  slip_reference.set(scene.anchors, x);
  forces.begin_substep(scene.pairs);
  compliant.begin_substep(scene.pairs, forces);
  linearised.begin_substep(scene, forces);
  sweep.reserve(scene.anchors.capacity(), x.size());
  active.begin_substep(scene, x);
  impacts.begin_substep(scene.pairs);
}

bool Contacts::changed_at(std::span<const Vec2> x) {
  active.update(scene, x);
  return active.changed();
}

void Contacts::store(std::span<const Vec2> x) {
  active.update(scene, x);
  store_impacts();
  // The depth does not determine the force of a linearised contact, because its normal and position are fixed.
  std::span<const double> known;
  if (linearised.has_forces()) known = forces.normal;
  CompliantContacts::store(state(x), known, scene.pairs);
}

/// A pair that was hit and is apart now gets the normal and the point of the hit.
void Contacts::store_impacts() {
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const double impulse = impacts.impulse(k);
    const Vec2 push = impacts.push(k);
    if (impulse == 0.0 && push == Vec2{}) continue;
    ContactPair& pair = scene.pairs[k];
    pair.touch.impulse += impulse;
    pair.touch.push += scene.anchors.is_point(pair.disc) ? -push : push;
    pair.touch.normal = impacts.place(k).normal;
    pair.touch.point = impacts.place(k).point;
  }
}

double Contacts::energy() const {
  return linearised.has_forces() ? energy_of_forces() : CompliantContacts::energy(scene.pairs, active);
}

double Contacts::energy_of_forces() const {
  const double sum = forces.energy(scene.pairs);
  return linearised.has_forces() ? sum / linearised.stiffness_ratio() : sum;
}

void Contacts::record_impacts(std::span<const Vec2> x, double duration) {
  const AnchorState anchors = active.state(scene.anchors, x);
  const bool linear = linearised.has_forces();
  for (const ActiveContact& contact : linear ? linearised.all() : active.all()) {
    const auto& [k, gap] = contact;
    const ContactPair& pair = scene.pairs[k];
    const double normal = linear ? forces.normal[k] : pair.stiffness * scene.pairs.depth(k, gap);
    const Impacts::Place place{gap.normal, anchors[pair.disc] - pair.disc_radius * gap.normal};
    if (!linear || normal > 0.0) impacts.record(k, duration * normal, place);
    if (!impacts.records_pushes()) continue;
    const double friction = linear ? forces.friction[k] : CompliantContacts::friction_force(state(x), contact, normal);
    impacts.record_push(k, duration * (normal * gap.normal + friction * gap.tangent), place);
  }
}

void Contacts::find_for_solve(std::span<const Vec2> x, bool strict) {
  if (strict) compliant.forget_predictions();
  active.find(scene, x, forces.normal, strict ? 0.0 : separation_margin);
}

void Contacts::load(std::span<const Vec2> x, BlockLdlt& matrix, std::span<Vec2> force) {
  if (impacts.is_restituting()) {
    impacts.load(scene.pairs, active, active.state(scene.anchors, x), matrix, force);
  } else {
    compliant.load(state(x), forces, matrix, force);
  }
}

void Contacts::take_solution(std::span<const Vec2> step) {
  if (!impacts.is_restituting()) compliant.take_solution(scene.pairs, active, step, forces);
}

double Contacts::potential(std::span<const Vec2> x) {
  active.find(scene, x);
  return CompliantContacts::potential(state(x), forces);
}

bool Contacts::are_settled(std::span<const Vec2> x, double tolerance) {
  active.update(scene, x);
  return CompliantContacts::are_settled(state(x), forces, tolerance);
}

void Contacts::end_restitution(std::span<const Vec2> x, const std::vector<Vec2>* step) {
  if (step != nullptr) impacts.take_restitution(scene.pairs, active, active.state(scene.anchors, x), *step);
  impacts.end_restitution();
  active.find(scene, x);
}

/// Invalidates the active contacts, because the list of candidates is then the one for the path.
void Contacts::set_path(std::span<const Vec2> from, std::span<const Vec2> to) {
  sweep.set_path(scene, from, to);
  active.invalidate();
}

bool Contacts::linearise(std::span<const Vec2> from, std::span<const Vec2> to) {
  set_path(from, to);
  return linearised.find(scene, sweep, forces);
}

bool Contacts::linearise_missed(std::span<const Vec2> from, std::span<const Vec2> to, double tolerance) {
  set_path(from, to);
  return linearised.find_missed(scene, sweep, forces, tolerance);
}

void Contacts::append_rows(std::span<const Vec2> x, double shortening, LimitedRows& rows) {
  linearised.append_rows(scene, slip_reference, forces, x, shortening, rows);
}

void Contacts::take_forces(const LimitedRows& rows, bool updates_limits) {
  linearised.take_forces(scene.pairs, rows, updates_limits, forces);
}

}  // namespace ribbon
