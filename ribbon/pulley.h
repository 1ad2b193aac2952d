#pragma once

#include <limits>
#include <span>
#include <vector>

#include "ribbon/definition.h"
#include "ribbon/vec2.h"

namespace ribbon {

class Cord;

/// Defines a wheel with a groove that a rope runs around, as the wheel of a pulley or a drum. The cord never leaves the
/// groove: where it bends away from the wheel, a keeper holds it there, as the cheeks of a block do.
struct PulleyDef {
  Vec2 center{};                 ///< m, of the wheel
  double radius = 0.1;           ///< m, of the groove to the middle of the cord, 1e-6 … 1e6
  bool counterclockwise = true;  ///< the cord, from its first to its last point, runs counterclockwise around the wheel
  int turns =
      0;  ///< full turns of the cord around the wheel, 0 … 100, in addition to the arc from arrival to departure
  int before = 0;        ///< index of the last point before the wheel; see reeve
  int after = 1;         ///< index of the first point behind it
  double inertia = 0.0;  ///< kg·m², moment of inertia of the wheel about its axle, 0 … 1e12
  /// Coefficient μ of the groove, 0 … 10, or infinity, the default, if the cord does not slip. With an arc of contact α
  /// it slips where the larger tension exceeds e^(μ·α) times the smaller one.
  double friction = std::numeric_limits<double>::infinity();
  double motor_speed = 0.0;  ///< rad/s, counterclockwise, that a motor gives the wheel, −1e6 … 1e6
  /// N·m, the largest torque of the motor, 0 … infinity. At 0 the wheel turns freely. A motor at speed 0 is a brake.
  double motor_torque = 0.0;

  bool operator==(const PulleyDef&) const = default;
};

/// A pulley of a cord and its state.
struct Pulley {
  PulleyDef def;       ///< definition, with the centre at the start and the current points before and behind the wheel
  double lead = 0.0;   ///< m, rest length of the cord from the point `before` to the wheel
  double arc = 0.0;    ///< rad, angle of contact
  Vec2 arrival;        ///< unit vector from the centre to where the cord arrives
  Vec2 departure;      ///< unit vector from the centre to where the cord leaves
  double speed = 0.0;  ///< m/s, at which the cord runs through the groove
  double acceleration = 0.0;    ///< m/s², of the cord through the groove
  double angle = 0.0;           ///< rad, by which the wheel has turned, counterclockwise
  double turning = 0.0;         ///< rad/s, angular velocity of the wheel, counterclockwise
  double tension_before = 0.0;  ///< N, of the cord before the wheel
  double tension_after = 0.0;   ///< N, of the cord behind the wheel
  double slip_sign = 0.0;       ///< sign of the friction along the cord while it slips; 0 while it does not
  double blocked = 0.0;     ///< direction in which the cord cannot run, 1 or −1: it ends there, or something holds it
  bool kept = false;        ///< the cord bends away from the wheel, and a keeper at its groove holds it
  double motor_sign = 0.0;  ///< sign of the torque while the motor gives its largest; 0 while it keeps its speed

  bool operator==(const Pulley&) const = default;
};

/// The place of a body that carries the wheel of a pulley.
struct Axle {
  int body = 0;  ///< index into the bodies of the step
  Vec2 offset;   ///< m, from the centre of mass to the axle, in world directions
};

/// Throws DefinitionError for a value out of range. `points` is the number of points of the cord.
void check(const PulleyDef& def, int points);

/// A cord that is laid taut around wheels.
struct ReevedCord {
  double length = 0.0;             ///< m, of the cord
  std::vector<Vec2> positions;     ///< m, of its points
  std::vector<PulleyDef> pulleys;  ///< the wheels, with the points before and behind each
};

/// Lays a cord of this many points from `first` around the wheels, in their order, to `last` [m]: along common tangents
/// and arcs. Of each wheel it takes centre, radius, sense and turns, and finds the points before and behind it. Throws
/// DefinitionError for a value out of range, for wheels that overlap or hold an end, and unless two points lie between
/// neighbouring wheels and one between a wheel and an end.
ReevedCord reeve(Vec2 first, std::span<const PulleyDef> wheels, Vec2 last, int points);

/// Returns the pulleys of a cord, ordered along it. Valid until a pulley is added or removed, the cord is cut or
/// restored.
std::span<const Pulley> pulleys_of(const Cord& cord);
/// Lays a cord around a wheel. Each step then needs an axle for the wheel (Surroundings::axles). The points between
/// `before` and `after` are placed on the wheel. Returns the index of the pulley: pulleys are ordered along the cord. A
/// cord with a pulley does not sleep. Its part on the wheel is not stretched and touches nothing. Throws
/// DefinitionError for a value out of range, and unless the points `before` and `after` are where the cord runs past
/// the wheel: the path around the wheel from one to the other differs from the rest length between them by at most a
/// tenth. Throws CallError for a ribbon, for a cord with bending stiffness, and where a point is fixed or on another
/// wheel.
int add_pulley(Cord& cord, const PulleyDef& def);
/// Takes the cord off a wheel. Throws DefinitionError for an unknown pulley.
void remove_pulley(Cord& cord, int pulley);
/// Sets speed [rad/s, −1e6 … 1e6] and largest torque [N·m, 0 … infinity] of a motor. Throws DefinitionError for an
/// unknown pulley or a value out of range.
void set_motor(Cord& cord, int pulley, double speed, double torque);

}  // namespace ribbon
