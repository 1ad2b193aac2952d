#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "ribbon/box2d/address_table.h"
#include "ribbon/box2d/coupling_near.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/fixture_ids.h"
#include "ribbon/box2d/step_watcher.h"
#include "ribbon/box2d/still_there.h"
#include "ribbon/cord.h"
#include "ribbon/direct_solver.h"
#include "ribbon/error_probe.h"
#include "ribbon/parallel_for.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/thesis/thesis_cord.h"

/// The parts of a game that do not depend on its rules. The installed part of it puts cords into a Box2D world.
namespace engine {

/// Puts cords into a Box2D world. One tick is
///
///     coupling.gather(world, dt);   // finds what holds the cords and what is near them
///     coupling.step();              // solves the cords together with these bodies
///     coupling.apply();             // gives the bodies their impulses
///     world.Step(dt, …);
///
/// **Momentum.** Cords and bodies together conserve linear momentum to double precision, except where a cord limits the
/// motion of a point; its report counts that. Box2D moves a touched body at the last velocity of the tick, so after an
/// impact the common centre of mass can be off its path by a millimetre or two.
///
/// **Velocities of bodies.** A body that holds a cord follows a curve during a tick. Box2D can only move it in a
/// straight line to the end of that curve, at the mean velocity. The coupling stores the difference between the
/// velocity at the end and the mean (half the acceleration times dt) and adds it in the next tick; without it, a
/// pendulum would lose a tenth of its energy in each period. So b2Body::GetLinearVelocity returns the mean velocity of
/// the last tick, and Coupling::velocity the momentary one. When the grip is released, the body gets the difference.
///
/// **Solvers.** Cords of both solvers can be in one coupling. Cords of the thesis's solver meet circles only. Cords of
/// the direct solver meet circles, edges, chains and polygons; they are solved together with all bodies that hold or
/// touch them, and with other cords that those bodies touch. So the previous paragraph holds for all such bodies.
///
/// **Sleep.** A cord that is allowed to sleep falls asleep together with the bodies that hold or touch it
/// (b2Body::SetAwake), and it wakes when one of them wakes.
///
/// **Cost.** The cost of a tick depends on what is near the cords, because gather queries the broad phase of the world.
/// It walks through all bodies of the world only in these cases: a body holds a cord and destructions are not reported
/// (`trust_forget`); so many bodies are around the cords that separate queries would take longer; several bodies come
/// near in one tick for the first time, or a body that was moved or touched is near no more.
///
/// **Destroyed bodies.** The coupling installs no listener. Bodies and fixtures may be created and destroyed between
/// ticks; the coupling never reads the memory of a destroyed one. If Box2D reuses its address, the coupling recognises
/// the new object by its successor in Box2D's list (SeenBody), provided that the object created just before the
/// destroyed one and one created later still exist. It cannot recognise the replacement of the newest body of the world
/// or of the newest fixture of a body: destroy these with `destroy`, or call `forget` first. Otherwise the new object
/// inherits grip, stored velocity and fixture number. The world must outlive all calls except the destructor, until
/// another world is gathered.
class Coupling {
 public:
  /// Adds a cord of the thesis's solver. `filter` determines which circles it meets, as between two Box2D fixtures.
  CordIndex add(ribbon::ThesisCord cord, const b2Filter& filter = {});

  /// Adds a cord of the direct solver. `filter` applies to circles, edges and polygons.
  CordIndex add(ribbon::Cord cord, const b2Filter& filter = {});

  /// Replaces a cord of the direct solver, between ticks. Bodies that held the old cord release it, and its reports are
  /// reset. What touched the old cord and does not touch the new one gets an end event in the next step. Throws
  /// ribbon::DefinitionError, and changes nothing, for an unknown cord and one of the thesis's solver.
  void replace(CordIndex index, ribbon::Cord cord, const b2Filter& filter = {});
  /// Enables or disables a cord, between ticks, like b2Body::SetEnabled. A disabled cord does not move, costs nothing,
  /// meets nothing and is not found by queries. Bodies that held it release it, and its contacts end in the next step.
  /// It keeps its index: to remove a cord, disable it; `replace` puts a new, enabled cord in its place. Throws
  /// ribbon::DefinitionError, and changes nothing, for an unknown cord.
  void set_enabled(CordIndex index, bool enabled);
  /// Returns whether a cord is enabled, as it is initially.
  bool is_enabled(CordIndex index) const { return cords_[at(index)].enabled; }

