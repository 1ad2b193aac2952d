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

/// What any game would reuse; of it, what is installed puts cords into a Box2D world.
namespace engine {

/// Cords in a Box2D world of the user's. A tick is
///
///     coupling.gather(world, dt);   // the cords look at the world: who holds them, what is near them
///     coupling.step();              // the cords move and push
///     coupling.apply();             // the bodies get the impulses
///     world.Step(dt, …);
///
/// The response is shared by mass: cord and bodies together keep their linear momentum to double precision (but where a
/// cord holds a point back to the most it may move, which its report counts). Box2D moves a body that is touched by the
/// tick's last velocity, so a bounce leaves the common centre of mass a millimetre or two off its way.
///
/// A body that holds a cord moves in the tick as the cord saw it, on a curve; Box2D can only take it straight to the
/// end of that curve, at the mean velocity. The difference to the velocity at the end, half the acceleration times dt,
/// is kept here and carried into the next tick (without it a swing loses a tenth of its energy a period); so what
/// GetLinearVelocity shows of a holder is the mean of the last tick, and `velocity` the momentary one. Letting go gives
/// the difference back.
///
/// Cords of both solvers live in it side by side. One of the thesis's meets circles, and hands each body its impulse.
/// One of the direct solver meets circles, edges, chains and polygons, and is solved together with all bodies that hold
/// or touch it and the cords that these touch too; so what is said of holders above holds for all of them.
///
/// A cord that is allowed to sleeps, and who holds or touches it goes to sleep with it: Box2D's b2Body::SetAwake. What
/// wakes such a body in Box2D wakes the cord.
///
/// What a tick costs follows what is near the cords: gather asks the world's own broad phase for that. It goes through
/// the world's list of bodies only where a body holds a cord, to see whether it is still there, unless the user tells
/// that (`trust_forget`); where so much lies around the cords that to look around each of them for what comes from
/// further off takes longer; and in the tick in which several bodies come near for the first time, or one that was led
/// or touched is near no more.
///
/// No listener of the world is taken over. Between ticks bodies and fixtures may come and go, and no call looks into
/// the memory of one that is gone: what a cord remembers of a body or fixture ends with it. One that Box2D makes at the
/// address of another one that is gone is told from it by what is behind it in the world's list (SeenBody), as long as
/// the one made just before that, and some one made later, are still there. Where the newest body of the world, or the
/// newest fixture of its body, is replaced by another one, that cannot be seen: destroy it by `destroy`, or call
/// `forget` before, or the new one inherits grip, carried velocity and fixture number. The world outlives all calls but
/// the destructor, unless the next world is gathered first.
class Coupling {
 public:
  /// `filter` decides as between two Box2D fixtures which circles the cord meets.
  CordIndex add(ribbon::ThesisCord cord, const b2Filter& filter = {});

  /// The same for one of the direct solver, whose filter decides on edges and polygons too.
  CordIndex add(ribbon::Cord cord, const b2Filter& filter = {});

  /// Puts another cord in the place of one of the direct solver, between ticks: who held that has let go, what it had
  /// counted is forgotten, and what touched it ceases to in the next step unless it touches the new one. Throws
  /// ribbon::DefinitionError, and changes nothing, for a cord that does not exist or is the thesis's.
  void replace(CordIndex index, ribbon::Cord cord, const b2Filter& filter = {});
  /// Switches a cord off or on again, between ticks, as b2Body::SetEnabled does a body: one that is off stays as it is,
  /// costs nothing, meets nobody and is found by nothing. Who held it has let go, and what touched it ceases to in the
  /// next step. It keeps its index: a cord that is to go is switched off, and `replace` puts the next one, switched on,
  /// in its place. Throws ribbon::DefinitionError, and changes nothing, for a cord that does not exist.
  void set_enabled(CordIndex index, bool enabled);
  /// Whether it is switched on, as every cord is at first.
  bool is_enabled(CordIndex index) const { return cords_[at(index)].enabled; }

