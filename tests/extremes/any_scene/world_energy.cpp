// The energy of a world.

#include <algorithm>
#include <limits>

#include "ribbon/box2d/convert.h"
#include "ribbon/cord_forces.h"
#include "ribbon/pulley.h"
#include "tests/extremes/any_scene/world.h"
#include "tests/support/slot.h"

namespace any_scene {

using ribbon::Vec2;
using ribbon::box2d::CordId;
using ribbon::box2d::CouplingState;
using ribbon::box2d::to_double;

namespace {

using test_support::slot;

/// Returns the kinetic energy of a wheel about its axle, J.
double kinetic_energy(const ribbon::Pulley& pulley) {
  return 0.5 * pulley.def.inertia * pulley.turning * pulley.turning;
}

/// Returns the elastic energy of the straight parts of a cord at a wheel, J: energy_of has that of the other links.
/// On the wheel it is not stretched.
double elastic_energy(const ribbon::Cord& cord, const ribbon::Pulley& pulley) {
  double trail = -pulley.lead - pulley.def.radius * pulley.arc;
  for (int link = pulley.def.before; link < pulley.def.after; ++link) trail += cord.rest_length(link);
  const double before = pulley.tension_before * pulley.tension_before * pulley.lead;
  return 0.5 * (before + pulley.tension_after * pulley.tension_after * trail) / cord.def().stretch_stiffness;
}

}  // namespace

/// The state of motion of a body.
struct World::Moving {
  Vec2 center;     // m
  Vec2 velocity;   // m/s
  double turning;  // rad/s
};

World::Moving World::now(const b2Body& body) const {
  return {to_double(body.GetWorldCenter()), coupling_.body(body).velocity(), coupling_.body(body).angular_velocity()};
}

/// Returns the kinetic and potential energy of a body, J.
double World::energy(const b2Body& body, const Moving& moving) const {
  const double mass = static_cast<double>(body.GetMass());
  const double inertia = static_cast<double>(body.GetInertia());  // about its centre, which is its origin
  return 0.5 * mass * dot(moving.velocity, moving.velocity) + 0.5 * inertia * moving.turning * moving.turning -
         mass * dot(scene_.gravity, moving.center);
}

/// Returns the energy of bodies that no cord affects, J.
double World::energy_of_free_bodies(const CouplingState& planned) const {
  std::vector<char> is_moved(bodies_.size(), 0);
  for (const auto& carry : planned.carries) is_moved[slot(carry.body)] = 1;
  double sum = 0.0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (bodies_[k]->GetType() == b2_dynamicBody && is_moved[k] == 0) sum += energy(*bodies_[k], now(*bodies_[k]));
  }
  return sum;
}

/// Returns the energy that Box2D's contacts gave the bodies that cords move, J, from the velocities that Box2D works
/// with. What a collision takes from one body and gives another one is no gain. A collision takes no more kinetic
/// energy from a body than it had at that moment: Box2D's velocities are means of a tick, and may be higher.
double World::work_on_moved_bodies(const CouplingState& planned) const {
  double sum = 0.0;
  for (const auto& carry : planned.carries) {
    const b2Body& body = *bodies_[slot(carry.body)];
    if (body.GetType() != b2_dynamicBody) continue;
    const ribbon::box2d::CarryState& memory = carry.memory;
    const Moving plan{memory.position, memory.velocity + memory.expected_delta_v, memory.angular_velocity};
    const Moving momentary{plan.center, plan.velocity + memory.carry, plan.turning + memory.angular_carry};
    const Moving done{to_double(body.GetWorldCenter()), to_double(body.GetLinearVelocity()),
                      static_cast<double>(body.GetAngularVelocity())};
    const double lifting = energy(body, {done.center, {}, 0.0}) - energy(body, {plan.center, {}, 0.0});
    const double speeding = energy(body, done) - energy(body, plan) - lifting;
    const double kinetic = energy(body, momentary) - energy(body, {plan.center, {}, 0.0});
    sum += lifting + std::max(speeding, -kinetic);
  }
  return sum;
}

World::Energy World::energy() const {
  Energy sum;
  for (const CordId c : coupling_.cords()) {
    const ribbon::Cord& cord = coupling_.cord(c).direct();
    const ribbon::CordEnergy of_cord = energy_of(cord, scene_.gravity);
    sum.total += of_cord.total();
    sum.kinetic += of_cord.kinetic;
    for (const ribbon::Pulley& pulley : pulleys_of(cord)) {
      const double turning = kinetic_energy(pulley);
      sum.total += turning + elastic_energy(cord, pulley);
      sum.kinetic += turning;
    }
  }
  for (const b2Body* body : bodies_) {
    if (body->GetType() != b2_dynamicBody) continue;
    const double all = energy(*body, now(*body));
    sum.total += all;
    sum.kinetic += all + static_cast<double>(body->GetMass()) * dot(scene_.gravity, to_double(body->GetWorldCenter()));
  }
  sum.box2d = box2d_work_;
  return sum;
}

double World::weight() const {
  double mass = 0.0;
  for (const SceneCord& cord : scene_.cords) mass += cord.def.mass_per_length * cord.def.length;
  for (const b2Body* body : bodies_) mass += static_cast<double>(body->GetMass());
  return mass * length(scene_.gravity);
}

Vec2 World::heights() const {
  Vec2 range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto take = [&](double y) { range = {std::min(range.x, y), std::max(range.y, y)}; };
  for (const CordId c : coupling_.cords()) {
    for (const Vec2 x : coupling_.cord(c).positions()) take(x.y);
  }
  for (const b2Body* body : bodies_) {
    if (body->GetType() == b2_dynamicBody) take(static_cast<double>(body->GetPosition().y));
  }
  return range;
}

}  // namespace any_scene