  /// Returns the number of cords, enabled or not.
  int size() const { return static_cast<int>(cords_.size()); }
  /// Returns a cord of the direct solver. Throws std::bad_variant_access for one of the thesis's solver.
  ribbon::Cord& cord(CordIndex index) { return std::get<ribbon::Cord>(cords_[at(index)].cord); }
  /// Returns a cord of the direct solver, for reading.
  const ribbon::Cord& cord(CordIndex index) const { return std::get<ribbon::Cord>(cords_[at(index)].cord); }
  /// Returns a cord of the thesis's solver. Throws std::bad_variant_access for one of the direct solver.
  ribbon::ThesisCord& thesis_cord(CordIndex index) { return std::get<ribbon::ThesisCord>(cords_[at(index)].cord); }
  /// Returns a cord of the thesis's solver, for reading.
  const ribbon::ThesisCord& thesis_cord(CordIndex index) const {
    return std::get<ribbon::ThesisCord>(cords_[at(index)].cord);
  }
  // For cords of both solvers (coupling_cords.cpp):
  Solver solver(CordIndex index) const;                            ///< its solver
  CordShape shape(CordIndex index) const;                          ///< the layout of its points
  std::span<const ribbon::Vec2> positions(CordIndex index) const;  ///< m, by point
  ribbon::PointKind kind(CordIndex index, int point) const;        ///< what determines the motion of a point
  /// Drags a point to `target` [m] in the next tick. Call it in each tick while dragging. Throws
  /// ribbon::DefinitionError for an unknown cord or point and for a coordinate beyond ±1e9.
  void operate(CordIndex index, int point, ribbon::Vec2 target);
  /// Pins a point to `target` [m]. The point moves there in the next tick and then stays. Throws as `operate` does.
  void constrain(CordIndex index, int point, ribbon::Vec2 target);
  /// Frees a dragged or pinned point, which keeps its velocity. Throws as `operate` does.
  void release(CordIndex index, int point);

  /// Returns the report of the last step of all cords of the direct solver, which counts each island once. Its `work`
  /// is that of the whole tick.
  const ribbon::CordReport& tick_report() const { return direct_solver_.total(); }
  /// Returns the report of the last step of the island that a cord of the direct solver belongs to.
  const ribbon::CordReport& report(CordIndex index) const { return cords_[at(index)].direct_report; }
  /// Returns the sum of these reports since the cord was added.
  const ribbon::CordReport& total(CordIndex index) const { return cords_[at(index)].direct_total; }
  /// Starts or stops to estimate the error of each tick of the cords of the direct solver; see ribbon::ErrorProbe. An
  /// estimate costs as much as four ticks and does not change the motion.
  void estimate_errors(bool wanted);
  /// Returns whether errors are estimated.
  bool estimates_errors() const { return probe_.has_value(); }
  /// Returns the estimated time integration error of the last tick [m], for exact initial values; 0 if errors are not
  /// estimated.
  double error(CordIndex index) const { return cords_[at(index)].direct_error; }
  /// Sets an object whose functions are called before and after each step of the direct solver, or null for none. It
  /// must outlive the steps. It is not part of the state, and costs nothing if it is null.
  void watch(StepWatcher* watcher) { watcher_ = watcher; }
  /// Sets how gather and step run in parallel. The results have the same bits. It is not part of the state. Throws
  /// ribbon::DefinitionError, and changes nothing, for less than one worker.
  void use(const ribbon::ParallelFor& parallel_for);
  /// Returns the number of islands of the direct solver in the last step.
  int islands() const { return direct_solver_.islands(); }
  /// Returns the number of circles and edges that a cord could have touched in the last tick.
  int gathered_near(CordIndex index) const;
  /// Returns the shapes they belong to, ordered by fixture number. Valid until the next gather or the destruction of a
  /// fixture.
  std::span<const NearShape> near(CordIndex index) const { return cords_[at(index)].near; }
  /// Returns the report of the last step of a cord of the thesis's solver.
  const ribbon::StepReport& thesis_report(CordIndex index) const { return cords_[at(index)].report; }
  /// Returns the sum of these reports since the cord was added.
  const ribbon::StepReport& thesis_total(CordIndex index) const { return cords_[at(index)].total; }

