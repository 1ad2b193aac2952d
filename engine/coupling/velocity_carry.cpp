#include "ribbon/box2d/velocity_carry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/near_finder.h"

namespace ribbon::box2d {
namespace {

constexpr double single_roundings = 8.0;      // multiples of the rounding error within which positions are equal
constexpr double min_contact_delta_v = 1e-5;  // m/s, and as a share of the velocity: below, it is a rounding error
constexpr double max_impact_share = 0.5;      // of a push that goes into the velocity; above, the push is an impact
constexpr double max_acceleration = 1e19;     // m/s², of a body in a step of the solver
// Displacements by Box2D that cords are to feel, m and rad: smaller ones are the slop of its solver, and larger ones
// are no pushes.
constexpr double least_push = 5e-3;
constexpr double least_turn = 15e-3;
constexpr double most_push = 0.2;
constexpr double most_turn = 0.5;

/// Box2D divides a velocity by this in each tick.
double damping_divisor(float damping, double dt) { return 1.0 + dt * static_cast<double>(damping); }

/// Returns 0 for a vector beyond the limit, because the next step would refuse the body.
Vec2 bounded(Vec2 v, double limit) { return std::abs(v.x) <= limit && std::abs(v.y) <= limit ? v : Vec2{}; }

/// Removes the components of v along the normals of the body's touching contacts.
Vec2 without_normal_components(const b2Body& body, Vec2 v) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (!edge->contact->IsTouching() || edge->contact->GetManifold()->pointCount == 0) continue;
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    const Vec2 normal = to_double(manifold.normal);
    v -= dot(v, normal) * normal;
  }
  return v;
}

/// Returns an upper bound of the error of a position from single precision, m.
double single_rounding(Vec2 position) {
  const double scale = std::abs(position.x) + std::abs(position.y) + 1.0;
  return single_roundings * static_cast<double>(std::numeric_limits<float>::epsilon()) * scale;
}

/// Returns the velocity that the user has given a body since world.Step, m/s. A step leaves a body with the velocity
/// that it moved it with, except along the normals of contacts, where Box2D also corrects penetration, and except
/// where there are joints.
Vec2 external_delta_v(const b2Body& body, const CarryState& state) {
  const Vec2 v = to_double(body.GetLinearVelocity());
  const Vec2 center = to_double(body.GetWorldCenter());
  if (body.GetJointList() != nullptr || state.dt == 0.0) return {};
  const Vec2 delta = without_normal_components(body, v - (1.0 / state.dt) * (center - state.start));
  const double noise = single_rounding(center) / state.dt + single_rounding(v);
  const bool is_teleported = length(delta) > 2.0 * length(v - state.velocity) + noise;
  return length(delta) <= noise || is_teleported ? Vec2{} : delta;
}

/// What changed a body's velocity since the solver set it, m/s.
struct VelocityChanges {
  Vec2 by_user;      // since world.Step
  Vec2 by_contacts;  // in world.Step: contacts, joints and forces of Box2D
};

VelocityChanges velocity_changes(const b2Body& body, const CarryState& state) {
  const Vec2 by_user = external_delta_v(body, state);
  return {by_user, to_double(body.GetLinearVelocity()) - state.velocity - by_user};
}

/// Returns `v` with its component along the unit vector n shortened until |v|² is at most `most`, m²/s².
Vec2 slowed_along(Vec2 n, Vec2 v, double most) {
  if (dot(v, v) <= most) return v;
  const double along = dot(v, n);
  const Vec2 across = v - along * n;
  const double limit = std::sqrt(std::max(0.0, most - dot(across, across)));
  return across + std::clamp(along, -limit, limit) * n;
}

/// Returns the largest |v|² [m²/s²] that a body may have with its carry, so that its energy rises by no more than
/// Box2D's pushes did work on it.
///
/// The solver left the body with the velocity v + e + c at the end of the tick: v of a step without pushes, the push e
/// that it expected, and the carry c. Box2D's body would have had v + e, and has w = v + Δv. Its contacts did the work
/// m·(|w|² − |v + e|²)/2, so
///
///     |v_end|² ≤ |v + e + c|² + |w|² − |v + e|².
///
/// Where an expected push does not come, w lacks it, and no contact did that work. So the smaller one of |w| with and
/// without the part of e that is missing counts.
double allowed_speed_squared(const CarryState& state, Vec2 delta_v) {
  const Vec2 expected = state.expected_delta_v;
  const Vec2 planned = state.velocity + expected;
  const Vec2 solved = planned + state.carry;
  const Vec2 pushed = state.velocity + delta_v;
  const double expected_squared = dot(expected, expected);
  const double missing =
      expected_squared > 0.0 ? 1.0 - std::clamp(dot(delta_v, expected) / expected_squared, 0.0, 1.0) : 0.0;
  const Vec2 completed = pushed + missing * expected;
  return dot(solved, solved) - dot(planned, planned) + std::min(dot(pushed, pushed), dot(completed, completed));
}

