#include "ribbon/box2d/tick_bodies.h"

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

RigidBody rigid_body(const b2Body& body, Vec2 gravity) {
  RigidBody rigid;
  rigid.position = to_double(body.GetWorldCenter());
  rigid.velocity = to_double(body.GetLinearVelocity());
  rigid.angular_velocity = static_cast<double>(body.GetAngularVelocity());
  if (body.GetType() != b2_dynamicBody) return rigid;
  const double mass = static_cast<double>(body.GetMass());
  // Box2D returns the moment of inertia about the body's origin. By Steiner's theorem I_centre = I_origin − m·|r|².
  const Vec2 from_origin = to_double(body.GetLocalCenter());
  const double inertia = static_cast<double>(body.GetInertia()) - mass * dot(from_origin, from_origin);
  rigid.inverse_mass = 1.0 / mass;
  if (!body.IsFixedRotation() && inertia > 0.0) rigid.inverse_inertia = 1.0 / inertia;
  rigid.acceleration = static_cast<double>(body.GetGravityScale()) * gravity;
  rigid.awake = body.IsAwake();
  rigid.may_sleep = body.IsSleepingAllowed() && body.GetWorld()->GetAllowSleeping();
  return rigid;
}

}  // namespace

void TickBodies::reserve(std::size_t bodies) {
  entries.reserve(bodies);
  rigid.reserve(bodies);
  places_.reserve(bodies);
}

void TickBodies::clear() {
  entries.clear();
  rigid.clear();
  places_.clear();
}

int TickBodies::index_of(b2Body& body, VelocityCarry& carry, const StepConditions& conditions) {
  const int known = places_.find(&body);
  if (known >= 0) return known;
  const int place = static_cast<int>(entries.size());
  places_.set(&body, place);
  entries.push_back({&body});
  rigid.push_back(rigid_body(body, conditions.gravity));
  carry.complete(body, rigid.back(), conditions.dt);
  return place;
}

const b2Body* TickBodies::find(const b2Body* address) const {
  const int place = places_.find(address);
  return place < 0 ? nullptr : entries[static_cast<std::size_t>(place)].body;
}

void TickBodies::forget(const b2Body& body) {
  for (TickBody& entry : entries) {
    if (entry.body == &body) entry.body = nullptr;
  }
}

}  // namespace ribbon::box2d
