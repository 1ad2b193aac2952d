// How a Coupling moves the bodies: by an impulse, or on the way that the direct solver found for them.

#include <algorithm>
#include <cmath>
#include <functional>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"

namespace engine {
namespace {

using ribbon::RigidBody;
using ribbon::Vec2;

constexpr double single_roundings = 8.0;  // within which a body is where it was led to
constexpr double unworthy_push = 1e-5;    // m/s, and as a share, that single precision explains
constexpr double most_reaction = 1e19;    // m/s², of a body that a cord can meet

/// By what Box2D divides velocities in a tick.
double damped(float damping, double dt) { return 1.0 + dt * static_cast<double>(damping); }

/// What no cord could meet is left out, or the next step would refuse the body.
Vec2 bounded(Vec2 v, double most) { return std::abs(v.x) <= most && std::abs(v.y) <= most ? v : Vec2{}; }

/// Takes away from v what is along the normals of a body's contacts.
Vec2 along_contacts(const b2Body& body, Vec2 v) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (!edge->contact->IsTouching() || edge->contact->GetManifold()->pointCount == 0) continue;
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    const Vec2 normal = to_double(manifold.normal);
    v -= dot(v, normal) * normal;
  }
  return v;
}

}  // namespace

/// Gives a touching body its impulse; what single precision loses of it stays with the cord.
void Coupling::push(const GatheredBody& gathered, const RigidBody& rigid) {
  if (rigid.impulse == Vec2{} && rigid.angular_impulse == 0.0) return;
  b2Body& body = *gathered.body;
  const Vec2 before = to_double(body.GetLinearVelocity());
  body.ApplyLinearImpulseToCenter(to_float(rigid.impulse), true);
  body.ApplyAngularImpulse(static_cast<float>(rigid.angular_impulse), true);
  const Vec2 given = (1.0 / rigid.inverse_mass) * (to_double(body.GetLinearVelocity()) - before);
  std::get<ribbon::ThesisCord>(cords_[at(gathered.met)].cord).add_momentum(rigid.impulse - given);
}

/// Makes world.Step take a body to where the cord saw it go. With v⁺ its velocity at the end of the tick, Box2D, which
/// adds a·dt to a velocity and divides it by 1 + c·dt for damping c, gets m·((1 + c·dt)·Δx/dt − a·dt − v), and v⁺ −
/// Δx/dt is carried on.
void Coupling::lead(b2Body& body, const RigidBody& rigid) {
  LedBody& led = led_or_new(body);
  const Vec2 fall = dt_ * rigid.acceleration;
  const double divided = damped(body.GetLinearDamping(), dt_);
  const Vec2 wanted = (divided / dt_) * rigid.moved - fall;
  body.ApplyLinearImpulseToCenter(to_float((1.0 / rigid.inverse_mass) * (wanted - to_double(body.GetLinearVelocity()))),
                                  true);
  const Vec2 end = rigid.velocity + fall + rigid.inverse_mass * rigid.impulse;
  led.ahead = bounded((1.0 / divided) * (end - (to_double(body.GetLinearVelocity()) + fall)), LedMemory::most_ahead);
  led.start = to_double(body.GetWorldCenter());
  led.dt = dt_;
  led.position = rigid.position + rigid.moved;
  const Vec2 weight = (dt_ * static_cast<double>(body.GetGravityScale())) * gravity_;
  led.velocity = (1.0 / divided) * (to_double(body.GetLinearVelocity()) + weight);
  if (rigid.inverse_inertia == 0.0) return;
  const double turning = static_cast<double>(body.GetAngularVelocity());
  const double divided_turning = damped(body.GetAngularDamping(), dt_);
  body.ApplyAngularImpulse(static_cast<float>((divided_turning * rigid.turned / dt_ - turning) / rigid.inverse_inertia),
                           true);
  const double end_turning = rigid.angular_velocity + rigid.inverse_inertia * rigid.angular_impulse;
  const double ahead = (end_turning - static_cast<double>(body.GetAngularVelocity())) / divided_turning;
  led.ahead_turning = bounded({ahead, 0.0}, LedMemory::most_ahead).x;
  led.turning = static_cast<double>(body.GetAngularVelocity()) / divided_turning;
}

/// Gives a body that no cord moves any more what Box2D could not show of its velocity.
void Coupling::let_run(b2Body& body) {
  const LedBody* before = led(body);
  if (before == nullptr) return;
  add_ahead(body, *before);
  led_.erase(led_place(body));
}

void Coupling::add_ahead(b2Body& body, const LedBody& led) {
  body.SetLinearVelocity(to_float(to_double(body.GetLinearVelocity()) + ahead(body, led)));
  body.SetAngularVelocity(
      static_cast<float>(static_cast<double>(body.GetAngularVelocity()) + ahead_turning(body, led)));
}

/// Puts a body to sleep with the cords at it. Where it was led to stays known, and that there is nothing ahead of it.
void Coupling::lay_to_rest(b2Body& body) {
  body.SetAwake(false);
  LedBody* found = led(body);
  if (found == nullptr) return;
  LedMemory rest;
  rest.position = found->position;
  rest.start = to_double(body.GetWorldCenter());
  rest.dt = dt_;
  static_cast<LedMemory&>(*found) = rest;
}

