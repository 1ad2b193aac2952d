#include "ribbon/contact/compliant_contacts.h"

#include <algorithm>
#include <cmath>

namespace ribbon {
namespace {

constexpr double settled_fraction = 1e-3;   // of all forces
constexpr double settled_depth = 1e-10;     // m, the rounding error of a distance
constexpr double sticking_fraction = 0.99;  // of its limit: below this a friction spring starts a substep sticking
constexpr int max_slip_reversals = 3;       // of a contact in a stage, before its slip is damped

}  // namespace

void ContactForces::reserve(std::size_t pairs) {
  for (auto* values : {&normal, &unlimited_normal, &friction}) values->reserve(pairs);
}

void ContactForces::begin_substep(const ContactPairs& pairs) {
  assign_by_pair(normal, pairs, 0.0);
  assign_by_pair(unlimited_normal, pairs, 0.0);
  assign_by_pair(friction, pairs, 0.0);
  for (const std::size_t k : pairs.pressed()) normal[k] = pairs[k].touch.force;
}

double ContactForces::energy(const ContactPairs& pairs) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (normal[k] != 0.0) sum += 0.5 * normal[k] * normal[k] / pairs[k].stiffness;
  }
  return sum;
}

void CompliantContacts::begin_substep(const ContactPairs& pairs, const ContactForces& forces) {
  normal_rows_.reserve(pairs.capacity());
  frictions_.reserve(pairs.capacity());
  assign_by_pair(is_sticking_, pairs, '\0');
  for (const std::size_t k : pairs.pressed()) {
    const double force = pairs[k].friction_stiffness() * std::abs(pairs[k].touch.stuck);
    is_sticking_[k] = force < sticking_fraction * pairs[k].friction * forces.normal[k] ? 1 : 0;
  }
}

void CompliantContacts::begin_stage(const ContactPairs& pairs) {
  assign_by_pair(slip_forces_, pairs, 0.0);
  assign_by_pair(slip_reversals_, pairs, 0);
}

void CompliantContacts::forget_predictions() {
  std::fill(is_sticking_.begin(), is_sticking_.end(), 0);
  std::fill(slip_forces_.begin(), slip_forces_.end(), 0.0);
}

void CompliantContacts::load(const ContactState& state, const ContactForces& forces, BlockLdlt& matrix,
                             std::span<Vec2> force) {
  normal_rows_.clear();
  frictions_.clear();
  for (const ActiveContact& contact : state.active.all()) {
    const ContactPair& pair = state.scene.pairs[contact.pair];
    const double predicted = forces.normal[contact.pair];
    load_normal(state, contact, predicted, matrix, force);
    frictions_.emplace_back();
    if (pair.friction * predicted == 0.0) continue;
    Friction& slip = frictions_.back();
    slip = friction(state, contact, pair.friction * predicted);
    slip.tangent.push(slip.force, force);
    if (slip.stiffness > 0.0) matrix.add_outer(slip.stiffness, slip.tangent.slots(), slip.tangent.derivatives());
  }
}

/// With f the normal force, n its direction, and U, d as in rotation_row:
///
///     force      −∇(½·k·depth²) = k·depth·∇d
///     Hessian    k·∇d·∇dᵀ + f·(rotation_row)²/d + max(0, f·n·lever), the last at the angle of the disc's body
///
/// −δ²d is 0 for a segment that cannot turn. Its positive part would slow down what slides along the segment, as long
/// as it is not iterated away.
void CompliantContacts::load_normal(const ContactState& state, const ActiveContact& contact, double predicted,
                                    BlockLdlt& matrix, std::span<Vec2> force) {
  const ContactPair& pair = state.scene.pairs[contact.pair];
  const Separation& gap = contact.gap;
  const AnchorState anchors = state.anchors();
  const SlotRow& normal = normal_rows_.emplace_back(normal_row(anchors, pair, gap));
  normal.push(pair.stiffness * state.scene.pairs.depth(contact.pair, gap), force);
  matrix.add_outer(pair.stiffness, normal.slots(), normal.derivatives());
  const bool turns = !(anchors.anchors.is_kinematic(pair.a) && anchors.anchors.is_kinematic(pair.b));
  if (turns && gap.is_interior() && gap.distance > 0.0) {
    const SlotRow rotation = rotation_row(anchors, pair, gap);
    matrix.add_outer(predicted / gap.distance, rotation.slots(), rotation.derivatives());
  }
  if (anchors.anchors.is_dynamic(pair.disc)) {
    const double stiffness = predicted * dot(gap.normal, anchors.lever(pair.disc));
    if (stiffness > 0.0) matrix.add(anchors.anchors.body(pair.disc).center + 1, stiffness, 0.0, 0.0);
  }
}

