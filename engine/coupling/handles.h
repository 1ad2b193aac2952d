#pragma once

#include <box2d/b2_fixture.h>

#include <cstdint>
#include <optional>
#include <span>

#include "ribbon/box.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/cord.h"
#include "ribbon/definition.h"
#include "ribbon/smooth_line.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/vec2.h"

namespace ribbon::box2d {

struct CouplingParts;

/// A cord of a coupling, for reading: a small handle to copy and pass by value. It stays usable while other cords are
/// added and removed and while the coupling is moved. Do not use it after the coupling is destroyed or another one is
/// assigned to it. Spans and references are valid until the next step, replace or remove, unless a function says
/// otherwise. All functions except `id` and `is_valid` throw CallError if the cord has been removed or cut.
class CordView {
 public:
  /// Returns the handle of a cord; Coupling::cord calls this.
  CordView(const CouplingParts& parts, CordId id) : parts_(&parts), id_(id) {}

  CordId id() const { return id_; }  ///< of the cord
  /// Returns whether the cord exists: it has been added, and neither removed nor cut.
  bool is_valid() const;
  Solver solver() const;    ///< the solver of the cord
  CordShape shape() const;  ///< the layout of its points
  /// Returns the cord of the direct solver. Throws CallError for one of the thesis's solver. The reference is valid
  /// until the cord is removed or replaced.
  const Cord& direct() const;
  /// Returns the cord of the thesis's solver. Throws CallError for one of the direct solver.
  const ThesisCord& thesis() const;
  std::span<const Vec2> positions() const;  ///< m, by point
  /// Returns the positions with the rest lengths, for smooth_line and smooth_strip.
  PointGrid grid() const;
  /// Returns what determines the motion of a point. Throws DefinitionError for an unknown point.
  PointKind kind(int point) const;
  /// Returns the position of the place between a point and the one in the next column, m. Throws DefinitionError for a
  /// point that the cord does not have and unless `along` is 0 … 1.
  Vec2 position(int point, double along = 0.0) const;
  /// Returns the rest length from the first column to that place, m; 0 for the thesis's solver. Throws likewise.
  double arc(int point, double along = 0.0) const;
  bool is_enabled() const;                         ///< initially true
  const b2Filter& filter() const;                  ///< the filter that Coupling::add or replace set
  std::uintptr_t user_data() const;                ///< initially 0
  std::span<const FixtureTouch> touching() const;  ///< contacts in the last step, by fixture number; direct solver only
  /// Returns the numbers of the sensors that the cord overlapped in the last step, ascending; see
  /// StepView::sensor_events and Coupling::fixture.
  std::span<const std::uint64_t> sensors() const;
  /// Returns the fixtures, but not the sensors, that the last gather found near the cord. Valid until the next gather,
  /// or the destruction of one of the fixtures.
  std::span<const NearShape> near() const;
  /// Returns the number of circles and edges that the cord could have touched in the last tick.
  int near_count() const;
  /// Returns the box [m] in which the last gather searched for fixtures; empty if the cord was disabled.
  Box swept_aabb() const;

  // Of cords of the direct solver; default values for the others:
  /// Returns what the last step did to the cord. All values are 0 if there was none since the cord was added, replaced,
  /// disabled or restored. While the cord sleeps it counts no contacts.
  const CordReport& report() const;
  /// Returns the report of the last step of the island that the cord belongs to.
  const IslandReport& island_report() const;
  /// Returns the sum of these reports since the cord was added.
  const IslandReport& island_total() const;
  /// Returns the estimated error [m] that the last tick alone added: the largest one of a point. It is the time
  /// integration error of a tick that begins with exact values. 0 if errors are not estimated.
  double error() const;
  // Of cords of the thesis's solver; default values for the others:
  const StepReport& thesis_report() const;  ///< of the last step
  const StepReport& thesis_total() const;   ///< the sum since the cord was added

 private:
  const CouplingParts* parts_;
  CordId id_;
};

/// A cord of a coupling, for reading and writing. Change cords between ticks.
class CordRef : public CordView {
 public:
  /// Returns the handle of a cord; Coupling::cord calls this.
  CordRef(CouplingParts& parts, CordId id) : CordView(parts, id), parts_(&parts) {}

