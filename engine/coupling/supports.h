#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "ribbon/rigid_circle.h"

namespace ribbon::box2d {

/// A support of a body.
struct FoundSupport {
  Support support;          ///< without the indices of bodies and their arms
  Vec2 place;               ///< m, in the world
  b2Body* other = nullptr;  ///< a dynamic body that supports it; null for what does not give way
};

/// Which supports of a body are looked for.
struct SupportSearch {
  double reach;                     ///< m, how near what it does not touch has to be; 0 for only what it touches
  std::vector<b2Fixture*>& memory;  ///< of the search
};

/// Appends the places where static and kinematic bodies keep a dynamic body from moving: where they touch it, and where
/// they are within reach. So do dynamic bodies that touch it, where they pushed one another in the last world.Step with
/// so much that the lighter one would move by 5 mm in a tick. Returns the speed [m/s] with which a cord may press it on
/// them before world.Step. With a higher one it would rebound, if a contact has restitution. Between several contacts,
/// Box2D's iterations would leave some of it and throw the body out. Otherwise it is infinite.
double append_supports(b2Body& body, const SupportSearch& search, std::vector<FoundSupport>& supports);

}  // namespace ribbon::box2d