  /// First part of a tick of dt seconds: finds for each cord the fixtures that it may touch in the tick. Ignores
  /// sensors, disabled bodies, dynamic bodies without mass, and bodies whose position or velocity is not finite or
  /// beyond ±1e9 (m, m/s). Throws ribbon::DefinitionError, and changes nothing, for a locked world, a dt outside 1e-9 …
  /// 1, and gravity beyond ±1e9 m/s².
  void gather(b2World& world, double dt);
  /// Second part: advances the cords. Cords of the thesis's solver are advanced in the order of adding, and each feels
  /// bodies as the ones before it left them. Does not throw. Do not change the world between gather and apply.
  void step();
  /// Third part: gives each dynamic body its impulse. The coupling keeps what single precision rounds off. Does not
  /// throw.
  void apply();

  /// Makes a body hold a point of a cord at `local_hand`, an anchor in the body's frame. A body has one such grip: a
  /// second call moves the anchor to the new place during the next tick. Start with an anchor at the point and move it
  /// step by step; a distant point is pulled to the anchor with great force, over several ticks. Throws
  /// ribbon::DefinitionError, and changes nothing, for an unknown cord or point, a disabled cord, and an anchor beyond
  /// ±1e9.
  void hold(CordIndex cord, int point, b2Body& body, b2Vec2 local_hand);
  /// Releases all grips of a body. Body and cords keep their velocities. Returns false if the body held nothing.
  bool release(b2Body& body);

  /// Makes a body hold a cord of the direct solver at any place, in addition to its other grips. Throws
  /// ribbon::DefinitionError, and changes nothing, for a cord that is unknown, disabled or of the thesis's solver, an
  /// arc beyond its ends, a value that is not finite, a locked world, and a place that the body holds already.
  GripId grip(b2Body& body, const GripDef& def);
  /// Moves a grip along its cord to `arc` [m] at `speed` [m of rest length per second, above 0], so that the body
  /// climbs. Throws ribbon::DefinitionError for an unknown grip and for values out of range.
  void climb(GripId grip, double arc, double speed);
  /// Moves the anchor of a grip in the body's frame, at constant velocity during the next tick. Throws
  /// ribbon::DefinitionError for an unknown grip and for an anchor beyond ±1e9.
  void move_hand(GripId grip, b2Vec2 local_hand);
  /// Releases one grip. Returns false if it does not exist. Its body may be destroyed already. O(bodies).
  bool let_go(GripId grip);
  /// Returns the state of a grip, or nothing if it was released or gave way.
  std::optional<GripState> state(GripId grip) const;

  /// Returns the contacts of the direct solver that began or ended in the last step, ordered by cord and fixture. Valid
  /// until the next gather.
  std::span<const TouchEvent> touch_events() const { return touch_events_; }
  /// Returns what touched a cord of the direct solver in the last step, ordered by fixture number.
  std::span<const FixtureTouch> touching(CordIndex index) const { return cords_[at(index)].touching; }
  /// Returns the fixture with a number from touching(), or null if it was destroyed before the last gather or with
  /// `destroy`, or forgotten. If it may have been destroyed otherwise since then, use the next function.
  const b2Fixture* fixture(std::uint64_t number) const { return fixture_ids_.fixture(number); }
  /// Returns the fixture with that number if it is still in its world, else null. O(bodies + fixtures).
  const b2Fixture* fixture(std::uint64_t number, const b2World& world) const;
  /// Returns the momentary velocity of a body's centre of mass, m/s. It differs from Box2D's for bodies that the solver
  /// moves; see above. O(bodies) for those.
  ribbon::Vec2 velocity(const b2Body& body) const;
  /// Returns the momentary angular velocity of a body, rad/s.
  double angular_velocity(const b2Body& body) const;
  /// Returns the place that a body holds.
  std::optional<CordPoint> held_by(const b2Body& body) const;
  /// Releases what a body holds and destroys it. Use it for bodies that hold or touch cords. (Otherwise the next gather
  /// notices the destruction, with the exceptions named above.)
  void destroy(b2World& world, b2Body& body);
  /// Forgets a body that is about to be destroyed, with its grips and fixtures. A b2DestructionListener may call this
  /// and the next function.
  void forget(const b2Body& body);
  /// Forgets one fixture. Events of the last step and `fixture` return null for it.
  void forget(const b2Fixture& fixture);
  /// With true, you promise to call `forget` or `destroy` for every body and fixture before its destruction. Then
  /// gather does not search the world for the bodies that hold cords. Initially false.
  void trust_forget(bool trusted) { trusts_forget_ = trusted; }

