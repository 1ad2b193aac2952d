#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/stage.h"
#include "ribbon/linear/block_ldlt.h"
#include "ribbon/linear/disjoint_sets.h"
#include "ribbon/linear/index.h"
#include "ribbon/reports.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/system/cord_parts.h"
#include "ribbon/system/held_body.h"
#include "ribbon/system/tie_groups.h"

namespace ribbon {

/// A cord of an island, and where its points, tensions and grips are among those of the island.
struct Member {
  CordParts* cord = nullptr;
  Surroundings surroundings;
  std::uint64_t id = 0;  ///< identifies the cord from step to step
  std::size_t first_point = 0;
  std::size_t points = 0;
  std::size_t first_tension = 0;
  std::size_t tensions = 0;
  std::size_t first_dual = 0;  ///< of the tensions that are unknowns of the linear system
  std::size_t first_grip = 0;
  std::size_t end_grip = 0;
  std::size_t first_wheel = 0;
  std::size_t end_wheel = 0;
  CordReport report;             ///< of the step; see Island::end_step
  double last_correction = 0.0;  ///< m, the largest of its points by the last linear solve of a linearised stage
  bool stopped = false;          ///< that stage stopped it to prevent penetration
  bool in_medium = false;        ///< a medium acts on it
  double pressing_mass = 0.0;  ///< kg: cord, its bodies and the heaviest body near it; sets the stiffness of contacts;
                               ///< 0 where there can be none
  double start_strain = 0.0;   ///< largest of its links at the start of the step; 0 unless the island has ties

  std::size_t end_point() const { return first_point + points; }
  bool has_point(std::size_t slot) const { return slot >= first_point && slot < end_point(); }
  /// Returns whether it may touch anything in the step.
  bool may_touch() const {
    return !surroundings.circles.empty() || !surroundings.segments.empty() || cord->def.self_contact ||
           cord->def.cord_contact;
  }
};

/// A body that is solved with the cords.
struct SolvedBody {
  int index;   ///< into the step's bodies
  bool turns;  ///< its moment of inertia is finite
};

/// The wheel of a pulley; see system/wheels.h.
struct Wheel {
  std::size_t member = 0;
  std::size_t pulley = 0;        ///< index into the pulleys of the cord
  std::size_t before = 0;        ///< slot of the last point before the wheel
  std::size_t after = 0;         ///< slot of the first point behind it
  std::size_t solved_index = 0;  ///< index of its body among those that are solved with the cords
  Vec2 arm;                      ///< m, from the body's centre of mass to the axle, at the start of the step
  double radius = 0.0;           ///< m
  double sense = 1.0;            ///< 1 if the cord runs counterclockwise around it, −1 if clockwise
  double lead = 0.0;             ///< m, length at rest from the point before to the wheel, at the start of the step
  double trail = 0.0;            ///< m, from the wheel to the point behind it
  Vec2 arrival;                  ///< unit vector from the centre to where the cord arrives, at the start of the step
  Vec2 departure;                ///< to where it leaves
  double cord_mass = 0.0;        ///< kg, of the points on the wheel
  double wheel_mass = 0.0;       ///< kg, moment of inertia by the square of the radius
  double torque_force = 0.0;     ///< N, of the motor along the cord
  double weight = 0.0;           ///< N, of the points on the wheel, along the cord
  double gravity = 0.0;          ///< N, of them along the cord, at the start of the step
  Vec2 load;               ///< N, on the axle, beside the tensions and what the mass of the cord has as the body's
  double slip_sign = 0.0;  ///< sign of the friction on the cord along it while it slips; 0 while it does not
  double ratio = 1.0;      ///< e^(μ·α), of the tensions while it slips
  bool driven = false;     ///< the motor holds its speed
  bool blocked = false;    ///< the cord is kept from running: it ends at the wheel, or is held or tied there
};

/// A body's support in a step; see system/supports.h.
struct BodySupport {
  /// Whether it pushed at the end of the last stage.
  enum class Push : unsigned char { unknown, no, yes };

  static constexpr auto none = static_cast<std::size_t>(-1);

