#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/handles.h"
#include "ribbon/box2d/step_watcher.h"
#include "ribbon/cord.h"
#include "ribbon/medium.h"
#include "ribbon/parallel_for.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/vec2.h"

/// Cords in a Box2D world.
namespace ribbon::box2d {

/// Puts cords into a Box2D world. One tick is
///
///     coupling.tick(world, dt);
///
/// or its four parts, for a game that measures or watches them:
///
///     coupling.gather(world, dt);   // finds what holds the cords and what is near them
///     coupling.step();              // solves the cords together with these bodies
///     coupling.apply();             // gives the bodies their impulses
///     world.Step(dt, …);
///
/// **Momentum.** Cords and bodies together conserve linear momentum to double precision, except where a cord limits the
/// motion of a point; its report counts that. Box2D moves a body that touches a cord of the thesis's solver at the last
/// velocity of the tick, so after an impact the common centre of mass can be off its path by a millimetre or two.
///
/// **Velocities of bodies.** A body that holds a cord follows a curve during a tick. Box2D can only move it in a
/// straight line to the end of that curve, at the mean velocity. The coupling stores the difference between the
/// velocity at the end and the mean (half the acceleration times dt) and adds it in the next tick; without it, a
/// pendulum would lose a tenth of its energy in each period. So b2Body::GetLinearVelocity returns the mean velocity of
/// the last tick, and BodyView::velocity the momentary one. When the grip is released, the body gets the difference.
///
/// **Solvers.** Cords of both solvers can be in one coupling. Cords of the thesis's solver meet circles only. Cords of
/// the direct solver meet circles, edges, chains and polygons; they are solved together with all bodies that hold or
/// touch them, and with other cords that those bodies touch. So what the paragraph on velocities says holds for bodies
/// that only touch such a cord, too.
///
/// **Sleep.** A cord that is allowed to sleep falls asleep together with the bodies that hold or touch it
/// (b2Body::SetAwake), and it wakes when one of them wakes.
///
/// **Cost.** The cost of a tick depends on what is near the cords, because gather queries the broad phase of the world.
/// It walks through all bodies of the world only in these cases: a body holds a cord and destructions are not reported
/// (`trust_forget`); so many bodies are around the cords that separate queries would take longer; several bodies come
/// near in one tick for the first time; a body that a cord moved or touched in the last tick is no longer near.
///
/// **Destroyed bodies.** The coupling installs no listener. Bodies and fixtures may be created and destroyed between
/// ticks; the coupling never reads the memory of a destroyed one. Box2D can give the address of a destroyed
/// body or fixture to a new one. The coupling notices this, except in two cases: the destroyed object was the newest
/// one left in its world or body, or the object that was created just before it is gone too. In these cases destroy it
/// with `destroy`, or call `forget` first; otherwise the new object inherits grip, stored velocity and fixture number.
/// The world must outlive all calls except the destructor, until another world is gathered.
///
/// **Errors.** A value out of range throws DefinitionError. A wrong call throws CallError: one for a cord or grip that
/// does not exist, for a cord of the other solver (unless the function returns a default for it), inside world.Step, or
/// out of order. Either changes nothing.
class Coupling {
 public:
  Coupling();
  // A coupling that was moved from can only be destroyed or assigned to. Handles follow the cords to the new object.
  Coupling(Coupling&& other) noexcept;
  Coupling& operator=(Coupling&& other) noexcept;
  ~Coupling();

  /// Adds a cord of the direct solver. `filter` determines which fixtures it meets, of any shape and sensors too, as
  /// between two fixtures of Box2D. Cords meet each other by CordDef::cord_contact. Throws CallError for a cord with
  /// pulleys: add these with add_pulley.
  CordId add(Cord cord, const b2Filter& filter = {});
  /// Adds a cord of the thesis's solver. `filter` applies to circles.
  CordId add(ThesisCord cord, const b2Filter& filter = {});
  /// Removes a cord. Its id is not used again, except that `restore` goes back to the next id of the state. Bodies that
  /// held it release it, and its contacts end in the next step, with events that have its id. Throws CallError for an
  /// unknown cord.
  void remove(CordId cord);
  /// Reserves memory for `cords` pieces, 0 … 1e6, of ropes with up to `points` points, 2 … 1e6, so that cuts and breaks
  /// allocate none. Each cut uses up two pieces; call it again to have as many as before. The ticks after a cut
  /// allocate nothing either, unless more things come near each other than before, or a piece forms an island with more
  /// cords than any had before. Cuts of ribbons and of ropes with bending stiffness allocate memory all the same. Costs
  /// about 0.34 kB a point and 16 kB a cord. Throws DefinitionError for a value out of range.
  void reserve(int cords, int points);
  /// Cuts all enabled cords of the direct solver where they cross the segment between two points [m], as the path of a
  /// blade in a tick; a ribbon is cut across where its middle line does. A ribbon of three or more rows is instead cut
  /// along a row if the segment goes through all its columns, from one end to the other: along the inner row that is
  /// nearest on average. Returns the cuts; see CordRef::cut. A cord that crosses several times falls into several
  /// pieces, by a cut of a piece each time. Valid until the next cut or step. Throws DefinitionError for a coordinate
  /// beyond ±1e9, and CallError as CordRef::cut does.
  std::span<const CutEvent> cut(Vec2 from, Vec2 to);
  /// Returns the handle of a cord, existing or not.
  CordRef cord(CordId cord) { return {*parts_, cord}; }
  /// Returns the handle of a cord for reading.
  CordView cord(CordId cord) const { return {*parts_, cord}; }
  /// Returns the ids of all cords, ascending. Valid until a cord is added or removed.
  std::span<const CordId> cords() const;
  /// Returns the number of cords, enabled or not.
  int size() const { return static_cast<int>(cords().size()); }