/// Full steps from slip in one direction to slip in the other, and back, would never end where the solution sticks. So
/// a contact whose slip reverses is taken to stick, and sticks as long as the solve says so. One that reverses too
/// often is damped: its force changes by the secant, which takes more steps to the solution.
CompliantContacts::Friction CompliantContacts::friction(const ContactState& state, const ActiveContact& contact,
                                                        double max_force) {
  const ContactPair& pair = state.scene.pairs[contact.pair];
  const std::size_t k = contact.pair;
  const AnchorState anchors = state.anchors();
  Friction friction;
  friction.tangent = tangent_row(anchors, pair, contact.gap);
  const double stiffness = pair.friction_stiffness();
  const double force = -stiffness * state.reference.elongation(anchors, pair, contact.gap, friction.tangent);
  const bool reverses = slip_forces_[k] * force < 0.0;
  if (reverses) ++slip_reversals_[k];
  const bool damped = slip_reversals_[k] > max_slip_reversals;
  friction.sticks = std::abs(force) <= max_force || (!damped && (reverses || is_sticking_[k] != 0));
  friction.force = friction.sticks ? force : std::clamp(force, -max_force, max_force);
  if (friction.sticks) {
    friction.stiffness = stiffness;
  } else if (damped) {
    friction.stiffness = stiffness * max_force / std::abs(force);
  }
  return friction;
}

void CompliantContacts::take_solution(const ContactPairs& pairs, const ActiveContacts& active,
                                      std::span<const Vec2> step, ContactForces& forces) {
  std::fill(forces.unlimited_normal.begin(), forces.unlimited_normal.end(), 0.0);
  std::fill(forces.normal.begin(), forces.normal.end(), 0.0);
  std::fill(is_sticking_.begin(), is_sticking_.end(), 0);
  std::fill(slip_forces_.begin(), slip_forces_.end(), 0.0);
  const std::span<const ActiveContact> contacts = active.all();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t k = contacts[i].pair;
    const ContactPair& pair = pairs[k];
    const double depth = pairs.depth(k, contacts[i].gap) - normal_rows_[i].along(step);
    const Friction& friction = frictions_[i];
    forces.unlimited_normal[k] = pair.stiffness * depth;
    forces.normal[k] = std::max(0.0, forces.unlimited_normal[k]);
    forces.friction[k] = friction.force - friction.stiffness * friction.tangent.along(step);
    const bool is_within_limit = std::abs(forces.friction[k]) <= pair.friction * forces.normal[k];
    is_sticking_[k] = friction.sticks && is_within_limit ? 1 : 0;
    slip_forces_[k] = friction.sticks ? 0.0 : friction.force;
  }
}