/// Whether a joint or a contact of Box2D's may push it.
bool Coupling::meets_anything(const b2Body& body) {
  if (body.GetJointList() != nullptr) return true;
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->contact->IsTouching() && edge->contact->GetManifold()->pointCount > 0) return true;
  }
  return false;
}

std::vector<Coupling::LedBody>::iterator Coupling::led_place(const b2Body& body) {
  return std::lower_bound(led_.begin(), led_.end(), &body,
                          [](const LedBody& led, const b2Body* wanted) { return std::less<>()(led.body, wanted); });
}

Coupling::LedBody* Coupling::led(const b2Body& body) {
  const auto place = led_place(body);
  return place != led_.end() && place->body == &body && place->seen.is(body) ? &*place : nullptr;
}

const Coupling::LedBody* Coupling::led(const b2Body& body) const { return const_cast<Coupling*>(this)->led(body); }

/// By how much a place may be other for having been in single precision.
double Coupling::single_rounding(Vec2 position) {
  const double scale = std::abs(position.x) + std::abs(position.y) + 1.0;
  return single_roundings * static_cast<double>(std::numeric_limits<float>::epsilon()) * scale;
}

/// m/s, what somebody has given a body since world.Step, by ApplyLinearImpulse and the like: a step moves it with the
/// velocity that it leaves it with. Not along the normals of its contacts, in which Box2D moves it out of what it is
/// in, nor where joints do so.
Vec2 Coupling::given(const b2Body& body, const LedBody& led) {
  const Vec2 v = to_double(body.GetLinearVelocity());
  const Vec2 center = to_double(body.GetWorldCenter());
  if (body.GetJointList() != nullptr || led.dt == 0.0) return {};
  const Vec2 given = along_contacts(body, v - (1.0 / led.dt) * (center - led.start));
  const double noise = single_rounding(center) / led.dt + single_rounding(v);
  const bool is_teleported = length(given) > 2.0 * length(v - led.velocity) + noise;
  return length(given) <= noise || is_teleported ? Vec2{} : given;
}

/// m/s, what contacts, joints and forces in Box2D pushed a body with in the last step.
Vec2 Coupling::pushed(const b2Body& body, const LedBody& led) {
  return to_double(body.GetLinearVelocity()) - led.velocity - given(body, led);
}

/// What a body met pushes it in a direction in which its velocity is Box2D's then, with nothing ahead of it: who stands
/// does not go on falling. A force does so until it is expected, and as far as it pushes.
Vec2 Coupling::ahead(const b2Body& body, const LedBody& led) {
  const Vec2 all = pushed(body, led);
  const Vec2 by = meets_anything(body) ? all : all - led.expected_push;
  const double size = length(by);
  if (!(size > unworthy_push * (1.0 + length(led.velocity)))) return led.ahead;
  const Vec2 n = (1.0 / size) * by;
  const double along = dot(led.ahead, n);
  return led.ahead - (meets_anything(body) ? along : std::clamp(along, -size, size)) * n;
}

/// The same of the rotation: what a body met stops what it turns against.
double Coupling::ahead_turning(const b2Body& body, const LedBody& led) {
  const double by = static_cast<double>(body.GetAngularVelocity()) - led.turning;
  const bool is_against = std::abs(by) > unworthy_push * (1.0 + std::abs(led.turning)) && by * led.ahead_turning < 0.0;
  return meets_anything(body) && is_against ? 0.0 : led.ahead_turning;
}

/// What holds up a body that stands or leans, or draws it steadily, m/s²: what Box2D's contacts and forces have pushed
/// it with in both of the last two ticks. The cord would let it fall otherwise, and be told after each tick that it did
/// not.
Vec2 Coupling::reaction(const b2Body& body, LedBody& led) const {
  const Vec2 before = led.pushed;
  led.pushed = pushed(body, led);
  led.expected_push = {};
  const double along = dot(before, led.pushed);
  if (along > 0.0) {
    const double least = std::min(length(before), length(led.pushed));
    led.expected_push = (least / length(led.pushed)) * led.pushed;
  }
  return bounded((1.0 / dt_) * led.expected_push, most_reaction);
}

Coupling::LedBody& Coupling::led_or_new(b2Body& body) {
  if (LedBody* before = led(body)) return *before;
  const auto place = led_place(body);
  if (place != led_.end() && place->body == &body) return *place = {{}, &body, SeenBody(body)};
  return *led_.insert(place, {{}, &body, SeenBody(body)});
}

Vec2 Coupling::velocity(const b2Body& body) const {
  const LedBody* found = led(body);
  return to_double(body.GetLinearVelocity()) + (found != nullptr ? ahead(body, *found) : Vec2{});
}

double Coupling::angular_velocity(const b2Body& body) const {
  const LedBody* found = led(body);
  return static_cast<double>(body.GetAngularVelocity()) + (found != nullptr ? ahead_turning(body, *found) : 0.0);
}

}  // namespace engine
