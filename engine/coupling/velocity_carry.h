#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <functional>
#include <vector>

#include "ribbon/box2d/body_finder.h"
#include "ribbon/box2d/body_identity.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/medium.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/vec2.h"

namespace ribbon::box2d {

/// Conditions of a tick.
struct StepConditions {
  Vec2 gravity;     ///< m/s²
  double dt = 0.0;  ///< s
  const Medium* medium = nullptr;
  double medium_time = 0.0;  ///< s, at the start of the tick
};

/// Returns whether a joint or a touching contact of Box2D may push a body.
bool meets_anything(const b2Body& body);

/// Moves bodies in Box2D the way the direct solver moved them, and carries the part of their velocity that Box2D cannot
/// represent from tick to tick.
///
/// In a tick of dt seconds the solver moves a body by Δx, along a curve, and gives it the velocity v⁺ at the end.
/// Box2D's world.Step(dt) moves a body by v·dt for one velocity v. So the body gets v = Δx/dt for the step, and the
/// difference
///
///     c = v⁺ − Δx/dt                                    (the carry; about a·dt/2)
///
/// is stored here. Before the next step of the solver, the body's velocity is v_Box2D + c. Two more things happen in
/// between, and both are read off the velocity that the body has after world.Step, compared with the one that it was
/// left with:
///
/// - The contacts, joints and forces of Box2D change it by Δv (contact_delta_v). A body that a contact stops must not
///   go on with the carry: c loses its component along Δv, as long as that does not make the body's energy rise by more
///   than the work of the contacts. A force that pushes in two successive ticks is also handed to the solver as an
///   acceleration, so that the cord expects it. An impact is not: it is told by the velocity that it changed.
/// - The user may change it, by ApplyLinearImpulse or SetLinearVelocity, after the step (external_delta_v). Such a
///   change leaves c as it is. It shows as a difference between the velocity and the displacement over dt, which
///   world.Step keeps equal.
///
/// Box2D adds a·dt to a velocity and divides it by 1 + dt·damping; the velocity for the step allows for both.
class VelocityCarry {
 public:
  /// Returns whether there is a carry for a body that is not this one but had its address.
  bool has_predecessor(const b2Body& body) const;
  /// Completes the solver's view of a body before a step: adds the carry to its velocities, the push that it expects to
  /// its acceleration, and to its position what single precision rounded off. It may be repeated until begin_step.
  void complete(const b2Body& body, RigidBody& rigid, double dt);
  /// What a support pushes in the step, along its normal, is no part of the push that a body expects: takes it out of
  /// its acceleration. The body was completed.
  void leave_to_support(const b2Body& body, RigidBody& rigid, Vec2 normal, double dt);
  /// Finds by how much a body is elsewhere than the last step expected it: Box2D has pushed it, or the game has set it
  /// there. What is less than 5 mm and 0.015 rad, or more than 0.2 m or 0.5 rad, does not count, and neither does a
  /// body that world.Step has not moved. A body that was pushed does not also expect a push in that direction: takes it
  /// out of its acceleration. The body was completed.
  void find_push(const b2Body& body, RigidBody& rigid, double dt);
  /// Begins the step of the bodies that were completed: the pushes that were read then are now those of the last tick.
  void begin_step();
  /// Makes the next world.Step move a body as the solver did, and stores the carry. Its supports push it by `max_push`
  /// [m/s] at most.
  void drive(b2Body& body, const RigidBody& rigid, double max_push, const StepConditions& conditions);
  /// Adds the carry to the velocities of a body that the solver no longer moves, and forgets it.
  void release(b2Body& body);
  /// Releases all bodies of which `gathered` returns false. It gets the identity of a body.
  void release_unless(const std::function<bool(const SeenBody&)>& gathered, BodyFinder& finder);
  /// Puts a body to sleep in Box2D. Its carry is 0 from then on.
  void put_to_sleep(b2Body& body, double dt);
  /// Forgets what is stored for an address.
  void forget(const b2Body& body);
  /// Forgets all bodies.
  void clear() { bodies_.clear(); }

  /// Returns the momentary velocity of the centre of mass, m/s.
  Vec2 velocity(const b2Body& body) const;
  /// Returns the momentary angular velocity, rad/s.
  double angular_velocity(const b2Body& body) const;

  /// Returns what is stored for a body, or null.
  const CarryState* find(const b2Body& body) const { return entry(body); }
  /// Calls `visit` with the address of each body for which something is stored, in any order. The body may be gone.
  template <typename Visit>
  void visit_addresses(Visit visit) const {
    for (const Entry& entry : bodies_) visit(entry.body);
  }
  /// Stores a state that find returned.
  void restore(b2Body& body, const CarryState& state);

 private:
  struct Entry : CarryState {
    b2Body* body;
    SeenBody seen;
    bool left = false;       // not gathered in this tick
    bool completed = false;  // since begin_step; then this replaces the members of CarryState there:
    Vec2 next_contact_delta_v{};
    Vec2 next_expected_delta_v{};
  };

  std::vector<Entry>::const_iterator place(const b2Body& body) const;
  const Entry* entry(const b2Body& body) const;
  Entry* entry(const b2Body& body);
  Entry& entry_or_new(b2Body& body);

  std::vector<Entry> bodies_;  // by address, which is used for lookup only
};

}  // namespace ribbon::box2d
