#pragma once

#include "ribbon/rigid_circle.h"

namespace test_support {

/// Moves a body by what a step of dt [s] wrote to it, or freely if no cord was solved with it. Returns its turn, rad.
inline double move_body(ribbon::RigidBody& body, double dt) {
  if (body.solved) {
    body.position += body.moved;
    body.velocity += dt * body.acceleration + body.inverse_mass * body.impulse;
    body.angular_velocity += body.inverse_inertia * body.angular_impulse;
    return body.turned;
  }
  const double turned = dt * body.angular_velocity;
  if (body.inverse_mass > 0.0) body.velocity += dt * body.acceleration;
  body.position += dt * body.velocity;
  return turned;
}

}  // namespace test_support
