#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "ribbon/vec2.h"

namespace ribbon {

/// A rigid body that circles belong to, as it is at the start of a step. A step reads it, adds to the impulses, and
/// says how it saw a body move that holds it; the body's owner applies the impulses and moves it.
struct RigidBody {
  Vec2 position;                  ///< m, centre of mass
  Vec2 velocity;                  ///< m/s, of the centre of mass
  double angular_velocity = 0.0;  ///< rad/s
  double inverse_mass = 0.0;      ///< 1/kg; 0 for a body that nothing pushes (static or kinematic)
  double inverse_inertia = 0.0;   ///< 1/(kg·m²), about the centre of mass; 0 for one that does not turn
  Vec2 acceleration;              ///< m/s², free motion, usually gravity
  Vec2 impulse;                   ///< N·s, what cords have given to the body, summed up
  double angular_impulse = 0.0;   ///< N·m·s, the same about the centre of mass
  Vec2 moved;                     ///< m, in the step of the cord that it holds; of no meaning for other bodies
  double turned = 0.0;            ///< rad, in the same step
  bool met = false;               ///< the direct solver has moved it with a cord
  // Of the direct solver's cords that are allowed to sleep, for one that can be pushed:
  bool awake = true;       ///< not put to sleep by its owner, who says so at once when somebody wakes it
  bool may_sleep = false;  ///< its owner puts it to sleep when a step says that it rests
  bool rests = false;      ///< a cord near it, or held by it, was asleep in the step
};

/// A circle fixed to a body.
struct RigidCircle {
  int body = 0;         ///< index into the step's bodies
  Vec2 offset;          ///< m, from the body's centre of mass to the circle's centre, world directions
  double radius = 0.0;  ///< m, above 0
  // Of the direct solver's contact:
  double friction = 0.0;     ///< of its surface, 0 … 10
  double restitution = 0.0;  ///< 0 … 1
  std::uint64_t id = 0;      ///< the same from step to step, so that what touches it is remembered
};

/// A straight edge fixed to a body, without its ends: give those as circles of the same radius.
struct RigidSegment {
  int body = 0;              ///< index into the step's bodies
  Vec2 a;                    ///< m, from the body's centre of mass, world directions
  Vec2 b;                    ///< m
  double radius = 0.0;       ///< m, 0 or more
  double friction = 0.0;     ///< of its surface, 0 … 10
  double restitution = 0.0;  ///< 0 … 1
  std::uint64_t id = 0;      ///< as a circle's; no circle has the same
};

/// A body that holds a cord at a point, or between two.
struct Grip {
  int point = 0;  ///< index of the cord's point
  int body = 0;   ///< index into the step's bodies
  Vec2 offset;    ///< m, from the body's centre of mass to the hand, world directions
  Vec2 travel{};  ///< m, how far the hand moves on the body during the step, evenly
  // Of the direct solver only:
  double along = 0.0;  ///< share of the way to the next column's point, 0 … 1; 0 at the last column
  double climb = 0.0;  ///< columns, by which the grip moves along the cord in the step, evenly
  /// N, along the cord, above which it slips: of a body that is pushed.
  double strength = std::numeric_limits<double>::infinity();
};

/// What a cord meets in one step.
struct Surroundings {
  std::span<RigidBody> bodies = {};             ///< that the others refer to by index; they get their impulses
  std::span<const RigidCircle> circles = {};    ///< that it may touch
  std::span<const Grip> grips = {};             ///< of bodies that hold it
  std::span<const RigidSegment> segments = {};  ///< that it may touch; met by the direct solver only
};

/// Throw DefinitionError unless all numbers of the bodies of a step, and of what else a cord of so many points meets in
/// it, are in their ranges: lengths and velocities within ±1e10, accelerations within ±1e20, and every body and point
/// that something refers to there.
void check_bodies(std::span<const RigidBody> bodies);
/// See check_bodies. Of a cord of so many `rows`, which can be held between two points, no grip is beyond its last
/// column; of any other, with 0, it does not matter.
void check_met(const Surroundings& met, std::size_t bodies, int points, int rows = 0);

/// Throws DefinitionError unless a step can be taken: 1e-9 ≤ dt ≤ 1 [s], gravity [m/s²] within ±1e9.
void check_step(double dt, Vec2 gravity);

}  // namespace ribbon
