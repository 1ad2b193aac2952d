#pragma once

#include <box2d/b2_fixture.h>

#include "ribbon/box2d/coupling_types.h"

namespace ribbon::box2d {

/// The surface of a fixture towards a cord in one tick.
struct Surface {
  double friction = 0.0;     ///< coefficient μ of the fixture, 0 … 10; the cord's own is combined with it as usual
  double restitution = 0.0;  ///< coefficient, 0 … 1; the same
};

/// Interface by which a game decides about contacts of cords; see Coupling::listen.
class ContactListener {
 public:
  ContactListener() = default;
  ContactListener(const ContactListener&) = delete;
  ContactListener& operator=(const ContactListener&) = delete;
  virtual ~ContactListener() = default;

  /// Called once in each gather for each enabled cord and each fixture near it that its filter accepts, by cord and
  /// number of the fixture. Returns whether they collide in this tick. It may change the surface, which is initially
  /// the fixture's; cords of the thesis's solver have no friction and no restitution. For a one-way platform, return
  /// false while the cord is below it. Do not change the world or the cords.
  virtual bool pre_solve(CordId cord, const b2Fixture& fixture, Surface& surface) = 0;
};

}  // namespace ribbon::box2d