  std::size_t solved_index = 0;  ///< index of the body among those that are solved with the cords
  std::size_t other = none;      ///< index there of the body that supports it; none for what does not give way
  Vec2 normal;                   ///< unit vector from the support to the body
  double lever = 0.0;            ///< m, arm × normal: displacement of the place along the normal by a turn of a rad
  double other_lever = 0.0;      ///< m, the same of `other`
  double start = 0.0;            ///< m, of the centre of mass along the normal, at the start of the step; from that of
                                 ///< `other`, if there is one
  double gap = 0.0;              ///< m, at the start of the step
  double speed = 0.0;            ///< m/s, of the support along the normal
  double push_speed = 0.0;       ///< m/s, along the normal, with which it goes along with a body that was pushed
  bool hits = false;             ///< the body gets nearer to it at the start of the step, or is not at it yet
  bool loaded = false;           ///< the linear system has it
  Push push = Push::unknown;
  Push start_push = Push::unknown;  ///< `push` at the start of the substep

  bool gives_way() const { return other != none; }
};

/// The supports of an island.
struct IslandSupports {
  std::vector<BodySupport> all;  ///< by body
  double stiffness = 0.0;        ///< N/m
  bool are_rows = false;         ///< they are limited rows, because contacts are linearised once
  bool changed = false;          ///< one began or ceased to push in the substep
  bool stage_begins = false;     ///< the next linear system is the first one of a stage

  bool any() const { return !all.empty(); }
  /// Returns whether something that does not give way is among them.
  bool any_from_outside() const {
    return std::any_of(all.begin(), all.end(), [](const BodySupport& support) { return !support.gives_way(); });
  }
};

/// What a step does with tied points that are apart.
enum class ApartTies { drawn, kept, released };

/// A gap between tied slots, which the step closes in part.
struct TieGap {
  TiedSlot of;
  Vec2 start;    ///< m, from the second slot to the first one
  Vec2 closing;  ///< m, by which the step reduces it
};

/// The points of an island that are tied to each other.
struct IslandTies {
  std::vector<TiedSlot> slots;      ///< all but the first of each group, ascending, with the first
  std::vector<TiedPoint> by_cord;   ///< all, ascending by cord and point; a group is its first slot
  std::vector<TieGap> gaps;         ///< of slots that are apart
  bool apart = false;               ///< a gap is kept or reduced in this step
  bool closing = false;             ///< a gap is reduced in this step
  DisjointSets connected;           ///< members that ties connect
  std::vector<TiedPoint> released;  ///< of a group: memory for the step

  bool any() const { return !slots.empty(); }
  /// Returns whether a slot is one of `slots`.
  bool is_tied(int slot) const;
};

/// The state at the start of a substep.
struct SubstepStart {
  double time = 0.0;  ///< s, since the step began
  double dt = 0.0;    ///< s
  std::vector<Vec2> positions;
  std::vector<Vec2> velocities;
  std::vector<double> tensions;
};

/// The cords and bodies of an island during a step, as arrays. The slots are the points of all cords and, behind them,
/// two for each body: its centre of mass [m], and (φ, 0) of the angle by which it has turned in the step [rad]. Behind
/// them is one for each wheel: (ρ, 0) of the cord that has run through its groove in the step [m]. The integrators
/// treat all slots alike.
struct IslandState {
  // Of the step:
  double dt = 0.0;  ///< s
  Vec2 gravity;     ///< m/s²
  std::span<RigidBody> rigid;
  Accuracy accuracy;           ///< of each field the most accurate value of all cords
  double tolerance = 0.0;      ///< m
  double min_tolerance = 0.0;  ///< m, 16 rounding errors of the largest coordinate

  // What is solved:
  std::vector<Member> members;
  std::vector<SolvedBody> bodies;
  std::vector<HeldBody> held;  ///< by member and point, ascending
  IslandTies ties;
  std::vector<Wheel> wheels;  ///< by member
  IslandSupports supports;
  std::size_t points = 0;  ///< of all cords
  std::size_t duals = 0;   ///< tensions that are unknowns of the linear system
  bool coupled = false;    ///< false: a single cord whose bodies hold one point each, which its own solver can solve
  bool driven = false;     ///< drives at several velocities, or reels, change the energy
  bool in_medium = false;  ///< a medium acts on a cord and changes the energy
  bool reeling = false;    ///< rest lengths change in the step
  bool overstretched = false;  ///< links of a cord regain their lengths, and no speed by it
  bool unlocking = false;      ///< inverted cells are turned back in this step
  bool turning_cells = false;  ///< … by Newton's method: what that gains is no failure, but is taken out of the motion
  bool turned_at_any_cost = false;  ///< … even if it gains more than is in the motion
  bool turning_gained = false;      ///< … which it has
  bool restart = false;             ///< the accelerations are out of date
  bool jolted = false;              ///< a cord that runs through a groove changes its speed at once
  bool keeps_unsolved = false;      ///< a part of a substep that is not solved is kept as it is
  bool touch_changed = false;       ///< a contact began or ended in the last substep
  bool taken_back = false;          ///< motion was taken back for more than stretched links: energy was gained
  double now = 0.0;                 ///< s, of the positions, since the step began
  Vec2 frame_velocity;  ///< m/s, of the inertial frame in which all that drives is at rest, so that it does no work