/// Returns the part of the carry that is still valid. A contact stops the body, so it removes the whole component along
/// the direction n of its push. A force removes no more than it gave, and nothing as far as the cord expected it.
/// Nothing may add energy: where the cord slowed the body down, the carry is against its velocity, and without it the
/// body is faster than the cord has left it.
Vec2 remaining_carry(const b2Body& body, const CarryState& state, Vec2 delta_v) {
  const double noise = min_contact_delta_v * (1.0 + length(state.velocity));
  const bool meets = meets_anything(body);
  const Vec2 unexpected = delta_v - state.expected_delta_v;
  const double push = length(meets ? delta_v : unexpected);
  const double surprise = length(unexpected);
  if (!(push > noise) && !(surprise > noise)) return state.carry;

  const Vec2 n = push > noise ? (1.0 / push) * (meets ? delta_v : unexpected) : Vec2{};
  const double along = dot(state.carry, n);
  const Vec2 rest = state.carry - (meets ? along : std::clamp(along, -push, push)) * n;
  const Vec2 pushed = state.velocity + delta_v;
  const Vec2 slowed_in = surprise > noise ? (1.0 / surprise) * unexpected : n;
  const Vec2 end = pushed + rest;
  const Vec2 bounded_end = slowed_along(slowed_in, end, allowed_speed_squared(state, delta_v));
  return bounded_end == end ? rest : bounded_end - pushed;
}

Vec2 remaining_carry(const b2Body& body, const CarryState& state) {
  return remaining_carry(body, state, velocity_changes(body, state).by_contacts);
}

/// The same for the rotation: a contact that turned the body against its carry ends the carry, as far as the energy of
/// the rotation allows.
double remaining_angular_carry(const b2Body& body, const CarryState& state) {
  const double pushed = static_cast<double>(body.GetAngularVelocity());
  const double before = state.angular_velocity;
  const double delta = pushed - before;
  const bool is_turned = std::abs(delta) > min_contact_delta_v * (1.0 + std::abs(before));
  if (!meets_anything(body) || !is_turned) return state.angular_carry;
  const double rest = delta * state.angular_carry < 0.0 ? 0.0 : state.angular_carry;
  const double solved = before + state.angular_carry;
  const double most = std::sqrt(std::max(0.0, solved * solved + pushed * pushed - before * before));
  return std::abs(pushed + rest) <= most ? rest : std::clamp(pushed + rest, -most, most) - pushed;
}

/// Returns the part of Box2D's push [m/s] that may go on: all of it, unless it is an impact. An impact goes into the
/// velocity, which has changed by `change` in the tick; what is left supports the body.
Vec2 steady_part(const b2Body& body, Vec2 push, Vec2 change) {
  const double size = length(push);
  if (size == 0.0 || !meets_anything(body)) return push;
  const double share = dot(change, push) / (size * size);
  return share > max_impact_share ? std::max(0.0, 1.0 - share) * push : push;
}

/// Returns the push [m/s] of Box2D's contacts and forces in the last tick that may go on. `velocity` is the momentary
/// one of now, m/s.
Vec2 steady_contact_delta_v(const b2Body& body, const CarryState& state, const VelocityChanges& changes,
                            Vec2 velocity) {
  return steady_part(body, changes.by_contacts, velocity - changes.by_user - state.start_velocity);
}

/// Returns the part of a push [m/s] that came in both of the last two ticks: what supports a standing or leaning body,
/// or a steady force.
Vec2 lasting_part(Vec2 before, Vec2 last) {
  if (!(dot(before, last) > 0.0)) return {};
  return (std::min(length(before), length(last)) / length(last)) * last;
}

void add_carry(b2Body& body, const CarryState& state) {
  body.SetLinearVelocity(to_float(to_double(body.GetLinearVelocity()) + remaining_carry(body, state)));
  body.SetAngularVelocity(
      static_cast<float>(static_cast<double>(body.GetAngularVelocity()) + remaining_angular_carry(body, state)));
}

}  // namespace

bool meets_anything(const b2Body& body) {
  if (body.GetJointList() != nullptr) return true;
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->contact->IsTouching() && edge->contact->GetManifold()->pointCount > 0) return true;
  }
  return false;
}