  /// The state that save returns and restore takes.
  using State = CouplingState;
  /// Returns the state between an apply and the next gather. `world` is the world of the coupling. Grips of destroyed
  /// bodies are left out. The state does not contain the bodies of Box2D: restore their positions and velocities
  /// yourself. (The contacts that Box2D stores cannot be restored.)
  State save(const b2World& world) const;
  /// Continues from a saved state, with the same bits if the bodies have the same state too. `world` may be another
  /// world that was built in the same way, with the same numbers of bodies and fixtures in the same order. A gather
  /// without its apply is discarded. Throws ribbon::DefinitionError, and changes nothing, for a state of other cords or
  /// of another world, a value out of range, and a locked world.
  void restore(const State& state, b2World& world);

  /// Returns the box [m] in which the last gather searched for a cord; empty if the cord was disabled.
  const ribbon::Box& reach(CordIndex index) const { return cords_[at(index)].reach; }

  /// Returns the nearest point of an enabled cord within `reach` [m] of `position`; of equal ones the first. It tests
  /// the bounding box of each cord and the points of cords that may be in range.
  std::optional<CordPoint> nearest_point(ribbon::Vec2 position, double reach) const;
  /// Returns the nearest place on an enabled cord other than `except`, also between two points; for cords of the
  /// thesis's solver, the nearest point.
  std::optional<CordPoint> nearest_place(ribbon::Vec2 position, double reach,
                                         std::optional<CordIndex> except = {}) const;
  /// Returns the position of a place, m.
  ribbon::Vec2 position(const CordPoint& place) const;
  /// Returns the rest length of a cord of the direct solver from its first column to a place, m.
  double arc(const CordPoint& place) const;

 private:
  struct CoupledCord {
    std::variant<ribbon::ThesisCord, ribbon::Cord> cord;
    b2Filter filter;
    bool enabled = true;
    ribbon::CordReport direct_report{};
    ribbon::CordReport direct_total{};
    double direct_error = 0.0;
    ribbon::StepReport report{};
    ribbon::StepReport total{};
    ribbon::Box reach{};            // of this tick
    std::vector<NearShape> near{};  // what is in it
    std::vector<ribbon::RigidCircle> circles{};
    std::vector<ribbon::RigidSegment> segments{};
    std::vector<ribbon::Grip> grips{};
    std::vector<GripId> grip_ids{};        // of each
    std::vector<FixtureTouch> touching{};  // by fixture, in the last tick
    std::vector<FixtureTouch> touched{};   // and in the one before
  };
  struct Holder : GripMemory {
    b2Body* body;
    SeenBody seen;
  };
  struct LedBody : LedMemory {
    b2Body* body;
    SeenBody seen;
    bool left = false;  // no cord is near it any more
  };
  struct GatheredBody {
    b2Body* body;
    CordIndex met;       // the last cord of the thesis's that it came near or holds
    bool holds = false;  // some cord
  };
  // Of an address in wanted_:
  static constexpr int wanted_body = 0;
  static constexpr int found_body = 1;