  /// Makes a body hold a cord, in addition to the other grips of the body. Throws CallError if the cord is unknown or
  /// disabled, if the body already holds that place, and inside world.Step; for a cord of the thesis's solver also if
  /// the grip is not at a point or has a finite strength. Throws DefinitionError for a value out of range.
  GripId hold(b2Body& body, const GripDef& def);
  /// Makes a body hold a point of a cord of either solver at an anchor in the body's frame: a short form of the other
  /// `hold`. The anchor should be where the point is; a large force pulls a distant point to it over several ticks.
  /// Throws as the other `hold` does.
  GripId hold(CordId cord, int point, b2Body& body, b2Vec2 local_anchor);
  /// Returns the handle of a grip, existing or not.
  GripRef grip(GripId grip) { return {*parts_, grip}; }
  /// Returns the handle of a grip for reading.
  GripView grip(GripId grip) const { return {*parts_, grip}; }
  /// Ties a point of a cord to one of another cord: from the next tick on they move as one, with the velocity that
  /// keeps their momentum. Points that are apart are drawn together over several ticks, at up to 2 m/s; if the cords
  /// are too short for that, they keep their distance. The cords do not touch each other within three radii of a tie. A
  /// tie ends when it is untied, when it breaks, when a cut makes its end dust (see CordRef::cut), and when one of its
  /// cords is removed, replaced or disabled. Throws CallError, and changes nothing, for a cord that does not exist, is
  /// disabled or of the thesis's solver, for a tie of a cord to itself, directly or through others, or of points that
  /// are tied, inside world.Step and between gather and apply; DefinitionError for an unknown point and a breaking
  /// force that is not above 0.
  TieId tie(const TieDef& def);
  /// Returns the handle of a tie, existing or not.
  TieRef tie(TieId tie) { return {*parts_, tie}; }
  /// Returns the handle of a tie for reading.
  TieView tie(TieId tie) const { return {*parts_, tie}; }
  /// Lays a cord around a wheel that a body carries: a static or kinematic body, or a dynamic one such as the block of
  /// a tackle. The centre is where the wheel is now, and stays at that place of the body; see ribbon::add_pulley and
  /// reeve. The wheel is part of the pulley, not a body: its angle is in PulleyState. The cord touches nothing on the
  /// wheel. Add a circle fixture to the body there, so that what is pulled to the wheel stops at it; its radius is at
  /// most that of the groove less that of the cord. A pulley ends when it is removed, when a cut goes through the cord
  /// on its wheel, when its cord is removed, replaced or disabled, and when its body is gone or disabled. Throws
  /// CallError and DefinitionError as ribbon::add_pulley does, and CallError for a cord that does not exist, is
  /// disabled or of the thesis's solver, where a grip or a tie would be on the wheel, inside world.Step and between
  /// gather and apply.
  PulleyId add_pulley(CordId cord, b2Body& body, const PulleyDef& def);
  /// Returns the handle of a pulley, existing or not.
  PulleyRef pulley(PulleyId pulley) { return {*parts_, pulley}; }
  /// Returns the handle of a pulley for reading.
  PulleyView pulley(PulleyId pulley) const { return {*parts_, pulley}; }
  /// Returns the handle of a body: what it holds, and how it moves.
  BodyRef body(b2Body& body) { return {*parts_, body}; }
  /// Returns the handle of a body for reading.
  BodyView body(const b2Body& body) const { return {*parts_, body}; }

  /// Advances cords and world by one tick of dt seconds, instead of world.Step, which gets the other two arguments:
  /// gather, step, apply, world.Step. Throws as gather does, before anything has moved.
  void tick(b2World& world, double dt, int velocity_iterations = 8, int position_iterations = 3);
  /// First part of a tick of dt seconds: finds for each cord the fixtures that it may touch in the tick, and the
  /// sensors near it. Ignores disabled bodies, dynamic bodies without mass (not their sensors), and bodies whose
  /// position or velocity is not finite or beyond ±1e9 (m, m/s). A second call before step replaces the result of the
  /// first: the tick has the same bits as with one call. Throws CallError for a locked world and between step and
  /// apply; DefinitionError for a dt outside 1e-9 … 1 and gravity beyond ±1e9 m/s².
  void gather(b2World& world, double dt);
  /// Second part: advances the cords. Cords of the thesis's solver are advanced in the order of adding, and each feels
  /// bodies as the ones before it left them. Do not change the world between gather and apply. Throws CallError without
  /// a gather before it.
  void step();
  /// Third part: gives each dynamic body its impulse. The coupling keeps what single precision rounds off. Throws
  /// CallError without a step before it.
  void apply();
  /// Sets how gather and step run in parallel. The results have the same bits. It is not part of the state. Throws
  /// DefinitionError for less than one worker.
  void use(const ParallelFor& parallel_for);