void VelocityCarry::complete(const b2Body& body, RigidBody& rigid, double dt) {
  Entry* const found = entry(body);
  if (found == nullptr) return;
  const VelocityChanges changes = velocity_changes(body, *found);
  rigid.velocity += remaining_carry(body, *found, changes.by_contacts);
  found->next_contact_delta_v = steady_contact_delta_v(body, *found, changes, rigid.velocity);
  // Without it the cord would let the body fall in each tick.
  found->next_expected_delta_v = lasting_part(found->contact_delta_v, found->next_contact_delta_v);
  found->completed = true;
  rigid.acceleration += bounded((1.0 / dt) * found->next_expected_delta_v, max_acceleration);
  rigid.angular_velocity += remaining_angular_carry(body, *found);
  if (length(rigid.position - found->position) <= single_rounding(rigid.position)) rigid.position = found->position;
}

void VelocityCarry::leave_to_support(const b2Body& body, RigidBody& rigid, Vec2 normal, double dt) {
  Entry* const found = entry(body);
  if (found == nullptr) return;
  const Vec2 before = found->next_expected_delta_v;
  const Vec2 left = before - std::max(0.0, dot(before, normal)) * normal;
  found->next_expected_delta_v = left;
  rigid.acceleration += bounded((1.0 / dt) * left, max_acceleration) - bounded((1.0 / dt) * before, max_acceleration);
}

void VelocityCarry::find_push(const b2Body& body, RigidBody& rigid, double dt) {
  Entry* const found = entry(body);
  if (found == nullptr || rigid.inverse_mass == 0.0) return;
  if (length(rigid.position - found->start) <= single_rounding(rigid.position)) return;
  const Vec2 pushed = rigid.position - found->position;
  const double expected_turning = found->angular_velocity;
  const double turn = rigid.inverse_inertia > 0.0
                          ? found->dt * (static_cast<double>(body.GetAngularVelocity()) - expected_turning)
                          : 0.0;
  const bool is_small = length(pushed) < least_push && std::abs(turn) < least_turn;
  if (is_small || length(pushed) > most_push || std::abs(turn) > most_turn) return;
  if (dot(found->next_expected_delta_v, pushed) > 0.0) {
    rigid.acceleration -= bounded((1.0 / dt) * found->next_expected_delta_v, max_acceleration);
    found->next_expected_delta_v = {};
  }
  rigid.pushed = pushed;
  rigid.pushed_turn = turn;
}

void VelocityCarry::begin_step() {
  for (Entry& entry : bodies_) {
    if (!std::exchange(entry.completed, false)) continue;
    entry.contact_delta_v = entry.next_contact_delta_v;
    entry.expected_delta_v = entry.next_expected_delta_v;
  }
}

/// With a = g·scale, the divisor d of the damping, and the change s of velocity by the push of supports, Box2D's
/// velocity in the step is (v + a·dt)/d + s. So v is set to d·(Δx/dt − s) − a·dt, which presses the body on its
/// supports, and the carry is c = (v⁺ − (v + a·dt))/d − s, with the v that single precision has left. It is only
/// friction that Box2D needs s for, so a jolt is left out.
void VelocityCarry::drive(b2Body& body, const RigidBody& rigid, double max_push, const StepConditions& conditions) {
  const double dt = conditions.dt;
  Entry& state = entry_or_new(body);
  const Vec2 fall = dt * rigid.acceleration;
  const double divisor = damping_divisor(body.GetLinearDamping(), dt);
  const Vec2 whole_push = (dt * rigid.inverse_mass) * rigid.support_force;
  const double lasting = std::min(max_push, length(lasting_part(state.support_delta_v, whole_push)));
  const double share = lasting > 0.0 ? lasting / length(whole_push) : 0.0;
  const Vec2 push = share * whole_push;
  state.support_delta_v = whole_push;
  const Vec2 wanted = divisor * ((1.0 / dt) * rigid.moved - push) - fall;
  body.ApplyLinearImpulseToCenter(to_float((1.0 / rigid.inverse_mass) * (wanted - to_double(body.GetLinearVelocity()))),
                                  true);
  const Vec2 end = rigid.velocity + fall + rigid.inverse_mass * rigid.impulse;
  state.carry =
      bounded((1.0 / divisor) * (end - (to_double(body.GetLinearVelocity()) + fall)) - push, CarryState::max_carry);
  state.start = to_double(body.GetWorldCenter());
  state.start_velocity = rigid.velocity;
  state.dt = dt;
  state.position = rigid.position + rigid.moved;
  const Vec2 weight = (dt * static_cast<double>(body.GetGravityScale())) * conditions.gravity;
  state.velocity = (1.0 / divisor) * (to_double(body.GetLinearVelocity()) + weight) + push;
  if (rigid.inverse_inertia == 0.0) return;
  const double turning = static_cast<double>(body.GetAngularVelocity());
  const double angular_divisor = damping_divisor(body.GetAngularDamping(), dt);
  const double turn = share * dt * rigid.inverse_inertia * rigid.support_torque;
  const double wanted_turning = angular_divisor * (rigid.turned / dt - turn);
  body.ApplyAngularImpulse(static_cast<float>((wanted_turning - turning) / rigid.inverse_inertia), true);
  const double angular_end = rigid.angular_velocity + rigid.inverse_inertia * rigid.angular_impulse;
  const double carry = (angular_end - static_cast<double>(body.GetAngularVelocity())) / angular_divisor - turn;
  state.angular_carry = bounded({carry, 0.0}, CarryState::max_carry).x;
  state.angular_velocity = static_cast<double>(body.GetAngularVelocity()) / angular_divisor + turn;
}