  // By slot:
  std::vector<Vec2> positions;
  std::vector<Vec2> velocities;
  std::vector<Vec2> accelerations;
  std::vector<Vec2> free_accelerations;  ///< m/s², of free motion: gravity, and RigidBody::acceleration
  std::vector<double> masses;
  std::vector<char> constrained;
  // Of constrained slots: where the step found them, and their constant velocity in it.
  std::vector<Vec2> drive_starts, drive_velocities;
  /// The parts of `velocities` that RigidBody::pushed makes, in the step alone. Empty if nothing was pushed.
  std::vector<Vec2> pushes;
  std::vector<Vec2> medium_forces;  ///< N, at the end of the last stage; undefined unless in_medium
  /// Tensions of all cords and, behind them, two for each wheel, before and behind it, and two for each grip: the
  /// components of its pull on the body [N].
  std::vector<double> tensions;
  SubstepStart start;  ///< of the current substep

  std::size_t center(std::size_t body) const { return points + 2 * body; }
  std::size_t angle(std::size_t body) const { return points + 2 * body + 1; }
  std::size_t groove(std::size_t wheel) const { return points + 2 * bodies.size() + wheel; }
  std::size_t groove_of(const Wheel& wheel) const { return groove(index_of(wheel)); }
  std::size_t index_of(const Wheel& wheel) const { return static_cast<std::size_t>(&wheel - wheels.data()); }
  /// Returns whether a slot holds one number: an angle, or what has run through a groove.
  bool is_scalar(std::size_t slot) const {
    return slot >= points && ((slot - points) % 2 == 1 || slot >= points + 2 * bodies.size());
  }
  /// Returns whether a slot holds a speed in m/s: all but angles.
  bool has_speed(std::size_t slot) const { return !is_scalar(slot) || slot >= points + 2 * bodies.size(); }
  std::size_t slots() const { return positions.size(); }
  /// The slots of unknown tensions follow those of points and bodies; those of grips follow them.
  int first_dual(const Member& member) const { return static_cast<int>(slots() + member.first_dual); }
  int grip_dual(std::size_t grip) const { return static_cast<int>(slots() + duals + grip); }
  int wheel_dual(std::size_t wheel) const { return static_cast<int>(slots() + duals + held.size() + wheel); }
  /// The number of unknowns of the linear system that are no slots.
  std::size_t all_duals() const { return duals + held.size() + wheels.size(); }
  /// Index into the tensions of the one before a wheel. That behind it follows.
  std::size_t wheel_tension(std::size_t wheel) const {
    return tensions.size() - 2 * held.size() - 2 * (wheels.size() - wheel);
  }
  const RigidBody& rigid_of(const SolvedBody& body) const { return rigid[at(body.index)]; }

  /// Return a cord's part of an array by slot or by tension.
  template <typename Array>
  static auto points_of(const Member& member, Array& by_slot) {
    return std::span(by_slot).subspan(member.first_point, member.points);
  }
  template <typename Array>
  static auto tensions_of(const Member& member, Array& by_tension) {
    return std::span(by_tension).subspan(member.first_tension, member.tensions);
  }
  /// Returns positions and velocities of a cord.
  Motion motion_of(const Member& member) { return {points_of(member, positions), points_of(member, velocities)}; }
  /// Returns a cord's part of a stage.
  static Stage stage_of(const Stage& all, const Member& member);

  /// Returns the index of a body among those that are solved with the cords. Adds it if it is new.
  std::size_t solved_body(int index);
  /// Moves a slot at a constant velocity [m/s] in the step.
  void drive(std::size_t slot, Vec2 velocity);
  /// Places tied points that are apart with the gap that they have `time` [s] after the start of the step.
  void place_gaps(double time);
  void resize(std::size_t slots, std::size_t tension_count);
  void begin_substep(double time, double substep_dt);
  void return_to_start();
  /// Adds `sign` times the damping part of the tensions. Call it with −1 before and with +1 after a change of
  /// velocities outside a stage.
  void add_damping(double sign);
  /// Sets the tensions of the cords to those of their shapes at rest. The pulls of grips are left.
  void find_tensions();
};

}  // namespace ribbon