  Cord& direct() const;        ///< see CordView
  ThesisCord& thesis() const;  ///< see CordView
  /// Drags a point to `target` [m] in the next tick. Call it in each tick while dragging. Throws DefinitionError for an
  /// unknown point and for a coordinate beyond ±1e9, and CallError for a point on the wheel of a pulley.
  void drag(int point, Vec2 target) const;
  /// Pins a point to `target` [m]. The point moves there in the next tick and then stays. Throws as `drag` does.
  void pin(int point, Vec2 target) const;
  /// Frees a dragged or pinned point, which keeps its velocity. Throws DefinitionError for an unknown point.
  void free(int point) const;
  /// Enables or disables the cord, like b2Body::SetEnabled. A disabled cord does not move, costs nothing, touches
  /// nothing and is not found by queries. Bodies that held it release it, and its contacts end in the next step.
  void set_enabled(bool enabled) const;
  /// Cuts a cord of the direct solver at `arc` [m of rest length from its first point]: at the nearest column of
  /// points, across a ribbon. The cord is gone, and its pieces are new cords with its filter and user data. Pins,
  /// loads, attached masses, grips, reels and contacts go to the side that they are on; see ribbon::cut. What
  /// is less than half a link is dust: it is gone, with the pins, loads, grips and ties that it had, and the cord has
  /// one piece. So a cut close to a pin frees the end. The contacts of the cord end in the next step, and those of its
  /// pieces begin. Call it between ticks. O(points). Throws CallError, and changes nothing, for a cord that does not
  /// exist, is disabled or of the thesis's solver, inside world.Step and between gather and apply; DefinitionError
  /// unless 0 < arc < length.
  CutEvent cut(double arc) const;
  /// Cuts a ribbon of the direct solver along a row of points, 1 … rows − 2, over its whole length. The row becomes an
  /// edge of both pieces, which have the rows up to it and from it on, and their parts of mass and stiffness; see
  /// ribbon::cut. What is attached to the row itself stays with the first piece, but a pin in it holds both. The pieces
  /// never touch each other. Otherwise as `cut`. Throws as `cut` does, CallError also for a cord of less than three
  /// rows, and DefinitionError for another row.
  CutEvent cut_along(int row) const;
  /// Stores a number of yours, such as an index or a pointer. Coupling::restore does not change it, but gives it back
  /// to a cord that it adds again.
  void set_user_data(std::uintptr_t data) const;
  /// Replaces a cord of the direct solver by one without pulleys, and enables it. The id and the user data stay. Bodies
  /// that held the old cord release it, and its reports are reset. What touched the old cord and does not touch the new
  /// one gets an end event in the next step. Throws CallError, and changes nothing, for a cord of the thesis's solver
  /// or with pulleys.
  void replace(Cord cord, const b2Filter& filter = {}) const;

 private:
  CouplingParts* parts_;
};

/// A grip of a coupling, for reading: a small handle like CordView. A grip ends when it is released, when it gives way
/// (GripDef::lets_go), when its cord is removed, replaced or disabled, and when its body is gone. Then all functions
/// except `id`, `is_valid` and GripRef::release throw CallError.
class GripView {
 public:
  /// Returns the handle of a grip; Coupling::grip calls this.
  GripView(const CouplingParts& parts, GripId id) : parts_(&parts), id_(id) {}

  GripId id() const { return id_; }  ///< of the grip
  /// Returns whether the grip exists.
  bool is_valid() const;
  /// Returns the state of the grip.
  GripState state() const;

 private:
  const CouplingParts* parts_;
  GripId id_;
};

/// A grip of a coupling, for reading and writing.
class GripRef : public GripView {
 public:
  /// Returns the handle of a grip; Coupling::grip calls this.
  GripRef(CouplingParts& parts, GripId id) : GripView(parts, id), parts_(&parts) {}

  /// Moves the grip along a cord of the direct solver to `arc` [m of rest length from its start] at `speed` [m of rest
  /// length per second, above 0], so that the body climbs. It goes on in each tick until it is there; another call
  /// replaces the goal. Throws DefinitionError for values out of range, and CallError for the thesis's solver.
  void climb(double arc, double speed) const;
  /// Moves the anchor to a place in the body's frame, at constant velocity during the next tick, where it stays. Call
  /// it before gather. Throws DefinitionError for a coordinate beyond ±1e9.
  void move_anchor(b2Vec2 local_anchor) const;
  /// Releases the cord. Returns false if the grip did not exist. Its body may be destroyed already. O(bodies).
  bool release() const;

 private:
  CouplingParts* parts_;
};

/// A tie of a coupling, for reading: a small handle like CordView. Once the tie has ended, `state` throws CallError.
class TieView {
 public:
  /// Returns the handle of a tie; Coupling::tie calls this.
  TieView(const CouplingParts& parts, TieId id) : parts_(&parts), id_(id) {}

  TieId id() const { return id_; }  ///< of the tie
  bool is_valid() const;            ///< whether the tie exists
  TieState state() const;           ///< its state; O(grips of both cords)

 private:
  const CouplingParts* parts_;
  TieId id_;
};

/// A pulley of a coupling, for reading: a small handle like CordView. Coupling::add_pulley says when a pulley ends.
/// Then `state` throws CallError.
class PulleyView {
 public:
  /// Returns the handle of a pulley; Coupling::pulley calls this.
  PulleyView(const CouplingParts& parts, PulleyId id) : parts_(&parts), id_(id) {}