/// ½·k·depth², and with s the elongation of the friction spring, k_t its stiffness and S its limit
///
///     ½·k_t·s²   if k_t·s ≤ S,   else   S·(s − ½·S/k_t).
double CompliantContacts::potential(const ContactState& state, const ContactForces& forces) {
  double sum = 0.0;
  const AnchorState anchors = state.anchors();
  for (const ActiveContact& contact : state.active.all()) {
    const ContactPair& pair = state.scene.pairs[contact.pair];
    const double depth = state.scene.pairs.depth(contact.pair, contact.gap);
    sum += 0.5 * pair.stiffness * depth * depth;
    const double limit = pair.friction * forces.normal[contact.pair];
    if (limit == 0.0) continue;
    const double stiffness = pair.friction_stiffness();
    const SlotRow tangent = tangent_row(anchors, pair, contact.gap);
    const double s = std::abs(state.reference.elongation(anchors, pair, contact.gap, tangent));
    sum += stiffness * s <= limit ? 0.5 * stiffness * s * s : limit * (s - 0.5 * limit / stiffness);
  }
  return sum;
}

double CompliantContacts::energy(const ContactPairs& pairs, const ActiveContacts& active) {
  double sum = 0.0;
  for (const ActiveContact& contact : active.all()) {
    const double depth = pairs.depth(contact.pair, contact.gap);
    sum += 0.5 * pairs[contact.pair].stiffness * depth * depth;
  }
  return sum;
}

double CompliantContacts::friction_force(const ContactState& state, const ActiveContact& contact, double normal) {
  const ContactPair& pair = state.scene.pairs[contact.pair];
  const AnchorState anchors = state.anchors();
  const double limit = pair.friction * normal;
  const SlotRow tangent = tangent_row(anchors, pair, contact.gap);
  const double elongation = state.reference.elongation(anchors, pair, contact.gap, tangent);
  return std::clamp(-pair.friction_stiffness() * elongation, -limit, limit);
}

bool CompliantContacts::are_settled(const ContactState& state, const ContactForces& forces, double tolerance) {
  double sum = 0.0;
  double max_error = 0.0;
  double max_displacement = 0.0;
  const auto add_error = [&](const ContactPair& pair, double error) {
    max_error = std::max(max_error, std::abs(error));
    max_displacement = std::max(max_displacement, std::abs(error) / pair.stiffness);
  };
  const ContactPairs& pairs = state.scene.pairs;
  for (const std::size_t k : state.scene.candidates.pairs()) {
    if (!state.active.is_active(k)) add_error(pairs[k], forces.unlimited_normal[k]);
  }
  for (const ActiveContact& contact : state.active.all()) {
    const ContactPair& pair = pairs[contact.pair];
    const double normal = pair.stiffness * pairs.depth(contact.pair, contact.gap);
    sum += normal + settled_depth * pair.stiffness / settled_fraction;
    add_error(pair, normal - forces.normal[contact.pair]);
    if (pair.friction == 0.0) continue;
    const double friction = friction_force(state, contact, normal);
    add_error(pair, friction - forces.friction[contact.pair]);
  }
  return max_error <= settled_fraction * sum || max_displacement <= tolerance / soft_stiffness_factor;
}

void CompliantContacts::store(const ContactState& state, std::span<const double> normal_forces, ContactPairs& pairs) {
  for (const std::size_t k : pairs.pressed()) {
    pairs[k].touch.force = 0.0;
    if (!state.active.is_active(k)) pairs[k].touch.stuck = 0.0;
  }
  pairs.clear_pressed();
  const AnchorState anchors = state.anchors();
  for (const ActiveContact& contact : state.active.all()) {
    ContactPair& pair = pairs[contact.pair];
    Touch& touch = pair.touch;
    const SlotRow tangent = tangent_row(anchors, pair, contact.gap);
    const double elongation = state.reference.elongation(anchors, pair, contact.gap, tangent);
    pairs.add_pressed(contact.pair);
    touch.force =
        normal_forces.empty() ? pair.stiffness * pairs.depth(contact.pair, contact.gap) : normal_forces[contact.pair];
    const double limit = pair.friction * touch.force / pair.friction_stiffness();
    touch.stuck = std::clamp(elongation, -limit, limit);
    touch.normal = contact.gap.normal;
    touch.point = anchors[pair.disc] - pair.disc_radius * contact.gap.normal;
  }
}

}  // namespace ribbon