  /// Returns the handle of what the last step did: its report and its events.
  StepView last_step() const { return StepView(*parts_); }
  /// Starts or stops to estimate the error of each tick of the cords of the direct solver; see ErrorProbe. An estimate
  /// costs as much as four ticks and does not change the motion.
  void estimate_errors(bool wanted);
  /// Sets an object whose functions are called before and after each step of the direct solver, or null for none. It
  /// must outlive the steps. It is not part of the state, and costs nothing if it is null.
  void watch(StepWatcher* watcher);
  /// Sets an object that decides which fixtures collide with which cords in a tick, and with what friction,
  /// restitution and tangent speed, and that gets the impulses; null for none. It must outlive the ticks. It is not
  /// part of the state, and costs nothing if it is null.
  void listen(ContactListener* listener);
  /// Sets the medium that flows around all cords of the direct solver, such as a Weather; null, the default, for none.
  /// It must outlive the ticks. It is not part of the state, but its time is (StepView::medium_time). It acts on cords
  /// that declare drag_across, drag_along or displaced_area, and not on bodies or cords of the thesis's solver. Costs
  /// nothing if it is null.
  void set_medium(const Medium* medium);
  /// The coupling numbers the fixtures that come near a cord; unlike an address, a number never comes to mean another
  /// fixture. Returns the one with a number from CordView::touching or CordView::sensors, or null if it was destroyed
  /// before the last gather or with `destroy`, or forgotten. If it may have been destroyed otherwise since then, use
  /// the next function.
  const b2Fixture* fixture(std::uint64_t number) const;
  /// Returns the fixture with that number if it is still in its world, else null. O(bodies + fixtures).
  const b2Fixture* fixture(std::uint64_t number, const b2World& world) const;

  /// Returns the nearest point of an enabled cord within `reach` [m] of `position`; of equally near ones the one of the
  /// lowest id and index. O(cords + points of those that may be in range); for many queries in a tick see CordQueries.
  /// Points on wheels of pulleys do not count, because nothing can hold or drag them.
  std::optional<CordPoint> nearest_point(Vec2 position, double reach) const;
  /// Returns the nearest place on an enabled cord that is not in `except`, also between two points; for cords of the
  /// thesis's solver, the nearest point. Places on wheels do not count.
  std::optional<CordPoint> nearest_place(Vec2 position, double reach, std::span<const CordId> except = {}) const;

  /// Releases what a body holds and destroys it. Use it for bodies that hold or touch cords. (Otherwise the next gather
  /// notices the destruction, with the exceptions named above.)
  void destroy(b2World& world, b2Body& body);
  /// Forgets a body that is about to be destroyed, with its grips and fixtures. Call it before b2World::DestroyBody:
  /// Box2D tells a b2DestructionListener of fixtures and joints, not of bodies.
  void forget(const b2Body& body);
  /// Forgets one fixture. Events of the last step and `fixture` return null for it. A b2DestructionListener may call
  /// it.
  void forget(const b2Fixture& fixture);
  /// With true, you promise to call `forget` or `destroy` for every body and fixture before its destruction. Then
  /// gather does not search the world for the bodies that hold cords. Initially false.
  void trust_forget(bool trusted);

  /// The state that save returns and restore takes.
  using State = CouplingState;
  /// Returns the state. Call it after apply and before the next gather. Inside a tick it returns a usable state too,
  /// but ticks that continue from it differ from those of this coupling. `world` is the world of the coupling. Grips of
  /// destroyed bodies are left out. The state does not contain the bodies of Box2D: see WorldSnapshot.
  State save(const b2World& world) const;
  /// Writes the state into an existing object. It allocates nothing if that object held a state of this coupling before
  /// with the same cords and no fewer grips, bodies, fixtures, contacts and events. O(points + bodies).
  void save(const b2World& world, State& state) const;
  /// Continues from a saved state, with the same bits if the bodies have the same state too. `world` may be another
  /// world that was built in the same way, with the same numbers of bodies and fixtures in the same order. A gather
  /// without its apply is discarded. The next ids are those of the state again, so drop ids that were issued since.
  /// Cords of the direct solver that were cut, removed or replaced since then are added again as they were defined, and
  /// cords that were added since then are removed; a cord that is still there keeps the accuracy that set_accuracy set
  /// last. Throws DefinitionError, and changes nothing, for a state with cords of the thesis's solver that are gone, of
  /// another world, and for a value out of range; CallError for a locked world.
  void restore(const State& state, b2World& world);

 private:
  friend void debug_draw(const Coupling& coupling, b2Draw& draw);  // see debug_draw.h

  std::unique_ptr<CouplingParts> parts_;
};

}  // namespace ribbon::box2d