  PulleyId id() const { return id_; }  ///< of the pulley
  bool is_valid() const;               ///< whether the pulley exists
  PulleyState state() const;           ///< its state between ticks; O(bodies), O(1) with Coupling::trust_forget

 private:
  const CouplingParts* parts_;
  PulleyId id_;
};

/// A pulley of a coupling, for reading and writing.
class PulleyRef : public PulleyView {
 public:
  /// Returns the handle of a pulley; Coupling::pulley calls this.
  PulleyRef(CouplingParts& parts, PulleyId id) : PulleyView(parts, id), parts_(&parts) {}

  /// Sets the speed [rad/s, counterclockwise, −1e6 … 1e6] and the largest torque [N·m, 0 … infinity] of the motor of
  /// the wheel; see PulleyDef. Throws DefinitionError for a value out of range.
  void set_motor(double speed, double torque) const;
  /// Takes the cord off the wheel. Returns false if the pulley did not exist. Its body may be destroyed already. Throws
  /// CallError inside world.Step and between gather and apply.
  bool remove() const;

 private:
  CouplingParts* parts_;
};

/// A tie of a coupling, for reading and writing.
class TieRef : public TieView {
 public:
  /// Returns the handle of a tie; Coupling::tie calls this.
  TieRef(CouplingParts& parts, TieId id) : TieView(parts, id), parts_(&parts) {}

  /// Ends the tie. The cords keep their velocities. Returns false if it had ended. Throws CallError inside world.Step
  /// and between gather and apply.
  bool untie() const;

 private:
  CouplingParts* parts_;
};

/// What the last step of a coupling did, for reading: a small handle like CordView. It always shows the newest step.
class StepView {
 public:
  /// Returns the handle of the last step; Coupling::last_step calls this.
  explicit StepView(const CouplingParts& parts) : parts_(&parts) {}

  /// Returns the sum of the reports of all islands of the direct solver in the last step.
  const IslandReport& report() const;
  /// Returns the number of islands of the direct solver in the last step.
  int islands() const;
  /// Returns the contacts of the direct solver that began or ended in the last step, ordered by cord. For each cord the
  /// ends come first; both are ordered by fixture number. Valid until the next step or restore.
  std::span<const TouchEvent> touch_events() const;
  /// Returns the overlaps of cords with sensors (b2FixtureDef::isSensor) that began or ended in the last step, each
  /// pair once, in the order of touch_events. As Box2D does for two fixtures, the step looks where cords and sensors
  /// are when it begins: what passes a sensor within one tick is not found. The sensor may belong to any body, also to
  /// one that holds the cord, and is neither moved nor woken, nor is the cord. An overlap ends too when the cord is
  /// removed, cut, disabled or replaced by one elsewhere, when the fixture or its body is destroyed or disabled or is
  /// no longer a sensor, when a filter excludes it, and when ContactListener::should_meet_sensor refuses it. The inside
  /// of a ribbon counts. Without a sensor near a cord it costs nothing. Valid until the next step or restore.
  std::span<const SensorEvent> sensor_events() const;
  /// Returns, in this order: the cuts that calls made between the last two steps, the breaks of links in the last step,
  /// and the cuts that calls made since. Valid until the next cut, step or restore.
  std::span<const CutEvent> cut_events() const;
  /// Returns whether errors are estimated; see Coupling::estimate_errors.
  bool estimates_errors() const;
  /// Returns the time for which the medium is asked at the start of the next tick: the time that ticks with a medium
  /// took so far, s. It is part of the state.
  double medium_time() const;

 private:
  const CouplingParts* parts_;
};

/// A body of Box2D as the coupling sees it, for reading: a small handle like CordView, also for bodies that no cord has
/// met. It must not outlive the body or the coupling.
class BodyView {
 public:
  /// Returns the handle of a body; Coupling::body calls this.
  BodyView(const CouplingParts& parts, const b2Body& body) : parts_(&parts), body_(&body) {}

  /// Returns the momentary velocity of the centre of mass, m/s. It differs from Box2D's for bodies that the solver
  /// moves; see Coupling. O(log bodies + contacts of the body).
  Vec2 velocity() const;
  double angular_velocity() const;  ///< rad/s, momentary
  /// Returns the first grip of the body, or nothing if it holds nothing.
  std::optional<GripId> first_grip() const;
  /// Returns the place that the first grip holds.
  std::optional<CordPoint> held_place() const;

 private:
  const CouplingParts* parts_;
  const b2Body* body_;
};

/// A body of Box2D as the coupling sees it, for reading and writing.
class BodyRef : public BodyView {
 public:
  /// Returns the handle of a body; Coupling::body calls this.
  BodyRef(CouplingParts& parts, b2Body& body) : BodyView(parts, body), parts_(&parts), body_(&body) {}

  /// Releases all grips of the body. Body and cords keep their velocities. Returns false if the body held nothing.
  bool release() const;

 private:
  CouplingParts* parts_;
  b2Body* body_;
};

}  // namespace ribbon::box2d
