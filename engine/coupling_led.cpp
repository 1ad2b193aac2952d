// How a Coupling moves the bodies: by an impulse, or on the way that the direct solver found for them.

#include <algorithm>
#include <functional>

#include "engine/convert.h"
#include "engine/coupling.h"

namespace engine {
namespace {

using ribbon::RigidBody;
using ribbon::Vec2;

constexpr double unworthy_push = 1e-5;  // m/s, and as a share, that single precision explains

/// By what Box2D divides velocities in a tick.
double damped(float damping, double dt) { return 1.0 + dt * static_cast<double>(damping); }

/// N·s, what a contact gave its second body in the last world.Step.
Vec2 impulse_of(const b2Contact& contact, Vec2 normal) {
  const b2Manifold& manifold = *contact.GetManifold();
  const Vec2 tangent{normal.y, -normal.x};  // as b2ContactSolver has it
  Vec2 sum;
  for (int k = 0; k < manifold.pointCount; ++k) {
    sum += static_cast<double>(manifold.points[k].normalImpulse) * normal +
           static_cast<double>(manifold.points[k].tangentImpulse) * tangent;
  }
  return sum;
}

/// m/s, what of the `change` of a body's velocity [m/s] since it was led its contacts and joints in Box2D explain; the
/// rest is what somebody gave it by ApplyForce, ApplyLinearImpulse and the like. A contact that Box2D solved at its
/// time of impact keeps no impulse: then it is all that the change is away from it.
Vec2 pushed_by_others(const b2Body& body, Vec2 change) {
  const double inverse_mass = body.GetMass() > 0.0F ? 1.0 / static_cast<double>(body.GetMass()) : 0.0;
  Vec2 sum;
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    const b2Contact& contact = *edge->contact;
    if (!contact.IsTouching() || !contact.IsEnabled() || contact.GetManifold()->pointCount == 0) continue;
    b2WorldManifold manifold;
    contact.GetWorldManifold(&manifold);
    const double sign = contact.GetFixtureB()->GetBody() == &body ? 1.0 : -1.0;
    const Vec2 normal = to_double(manifold.normal);
    const Vec2 impulse = impulse_of(contact, normal);
    const double away = sign * dot(change, normal);
    if (impulse == Vec2{} && away > 0.0) sum += (sign * away) * normal;
    sum += (sign * inverse_mass) * impulse;
  }
  for (const b2JointEdge* edge = body.GetJointList(); edge != nullptr; edge = edge->next) {
    const double sign = edge->joint->GetBodyB() == &body ? 1.0 : -1.0;
    sum += (sign * inverse_mass) * to_double(edge->joint->GetReactionForce(1.0F));
  }
  return sum;
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
  led.ahead = (1.0 / divided) * (end - (to_double(body.GetLinearVelocity()) + fall));
  led.position = rigid.position + rigid.moved;
  const Vec2 weight = (dt_ * static_cast<double>(body.GetGravityScale())) * gravity_;
  led.velocity = (1.0 / divided) * (to_double(body.GetLinearVelocity()) + weight);
  led.led = true;
  if (rigid.inverse_inertia == 0.0) return;
  const double turning = static_cast<double>(body.GetAngularVelocity());
  const double divided_turning = damped(body.GetAngularDamping(), dt_);
  body.ApplyAngularImpulse(static_cast<float>((divided_turning * rigid.turned / dt_ - turning) / rigid.inverse_inertia),
                           true);
  const double end_turning = rigid.angular_velocity + rigid.inverse_inertia * rigid.angular_impulse;
  led.ahead_turning = (end_turning - static_cast<double>(body.GetAngularVelocity())) / divided_turning;
}

/// Gives a body that no cord moves any more what Box2D could not show of its velocity.
void Coupling::let_run(b2Body& body) {
  const LedBody* before = led(body);
  if (before == nullptr) return;
  body.SetLinearVelocity(to_float(to_double(body.GetLinearVelocity()) + ahead(body, *before)));
  body.SetAngularVelocity(static_cast<float>(static_cast<double>(body.GetAngularVelocity()) + before->ahead_turning));
  led_.erase(led_place(body));
}

std::vector<Coupling::LedBody>::iterator Coupling::led_place(const b2Body& body) {
  return std::lower_bound(led_.begin(), led_.end(), &body,
                          [](const LedBody& led, const b2Body* wanted) { return std::less<>()(led.body, wanted); });
}

Coupling::LedBody* Coupling::led(const b2Body& body) {
  const auto place = led_place(body);
  return place != led_.end() && place->body == &body ? &*place : nullptr;
}

const Coupling::LedBody* Coupling::led(const b2Body& body) const { return const_cast<Coupling*>(this)->led(body); }

/// What a body met pushes it in a direction in which its velocity is Box2D's then, with nothing ahead of it: who stands
/// does not go on falling. What the game itself gives a body comes on top.
Vec2 Coupling::ahead(const b2Body& body, const LedBody& led) {
  const Vec2 pushed = pushed_by_others(body, to_double(body.GetLinearVelocity()) - led.velocity);
  const double size = length(pushed);
  if (!(size > unworthy_push * (1.0 + length(led.velocity)))) return led.ahead;
  const Vec2 n = (1.0 / size) * pushed;
  return led.ahead - dot(led.ahead, n) * n;
}

/// What holds up a body that stands or leans, m/s²: what Box2D's other contacts have pushed it with in both of the last
/// two ticks. The cord would let it fall otherwise, and be told after each tick that it did not.
Vec2 Coupling::reaction(const b2Body& body, LedBody& led) const {
  const Vec2 before = led.pushed;
  led.pushed = pushed_by_others(body, to_double(body.GetLinearVelocity()) - led.velocity);
  const double along = dot(before, led.pushed);
  if (!(along > 0.0)) return {};
  const double least = std::min(length(before), length(led.pushed));
  return (least / (length(led.pushed) * dt_)) * led.pushed;
}

Coupling::LedBody& Coupling::led_or_new(const b2Body& body) {
  if (LedBody* before = led(body)) return *before;
  return *led_.insert(led_place(body), {&body, {}, 0.0, {}, {}, {}, true});
}

Vec2 Coupling::velocity(const b2Body& body) const {
  const LedBody* found = led(body);
  return to_double(body.GetLinearVelocity()) + (found != nullptr ? ahead(body, *found) : Vec2{});
}

}  // namespace engine
