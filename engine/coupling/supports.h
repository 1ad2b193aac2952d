#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "ribbon/rigid_circle.h"

namespace ribbon::box2d {

/// Appends the places where static and kinematic bodies touch a dynamic body and keep it from moving. `index` is that
/// of the body in the step. Returns the speed [m/s] with which a cord may press it on them before world.Step. With a
/// higher one it would rebound, if a contact has restitution. Between several contacts, Box2D's iterations would leave
/// some of it and throw the body out. Otherwise it is infinite.
double append_supports(const b2Body& body, int index, std::vector<Support>& supports);

}  // namespace ribbon::box2d