  void check_state(const State& state, const std::vector<b2Body*>& bodies) const;
  void drop(const b2Body& body);
  void enter(const b2World& world);
  void drop_if_replaced(const b2Body& body);
  bool world_has(const SeenBody& seen) const;
  void look_for_wanted();
  void drop_gone_holders();
  void look_at_holders();
  void let_run_who_left();
  static void make_room(CoupledCord& coupled);
  CordIndex add(CoupledCord coupled);
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  void look_around(b2World& world);
  void number_new_fixtures(const b2World& world);
  template <typename Number>
  void number_by_body(const b2World& world, const Number& number_those_of);
  void meet(CoupledCord& coupled);
  void meet_circle(CoupledCord& coupled, const b2Fixture& fixture, int body);
  int body_index(b2Body& body);
  void step_direct();
  bool may_be_within(CordIndex index, ribbon::Vec2 position, double distance) const;
  void check_cord(CordIndex cord) const;
  void check_enabled(CordIndex cord) const;
  void check_arc(CordIndex cord, double arc) const;
  void gather_grips();
  double climb_in_tick(Holder& holder) const;
  double column(const Holder& holder) const;
  void set_column(Holder& holder, double column) const;
  double column_at(CordIndex cord, double arc) const;
  double arc_at(CordIndex cord, double column) const;
  void follow_grips();
  void let_go_who_must();
  void find_touch_events();
  static void add_touches(const ribbon::Cord& cord, std::vector<FixtureTouch>& touching);
  Holder* find_holder(GripId grip);
  const Holder* find_holder(GripId grip) const;
  Holder& grip_of_direct(GripId grip);
  Holder* holder(const b2Body& body);
  const Holder* holder(const b2Body& body) const;
  std::vector<LedBody>::iterator led_place(const b2Body& body);
  LedBody* led(const b2Body& body);
  ribbon::Vec2 reaction(const b2Body& body, LedBody& led) const;
  const LedBody* led(const b2Body& body) const;
  static double single_rounding(ribbon::Vec2 position);
  static bool meets_anything(const b2Body& body);
  ribbon::Vec2 drawn(Holder& held, ribbon::Vec2 center, ribbon::Vec2 hand) const;
  static ribbon::Vec2 given(const b2Body& body, const LedBody& led);
  static ribbon::Vec2 pushed(const b2Body& body, const LedBody& led);
  static ribbon::Vec2 ahead(const b2Body& body, const LedBody& led);
  static double ahead_turning(const b2Body& body, const LedBody& led);
  LedBody& led_or_new(b2Body& body);
  void push(const GatheredBody& gathered, const ribbon::RigidBody& rigid);
  void lead(b2Body& body, const ribbon::RigidBody& rigid);
  void let_run(b2Body& body);
  static void add_ahead(b2Body& body, const LedBody& led);
  void lay_to_rest(b2Body& body);
  void let_go_of(CordIndex cord);
  void look_for_the_missing(b2World& world);

  std::vector<CoupledCord> cords_;
  std::vector<Holder> holders_;
  GripId next_grip_ = 1;
  std::vector<TouchEvent> touch_events_;
  std::vector<LedBody> led_;  // by address, which serves to find one and for nothing else
  FixtureIds fixture_ids_;
  const b2World* world_ = nullptr;  // that holders_ and led_ are in
  bool trusts_forget_ = false;
  ribbon::ParallelFor parallel_for_;
  NearFinder near_finder_;
  std::vector<Look> looks_;  // of cords that are switched on
  AddressTable wanted_;      // bodies that are looked for in the world's list
  // Without numbers yet, in a tick, and their bodies: by address, to find them by.
  std::vector<const b2Fixture*> new_fixtures_;
  std::vector<const b2Body*> new_bodies_;
  ribbon::DirectSolver direct_solver_;
  std::optional<ribbon::ErrorProbe> probe_;
  StepWatcher* watcher_ = nullptr;
  ribbon::Vec2 gravity_;
  double dt_ = 0.0;  // s, of the tick that was gathered for
  // This tick's bodies: Box2D's and the cord's view of each, at the same index.
  std::vector<GatheredBody> gathered_;
  std::vector<ribbon::RigidBody> rigid_;
  AddressTable body_places_;  // in both
  std::vector<ribbon::IslandCord> direct_cords_;
  std::vector<ribbon::CordReport> direct_reports_;
};

}  // namespace engine