  /// How many cords it has, switched on or off.
  int size() const { return static_cast<int>(cords_.size()); }
  /// A cord of the direct solver; std::bad_variant_access for one of the thesis's.
  ribbon::Cord& cord(CordIndex index) { return std::get<ribbon::Cord>(cords_[at(index)].cord); }
  /// The same to read.
  const ribbon::Cord& cord(CordIndex index) const { return std::get<ribbon::Cord>(cords_[at(index)].cord); }
  /// One of the thesis's; std::bad_variant_access for one of the direct solver.
  ribbon::ThesisCord& thesis_cord(CordIndex index) { return std::get<ribbon::ThesisCord>(cords_[at(index)].cord); }
  /// The same to read.
  const ribbon::ThesisCord& thesis_cord(CordIndex index) const {
    return std::get<ribbon::ThesisCord>(cords_[at(index)].cord);
  }
  // Of a cord of either solver, for who does not care which (coupling_cords.cpp):
  Solver solver(CordIndex index) const;                            ///< which moves it
  CordShape shape(CordIndex index) const;                          ///< how its points lie
  std::span<const ribbon::Vec2> positions(CordIndex index) const;  ///< m, by point
  ribbon::PointKind kind(CordIndex index, int point) const;        ///< who moves a point
  /// Drags a point to `target` [m] in the next tick: call it again to drag on. Throws ribbon::DefinitionError for an
  /// unknown cord or point or a coordinate beyond ±1e9, and so does release.
  void operate(CordIndex index, int point, ribbon::Vec2 target);
  /// Constrains a point to `target` [m], reached in the next tick and then kept; throws as operate does.
  void constrain(CordIndex index, int point, ribbon::Vec2 target);
  /// Lets a dragged or constrained point go with the velocity it has.
  void release(CordIndex index, int point);

  /// What happened in the last step of all cords of the direct solver, each island counted once: its `work` is that of
  /// the tick.
  const ribbon::CordReport& tick_report() const { return direct_solver_.total(); }
  /// What happened in the last step in the island of a cord of the direct solver.
  const ribbon::CordReport& report(CordIndex index) const { return cords_[at(index)].direct_report; }
  /// What has happened to it since it was added, summed up.
  const ribbon::CordReport& total(CordIndex index) const { return cords_[at(index)].direct_total; }
  /// Estimates the error of each tick of the cords of the direct solver from now on, or no longer: see
  /// ribbon::ErrorProbe. It costs four ticks more and changes nothing of what the cords do.
  void estimate_errors(bool wanted);
  /// Whether it does.
  bool estimates_errors() const { return probe_.has_value(); }
  /// m, estimated, of the last tick: what its length costs, as if the one before had been exact. 0 unless it is asked
  /// for.
  double error(CordIndex index) const { return cords_[at(index)].direct_error; }
  /// Calls the watcher around each step of the direct solver from now on, with what the solver is given; null, as at
  /// first: nothing. It has to outlive the steps. It is no part of the state; where there is none, nothing is copied.
  void watch(StepWatcher* watcher) { watcher_ = watcher; }
  /// Gathers for many cords, and steps their islands, side by side from now on, to the same bits. It is no part of the
  /// state. Throws ribbon::DefinitionError, and changes nothing, for fewer workers than one.
  void use(const ribbon::ParallelFor& parallel_for);
  /// How many islands the cords of the direct solver made in the last step.
  int islands() const { return direct_solver_.islands(); }
  /// How many circles and edges were gathered for a cord in the last tick, because they may touch it.
  int gathered_near(CordIndex index) const;
  /// What that is, by fixture's number. Valid until the next gather, as long as the fixtures are.
  std::span<const NearShape> near(CordIndex index) const { return cords_[at(index)].near; }
  /// What happened in the last step of a cord of the thesis's solver.
  const ribbon::StepReport& thesis_report(CordIndex index) const { return cords_[at(index)].report; }
  /// What has happened to it since it was added, summed up.
  const ribbon::StepReport& thesis_total(CordIndex index) const { return cords_[at(index)].total; }

  /// Reads the world as it is before a tick of dt seconds: for each cord the fixtures of enabled bodies that it may
  /// reach in that time, several a body, static, kinematic and dynamic. Sensors are ignored, and so are dynamic bodies
  /// without mass and what is nowhere, or beyond ±1e9 m or m/s. Throws ribbon::DefinitionError, and changes nothing,
  /// for a world that is locked, a dt [s] below 1e-9 or above 1, and a gravity beyond ±1e9 m/s².
  void gather(b2World& world, double dt);
  /// Moves the cords by the tick gathered for, in the order they were added; a body pushed by one is felt by the next.
  /// Throws nothing, and neither does apply: what has numbers that no cord can meet was left out by gather. Until both
  /// are done the world stays as it was gathered.
  void step();
  /// Gives each dynamic body its impulse. What single precision cannot carry of it stays with the cord.
  void apply();

  /// Makes `body` hold a point of a cord at `local_hand`, in the body's own frame. One grip a body: a second call moves
  /// the hand evenly over the next tick, so start from where the point is and bring it nearer by and by. (A point that
  /// is elsewhere is drawn to the hand hard, but not at once.) Throws ribbon::DefinitionError, and changes nothing, for
  /// a cord or point that does not exist, a cord that is switched off, and for a hand beyond ±1e9.
  void hold(CordIndex cord, int point, b2Body& body, b2Vec2 local_hand);
  /// Lets go of everything, with the velocities that both have; false if the body held nothing.
  bool release(b2Body& body);

