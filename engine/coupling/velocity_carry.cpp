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
constexpr double max_acceleration = 1e19;     // m/s², of a body in a step of the solver

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

/// Returns the change of velocity by contacts, joints and forces of Box2D in the last world.Step, m/s.
Vec2 contact_delta_v(const b2Body& body, const CarryState& state) {
  return to_double(body.GetLinearVelocity()) - state.velocity - external_delta_v(body, state);
}

/// Returns the part of the carry that is still valid: without its component along the direction n in which Box2D pushed
/// the body. A contact stops the body, so it removes the whole component. A force removes no more than it gave, and
/// nothing as far as the cord expected it.
Vec2 remaining_carry(const b2Body& body, const CarryState& state) {
  const Vec2 all = contact_delta_v(body, state);
  const Vec2 unexpected = meets_anything(body) ? all : all - state.expected_delta_v;
  const double size = length(unexpected);
  if (!(size > min_contact_delta_v * (1.0 + length(state.velocity)))) return state.carry;
  const Vec2 n = (1.0 / size) * unexpected;
  const double along = dot(state.carry, n);
  return state.carry - (meets_anything(body) ? along : std::clamp(along, -size, size)) * n;
}

/// The same for the rotation: a contact that turned the body against its carry ends the carry.
double remaining_angular_carry(const b2Body& body, const CarryState& state) {
  const double delta = static_cast<double>(body.GetAngularVelocity()) - state.angular_velocity;
  const bool is_against = std::abs(delta) > min_contact_delta_v * (1.0 + std::abs(state.angular_velocity)) &&
                          delta * state.angular_carry < 0.0;
  return meets_anything(body) && is_against ? 0.0 : state.angular_carry;
}

/// Returns the acceleration [m/s²] by which Box2D's contacts and forces have pushed a body in both of the last two
/// ticks: what supports a standing or leaning body, or a steady force. Without it the cord would let the body fall in
/// each tick.
Vec2 expected_acceleration(const b2Body& body, CarryState& state, double dt) {
  const Vec2 before = state.contact_delta_v;
  state.contact_delta_v = contact_delta_v(body, state);
  state.expected_delta_v = {};
  if (dot(before, state.contact_delta_v) > 0.0) {
    const double smaller = std::min(length(before), length(state.contact_delta_v));
    state.expected_delta_v = (smaller / length(state.contact_delta_v)) * state.contact_delta_v;
  }
  return bounded((1.0 / dt) * state.expected_delta_v, max_acceleration);
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
  rigid.velocity += remaining_carry(body, *found);
  rigid.acceleration += expected_acceleration(body, *found, dt);
  rigid.angular_velocity += remaining_angular_carry(body, *found);
  if (length(rigid.position - found->position) <= single_rounding(rigid.position)) rigid.position = found->position;
}

/// With a = g·scale, and d the divisor of the damping, Box2D's velocity in the step is (v + a·dt)/d. So v is set to
/// d·Δx/dt − a·dt, and the carry is c = (v⁺ − (v + a·dt))/d, with the v that single precision has left.
void VelocityCarry::drive(b2Body& body, const RigidBody& rigid, const StepConditions& conditions) {
  const double dt = conditions.dt;
  Entry& state = entry_or_new(body);
  const Vec2 fall = dt * rigid.acceleration;
  const double divisor = damping_divisor(body.GetLinearDamping(), dt);
  const Vec2 wanted = (divisor / dt) * rigid.moved - fall;
  body.ApplyLinearImpulseToCenter(to_float((1.0 / rigid.inverse_mass) * (wanted - to_double(body.GetLinearVelocity()))),
                                  true);
  const Vec2 end = rigid.velocity + fall + rigid.inverse_mass * rigid.impulse;
  state.carry = bounded((1.0 / divisor) * (end - (to_double(body.GetLinearVelocity()) + fall)), CarryState::max_carry);
  state.start = to_double(body.GetWorldCenter());
  state.dt = dt;
  state.position = rigid.position + rigid.moved;
  const Vec2 weight = (dt * static_cast<double>(body.GetGravityScale())) * conditions.gravity;
  state.velocity = (1.0 / divisor) * (to_double(body.GetLinearVelocity()) + weight);
  if (rigid.inverse_inertia == 0.0) return;
  const double turning = static_cast<double>(body.GetAngularVelocity());
  const double angular_divisor = damping_divisor(body.GetAngularDamping(), dt);
  body.ApplyAngularImpulse(static_cast<float>((angular_divisor * rigid.turned / dt - turning) / rigid.inverse_inertia),
                           true);
  const double angular_end = rigid.angular_velocity + rigid.inverse_inertia * rigid.angular_impulse;
  const double carry = (angular_end - static_cast<double>(body.GetAngularVelocity())) / angular_divisor;
  state.angular_carry = bounded({carry, 0.0}, CarryState::max_carry).x;
  state.angular_velocity = static_cast<double>(body.GetAngularVelocity()) / angular_divisor;
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