void VelocityCarry::release(b2Body& body) {
  const Entry* const found = entry(body);
  if (found == nullptr) return;
  add_carry(body, *found);
  bodies_.erase(place(body));
}

void VelocityCarry::release_unless(const std::function<bool(const SeenBody&)>& gathered, BodyFinder& finder) {
  finder.clear();
  bool any_left = false;
  for (Entry& entry : bodies_) {
    entry.left = !gathered(entry.seen);
    if (!entry.left) {
      entry.seen = SeenBody(*entry.seen.body);
      continue;
    }
    any_left = true;
    if (finder.trusts_forget()) {
      finder.take_as_found(entry.seen.body);
    } else {
      finder.want(entry.seen.body);
    }
  }
  if (!any_left) return;
  if (!finder.trusts_forget()) finder.search();
  for (const Entry& entry : bodies_) {
    if (entry.left && finder.was_found(entry.seen) && is_sound(*entry.seen.body)) add_carry(*entry.body, entry);
  }
  bodies_.erase(std::remove_if(bodies_.begin(), bodies_.end(), [](const Entry& entry) { return entry.left; }),
                bodies_.end());
}

/// Its position stays stored: a body that does not move is where it was.
void VelocityCarry::put_to_sleep(b2Body& body, double dt) {
  body.SetAwake(false);
  Entry* const found = entry(body);
  if (found == nullptr) return;
  CarryState rest;
  rest.position = found->position;
  rest.start = to_double(body.GetWorldCenter());
  rest.dt = dt;
  static_cast<CarryState&>(*found) = rest;
}

void VelocityCarry::forget(const b2Body& body) {
  const auto at = place(body);
  if (at != bodies_.end() && at->body == &body) bodies_.erase(at);
}

Vec2 VelocityCarry::velocity(const b2Body& body) const {
  const Entry* const found = entry(body);
  return to_double(body.GetLinearVelocity()) + (found != nullptr ? remaining_carry(body, *found) : Vec2{});
}

double VelocityCarry::angular_velocity(const b2Body& body) const {
  const Entry* const found = entry(body);
  return static_cast<double>(body.GetAngularVelocity()) +
         (found != nullptr ? remaining_angular_carry(body, *found) : 0.0);
}

void VelocityCarry::restore(b2Body& body, const CarryState& state) {
  bodies_.insert(place(body), {state, &body, SeenBody(body)});
}

bool VelocityCarry::has_predecessor(const b2Body& body) const {
  const auto at = place(body);
  return at != bodies_.end() && at->body == &body && !at->seen.is(body);
}

std::vector<VelocityCarry::Entry>::const_iterator VelocityCarry::place(const b2Body& body) const {
  return std::lower_bound(bodies_.begin(), bodies_.end(), &body,
                          [](const Entry& entry, const b2Body* wanted) { return std::less<>()(entry.body, wanted); });
}

const VelocityCarry::Entry* VelocityCarry::entry(const b2Body& body) const {
  const auto at = place(body);
  return at != bodies_.end() && at->body == &body && at->seen.is(body) ? &*at : nullptr;
}

VelocityCarry::Entry* VelocityCarry::entry(const b2Body& body) {
  return const_cast<Entry*>(std::as_const(*this).entry(body));
}

VelocityCarry::Entry& VelocityCarry::entry_or_new(b2Body& body) {
  if (Entry* const found = entry(body)) return *found;
  forget(body);
  return *bodies_.insert(place(body), {{}, &body, SeenBody(body)});
}

}  // namespace ribbon::box2d
