#pragma once

#include <box2d/b2_fixture.h>

#include <span>

#include "ribbon/box2d/coupling_types.h"

namespace ribbon::box2d {

/// The surface of a fixture towards a cord in one tick.
struct Surface {
  double friction = 0.0;     ///< coefficient μ of the fixture, 0 … 10; the cord's own is combined with it as usual
  double restitution = 0.0;  ///< coefficient, 0 … 1; the same
  /// m/s, −1e4 … 1e4: speed of the surface along itself, as of a conveyor belt, clockwise around the body. So the top
  /// of a belt with a positive speed runs to the right, and its bottom to the left. Friction carries the cord with it.
  double tangent_speed = 0.0;
};

/// Interface by which a game decides which contacts of cords there are, and receives their impulses and events; see
/// Coupling::listen. In its functions, change neither the world nor the cords.
class ContactListener {
 public:
  ContactListener() = default;
  ContactListener(const ContactListener&) = delete;
  ContactListener& operator=(const ContactListener&) = delete;
  virtual ~ContactListener() = default;

  /// Called once in each gather for each enabled cord and each fixture near it that its filter accepts, by cord and
  /// number of the fixture; not for sensors. Returns whether they collide in this tick. It may change the surface,
  /// which is initially the fixture's, without a tangent speed; cords of the thesis's solver have no friction and no
  /// restitution. For a one-way platform, return false while the cord is below it.
  virtual bool pre_solve(CordId cord, const b2Fixture& fixture, Surface& surface) = 0;

  /// Called once in each step. Returns whether post_solve is to be called in it. False, the default, costs nothing.
  virtual bool wants_impulses() const { return false; }
  /// Called at the end of each step for each cord of the direct solver that was awake and each fixture that it touched
  /// in the step, by cord and number of the fixture. `touches` has their contact points, one or more. The sum of
  /// `impulse` over all cords is what the contacts gave to the body of the fixture.
  virtual void post_solve(CordId cord, const b2Fixture& fixture, std::span<const TouchImpulse> touches) {
    (void)cord;
    (void)fixture;
    (void)touches;
  }

  /// Called once in each step for each enabled cord and each sensor near it that its filter accepts, by cord and number
  /// of the sensor. Returns whether they may overlap in this tick; an overlap that it refuses ends. True by default.
  virtual bool should_meet_sensor(CordId cord, const b2Fixture& sensor) {
    (void)cord;
    (void)sensor;
    return true;
  }
  /// Called in each step for each of StepView::sensor_events, in their order.
  virtual void sensor_event(const SensorEvent& event) { (void)event; }
};

}  // namespace ribbon::box2d
