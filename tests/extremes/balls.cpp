#include "tests/extremes/balls.h"

#include <algorithm>

namespace extremes {

using ribbon::RigidBody;
using ribbon::Vec2;

int Balls::add(Vec2 position, double radius, double mass, double friction) {
  RigidBody body;
  body.position = position;
  if (mass > 0.0) {
    body.inverse_mass = 1.0 / mass;
    body.inverse_inertia = 2.0 / (mass * radius * radius);
  }
  const auto index = static_cast<int>(bodies_.size());
  bodies_.push_back(body);
  circles_.push_back({index, {}, radius, friction, 0.0, static_cast<std::uint64_t>(index) + 1});
  return index;
}

void Balls::step(TestedCord& cord, double dt, Vec2 gravity) {
  for (RigidBody& body : bodies_) {
    body.impulse = {};
    body.angular_impulse = 0.0;
    body.solved = false;
  }
  cord.step(dt, gravity, {bodies_, circles_});
  for (RigidBody& body : bodies_) {
    body.velocity += body.inverse_mass * body.impulse;
    body.angular_velocity += body.inverse_inertia * body.angular_impulse;
    body.position += body.solved ? body.moved : dt * body.velocity;
  }
}

bool Balls::is_finite() const {
  return std::all_of(bodies_.begin(), bodies_.end(), [](const RigidBody& body) {
    return ribbon::is_finite(body.position) && ribbon::is_finite(body.velocity);
  });
}

}  // namespace extremes
