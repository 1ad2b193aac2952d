#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "ribbon/rigid_circle.h"

namespace ribbon::box2d {

/// Which supports of a body are looked for.
struct SupportSearch {
  int index;                        ///< of the body in the step
  double reach;                     ///< m, how near what it does not touch has to be; 0 for only what it touches
  std::vector<b2Fixture*>& memory;  ///< of the search
};

/// Appends the places where static and kinematic bodies keep a dynamic body from moving: where they touch it, and where
/// they are within reach. Returns the speed [m/s] with which a cord may press it on them before world.Step. With a
/// higher one it would rebound, if a contact has restitution. Between several contacts, Box2D's iterations would leave
/// some of it and throw the body out. Otherwise it is infinite.
double append_supports(b2Body& body, const SupportSearch& search, std::vector<Support>& supports);

}  // namespace ribbon::box2d