  /// Makes a body hold a cord of the direct solver once more, at any place, beside what it holds already. Throws
  /// ribbon::DefinitionError, and changes nothing, for a cord that does not exist, is the thesis's or switched off, an
  /// arc outside it, a number that is none, a world that is locked, or where the body holds the cord already.
  GripId grip(b2Body& body, const GripDef& def);
  /// Moves a grip along its cord to `arc` [m] at `speed` [m/s at rest, above 0], under load: it climbs. Throws
  /// ribbon::DefinitionError for a grip that is none, and numbers out of range.
  void climb(GripId grip, double arc, double speed);
  /// Moves the body's hand evenly over the next tick, as hold does. Throws ribbon::DefinitionError for a grip that is
  /// none, and a hand beyond ±1e9.
  void move_hand(GripId grip, b2Vec2 local_hand);
  /// Lets one grip go; false if there is none of that number. Its body may be gone from the world. O(bodies).
  bool let_go(GripId grip);
  /// Nothing if it has been let go, or let go itself.
  std::optional<GripState> state(GripId grip) const;

  /// What began and ceased to touch cords of the direct solver in the last step, by cord and fixture. Valid until the
  /// next gather.
  std::span<const TouchEvent> touch_events() const { return touch_events_; }
  /// What touched a cord of the direct solver in the last step, by fixture's number.
  std::span<const FixtureTouch> touching(CordIndex index) const { return cords_[at(index)].touching; }
  /// The fixture of a number that touching() tells; null if it was destroyed before the last gather, or since by
  /// `destroy`, or forgotten. Destroyed otherwise since, it dangles: ask as below.
  const b2Fixture* fixture(std::uint64_t number) const { return fixture_ids_.fixture(number); }
  /// The same, looked for in its world: null if it is no more, whoever destroyed it. O(bodies + fixtures).
  const b2Fixture* fixture(std::uint64_t number, const b2World& world) const;
  /// The velocity of the body's centre of mass at this moment, m/s: Box2D's, and for a holder what Box2D cannot show.
  /// O(bodies) for one of those.
  ribbon::Vec2 velocity(const b2Body& body) const;
  /// The same of its rotation, rad/s.
  double angular_velocity(const b2Body& body) const;
  /// What the body holds.
  std::optional<CordPoint> held_by(const b2Body& body) const;
  /// Lets go of what the body holds and destroys it: the way to destroy a body that cords may know. (One that is
  /// destroyed without is let go at the next gather, too; see above for what that does not recognise.)
  void destroy(b2World& world, b2Body& body);
  /// Knows nothing any more of a body that is about to be destroyed, of its grips and fixtures: what `destroy` does
  /// before it destroys. A b2DestructionListener may call both of these from SayGoodbye.
  void forget(const b2Body& body);
  /// The same of one fixture: events of the last step, and `fixture`, have null in its place.
  void forget(const b2Fixture& fixture);
  /// Says that one of `forget` and `destroy` is called for every body, and every fixture, before it is destroyed, from
  /// now on: then gather does not walk through the world's list of bodies in each tick in which a body holds a cord, to
  /// see whether that body is still there. At first it is not so.
  void trust_forget(bool trusted) { trusts_forget_ = trusted; }

  /// What save gives and restore takes.
  using State = CouplingState;
  /// What to go on from later, between an apply and the next gather of a world in which `world` is that of the
  /// coupling; grips of bodies that are not in it any more are left out, as the next gather would. Box2D's world has no
  /// such state: who goes back puts its bodies back himself, and what Box2D remembers of its own contacts is not his to
  /// set.
  State save(const b2World& world) const;
  /// Goes on from a saved state among the bodies of `world`, to the same bits if the world does: in the same one, or in
  /// one that was built alike, with as many bodies and fixtures in the order of making. A tick that was gathered for is
  /// forgotten. Throws ribbon::DefinitionError, and changes nothing, for a state of other cords or of another world,
  /// one with a number that no coupling can have, and a world that is locked.
  void restore(const State& state, b2World& world);

  /// m, the box in which the last gather looked for what the cord may meet; empty for one that was switched off.
  const ribbon::Box& reach(CordIndex index) const { return cords_[at(index)].reach; }

  /// The cord point nearest to `position`, if one is within `reach` metres; ties go to the first. Of cords that are
  /// switched on, as below; of one that is further off as a whole no point is looked at.
  std::optional<CordPoint> nearest_point(ribbon::Vec2 position, double reach) const;
  /// The same between the points too, of all cords but `except`; of a cord of the thesis's solver points only.
  std::optional<CordPoint> nearest_place(ribbon::Vec2 position, double reach,
                                         std::optional<CordIndex> except = {}) const;
  /// m, where a place is.
  ribbon::Vec2 position(const CordPoint& place) const;
  /// m at rest along a cord of the direct solver, from its first column to a place.
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
