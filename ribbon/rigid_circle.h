#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "ribbon/pulley.h"
#include "ribbon/vec2.h"

namespace ribbon {

class Medium;

/// A rigid body at the start of a step. The step reads its state and adds to its impulses. For a body that holds a cord
/// it also writes the displacement. The owner of the body applies the impulses and moves the body.
struct RigidBody {
  Vec2 position;                  ///< m, centre of mass
  Vec2 velocity;                  ///< m/s, of the centre of mass
  double angular_velocity = 0.0;  ///< rad/s
  double inverse_mass = 0.0;      ///< 1/kg; 0 for a static or kinematic body
  double inverse_inertia = 0.0;   ///< 1/(kg·m²), about the centre of mass; 0 if the body cannot rotate
  Vec2 acceleration;              ///< m/s², of free motion, usually gravity
  /// m, displacement since the last step that its solve did not expect, because something else pushed the body: the
  /// step moves the body from where it was expected, so that cords between are pushed and not passed. It gives neither
  /// of them a velocity. Of dynamic bodies that hold no cord; 0 of others.
  Vec2 pushed;
  double pushed_turn = 0.0;      ///< rad, the same of its rotation
  Vec2 impulse;                  ///< N·s, sum of the impulses from cords
  double angular_impulse = 0.0;  ///< N·m·s, sum of the angular impulses about the centre of mass
  Vec2 moved;                    ///< m, displacement in the step, of a body that holds a cord; undefined for others
  double turned = 0.0;           ///< rad, rotation in the same step
  bool solved = false;           ///< the direct solver has solved its motion with a cord
  Vec2 support_force;            ///< N, out: of its supports at the end of the step
  double support_torque = 0.0;   ///< N·m, out: of these forces about the centre of mass
  // For dynamic bodies near cords that are allowed to sleep:
  bool awake = true;       ///< in: the body is awake
  bool may_sleep = false;  ///< in: the owner puts the body to sleep when a step sets `rests`
  bool rests = false;      ///< out: a cord that it holds or is near to slept during the step

  /// Returns whether something else has pushed it.
  bool was_pushed() const { return !(pushed == Vec2{} && pushed_turn == 0.0); }
  /// Returns where the step begins, m.
  Vec2 start() const { return position - pushed; }
  /// Returns where a point of the body is then, m; `arm` is the vector from the centre of mass to it at `position`.
  Vec2 start_of(Vec2 arm) const;
};

/// A circle that is fixed to a body.
struct RigidCircle {
  int body = 0;         ///< index into the bodies of the step
  Vec2 offset;          ///< m, from the centre of mass to the circle's centre, in world directions
  double radius = 0.0;  ///< m, above 0
  // Used by the direct solver:
  double friction = 0.0;     ///< coefficient μ, 0 … 10
  double restitution = 0.0;  ///< coefficient, 0 … 1
  std::uint64_t id = 0;      ///< identifies the circle from step to step
  /// m/s, speed of its surface, as of a conveyor belt: clockwise around the body, so to the right where it faces up.
  double tangent_speed = 0.0;
};

/// A straight edge that is fixed to a body. Its two end points are not part of it: add them as circles of the same
/// radius.
struct RigidSegment {
  int body = 0;                ///< index into the bodies of the step
  Vec2 a;                      ///< m, one end, from the centre of mass, in world directions
  Vec2 b;                      ///< m, the other end, likewise
  double radius = 0.0;         ///< m, half its thickness, 0 or more
  double friction = 0.0;       ///< coefficient μ, 0 … 10
  double restitution = 0.0;    ///< coefficient, 0 … 1
  std::uint64_t id = 0;        ///< identifies the edge from step to step; differs from the ids of circles
  double tangent_speed = 0.0;  ///< m/s, as of a circle; on both sides of the edge clockwise around it
};

/// A body that holds a cord at a point or between two points.
struct Grip {
  int point = 0;  ///< index of the held point
  int body = 0;   ///< index into the bodies of the step
  Vec2 offset;    ///< m, from the centre of mass to the body's anchor, in world directions
  Vec2 travel{};  ///< m, displacement of the anchor relative to the body during the step, at constant velocity
  // Used by the direct solver:
  double along = 0.0;  ///< position between `point` and the point of the next column, 0 … 1; 0 at the last column
  double climb = 0.0;  ///< columns, displacement of the grip along the cord during the step, at constant velocity
  /// N, force along the cord above which the grip slips.
  double strength = std::numeric_limits<double>::infinity();
  bool returns =
      false;  ///< the anchor was pushed off the cord and is drawn back; this does not count as work of a drive
  /// Direction in which a slipping grip is held, a unit vector, while its anchor passes a point of the cord. Zero, the
  /// default, means perpendicular to the link.
  Vec2 across{};
  /// m, from the anchor that the step draws the cord to, to the body's own, which is beside the cord and to which later
  /// steps draw it; in world directions.
  Vec2 beside{};
  /// A bend catches it: it does not slip, unless the rope runs through it as through a ring.
  bool caught = false;
};

/// A place where something keeps a body that holds or touches a cord from moving: the ground, or another body that
/// presses it against the cord. The direct solver lets the place move away, and towards the support no further than the
/// gap. Without it, a body that is lighter than what hangs or lies on it would be drawn or pressed through the ground
/// in the step. Friction there is for the owner of the body.
struct Support {
  int body = 0;        ///< index into the bodies of the step: the one that is supported
  Vec2 arm;            ///< m, from its centre of mass to the place, in world directions
  Vec2 normal;         ///< unit vector from the support to the body
  double gap = 0.0;    ///< m, 0 or more, from where a push has left the place to the support
  double speed = 0.0;  ///< m/s, of the support along the normal; that of `other` does not count
  int other = -1;      ///< index of the body that supports it and gives way itself; −1 for what does not give way
  Vec2 other_arm{};    ///< m, from the centre of mass of `other` to the place, in world directions
  bool operator==(const Support&) const = default;
};

/// The surroundings of a cord in one step.
struct Surroundings {
  std::span<RigidBody> bodies = {};             ///< bodies that the others refer to; the step adds to their impulses
  std::span<const RigidCircle> circles = {};    ///< circles that the cord may touch
  std::span<const Grip> grips = {};             ///< grips of bodies that hold the cord
  std::span<const RigidSegment> segments = {};  ///< edges that the cord may touch; the thesis's solver ignores them
  std::span<const Axle> axles = {};             ///< of its pulleys, in their order
  /// What flows around the cord; null for none. It must outlive the step. The thesis's solver refuses it.
  const Medium* medium = nullptr;
  double time = 0.0;  ///< s, for the medium: at the start of the step, within ±1e12
  /// Of bodies that hold the cord, carry its wheels or may touch it; the thesis's solver ignores them. A support that
  /// several cords have counts once.
  std::span<const Support> supports = {};
};

/// Throws DefinitionError unless all values of the bodies are in range: lengths and velocities within ±1e10,
/// accelerations within ±1e20.
void check_bodies(std::span<const RigidBody> bodies);
/// Throws DefinitionError unless all values of the surroundings are in range, as above, and refer to one of `bodies`
/// bodies and one of `points` points. With `rows` above 0, a grip between two columns must not be at the last column.
void check_surroundings(const Surroundings& surroundings, std::size_t bodies, int points, int rows = 0);

/// Throws DefinitionError unless 1e-9 ≤ dt ≤ 1 [s] and both components of gravity [m/s²] are within ±1e9.
void check_step(double dt, Vec2 gravity);

}  // namespace ribbon
