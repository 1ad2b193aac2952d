#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/fixture_ids.h"
#include "ribbon/cord.h"
#include "ribbon/direct_solver.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/thesis_cord.h"

namespace engine {

/// A cord's place in its coupling, in the order of adding.
using CordIndex = int;

/// The two ways to move a cord.
enum class Solver : unsigned char {
  thesis,  ///< ribbon::ThesisCord
  direct,  ///< ribbon::Cord
};
/// "thesis" or "direct".
std::string_view solver_name(Solver solver);

/// How the points of a cord lie, whichever solver moves them: point (i, j) has the index i·rows + j.
struct CordShape {
  int columns = 0;         ///< along the cord
  int rows = 0;            ///< across it
  double thickness = 0.0;  ///< m, across it at rest, as it is drawn
  bool braced = false;     ///< bars join neighbours across the corner as well
};

/// The nearest cord point to somewhere.
struct CordPoint {
  CordIndex cord = 0;
  int point = 0;
  double distance = 0.0;  ///< m
};

/// Cords in somebody's Box2D world. A tick is
///
///     coupling.gather(world, dt);   // circle fixtures near a cord become the cord's rigid circles
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
/// No listener of the world is taken over. Between ticks bodies and fixtures may come and go: nothing of a body is kept
/// but for those that hold a cord, and a held cord is let go when its holder is no longer in the world.
class Coupling {
 public:
  /// `filter` decides as between two Box2D fixtures which circles the cord meets.
  CordIndex add(ribbon::ThesisCord cord, const b2Filter& filter = {});

  CordIndex add(ribbon::Cord cord, const b2Filter& filter = {});

  int size() const { return static_cast<int>(cords_.size()); }
  /// A cord of the thesis's solver; std::bad_variant_access for one of the direct solver, and the other way round.
  ribbon::ThesisCord& cord(CordIndex index) { return std::get<ribbon::ThesisCord>(cords_[at(index)].cord); }
  const ribbon::ThesisCord& cord(CordIndex index) const { return std::get<ribbon::ThesisCord>(cords_[at(index)].cord); }
  ribbon::Cord& direct_cord(CordIndex index) { return std::get<ribbon::Cord>(cords_[at(index)].cord); }
  const ribbon::Cord& direct_cord(CordIndex index) const { return std::get<ribbon::Cord>(cords_[at(index)].cord); }
  // Of a cord of either solver, for who does not care which (coupling_cords.cpp):
  Solver solver(CordIndex index) const;
  CordShape shape(CordIndex index) const;
  std::span<const ribbon::Vec2> positions(CordIndex index) const;  ///< m, by point
  ribbon::PointKind kind(CordIndex index, int point) const;
  /// Drags a point to `target` [m] in the next tick: call it again to drag on. Throws ribbon::DefinitionError for an
  /// unknown point or a coordinate beyond ±1e9, and so does release.
  void operate(CordIndex index, int point, ribbon::Vec2 target);
  /// Lets a dragged or constrained point go with the velocity it has.
  void release(CordIndex index, int point);

  /// What happened in the last step of a cord of the direct solver.
  const ribbon::CordReport& direct_report(CordIndex index) const { return cords_[at(index)].direct_report; }
  /// What has happened to it since it was added, summed up.
  const ribbon::CordReport& direct_total(CordIndex index) const { return cords_[at(index)].direct_total; }
  /// What happened in the cord's last step.
  const ribbon::StepReport& report(CordIndex index) const { return cords_[at(index)].report; }
  /// What has happened to the cord since it was added, summed up.
  const ribbon::StepReport& total(CordIndex index) const { return cords_[at(index)].total; }

  /// Reads the world as it is before a tick of dt seconds: for each cord the fixtures of enabled bodies that it may
  /// reach in that time, several a body, static, kinematic and dynamic. Sensors are ignored, and so are dynamic bodies
  /// without mass.
  void gather(b2World& world, double dt);
  /// Moves the cords by the tick gathered for, in the order they were added; a body pushed by one is felt by the next.
  void step();
  /// Gives each dynamic body its impulse. What single precision cannot carry of it stays with the cord.
  void apply();

  /// Makes `body` hold a point of a cord at `local_hand`, in the body's own frame. One grip a body: a second call moves
  /// the hand evenly over the next tick, so start from where the point is and bring it nearer by and by. (A point that
  /// is elsewhere is drawn to the hand hard, but not at once.) Throws ribbon::DefinitionError for a cord or point that
  /// does not exist.
  void hold(CordIndex cord, int point, b2Body& body, b2Vec2 local_hand);
  /// Lets go, with the velocities that both have; false if the body held nothing.
  bool release(b2Body& body);
  /// The velocity of the body's centre of mass at this moment, m/s: Box2D's, and for a holder what Box2D cannot show.
  ribbon::Vec2 velocity(const b2Body& body) const;
  /// What the body holds.
  std::optional<CordPoint> held_by(const b2Body& body) const;
  /// Lets go of what the body holds and destroys it: the way to destroy a body that may hold a cord. (One that is
  /// destroyed without is let go at the next gather all the same, unless Box2D has by then put a new body at the very
  /// same address, which would inherit the grip. Bodies that only touch a cord need nothing.)
  void destroy(b2World& world, b2Body& body);

  /// The cord point nearest to `position`, if one is within `reach` metres; ties go to the first.
  std::optional<CordPoint> nearest_point(ribbon::Vec2 position, double reach) const;

 private:
  struct CoupledCord {
    std::variant<ribbon::ThesisCord, ribbon::Cord> cord;
    b2Filter filter;
    ribbon::CordReport direct_report{};
    ribbon::CordReport direct_total{};
    ribbon::StepReport report{};
    ribbon::StepReport total{};
    ribbon::Box reach{};  // of this tick
    std::vector<ribbon::RigidCircle> circles{};
    std::vector<ribbon::RigidSegment> segments{};
    std::vector<ribbon::Grip> grips{};
  };
  struct Holder {
    b2Body* body;
    CordIndex cord;
    int point;
    b2Vec2 local_hand;  // at the start of the tick
    b2Vec2 next_hand;   // and at its end
  };
  /// A body that cords move on a curve.
  struct LedBody {
    const b2Body* body;
    ribbon::Vec2 ahead;          // m/s, the momentary velocity less Box2D's
    double ahead_turning = 0.0;  // rad/s, the same of the rotation
    ribbon::Vec2 position;       // m, of the centre of mass, where it was led to
    ribbon::Vec2 velocity;       // m/s, which Box2D leaves it with if it meets nothing
    ribbon::Vec2 pushed;         // m/s, by which it was more, in the tick before this one
    bool led;                    // in this tick
  };
  struct GatheredBody {
    b2Body* body;
    CordIndex met;  // the last cord of the thesis's that it came near or holds
  };

  void forget(const b2Body& body);
  CordIndex add(CoupledCord coupled);
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  void drop_what_is_gone_from(const b2World& world);
  void gather_body(b2Body& body, b2Vec2 gravity, double dt);
  void gather_fixture(b2Body& body, const b2Fixture& fixture, b2Vec2 gravity, double dt);
  int body_index(b2Body& body, b2Vec2 gravity);
  void step_direct();
  Holder* holder(const b2Body& body);
  const Holder* holder(const b2Body& body) const;
  std::vector<LedBody>::iterator led_place(const b2Body& body);
  LedBody* led(const b2Body& body);
  ribbon::Vec2 reaction(const b2Body& body, LedBody& led) const;
  const LedBody* led(const b2Body& body) const;
  static ribbon::Vec2 ahead(const b2Body& body, const LedBody& led);
  LedBody& led_or_new(const b2Body& body);
  void push(const GatheredBody& gathered, const ribbon::RigidBody& rigid);
  void lead(b2Body& body, const ribbon::RigidBody& rigid);
  void let_run(b2Body& body);

  std::vector<CoupledCord> cords_;
  std::vector<Holder> holders_;
  std::vector<LedBody> led_;  // by address, which serves to find one and for nothing else
  FixtureIds fixture_ids_;
  ribbon::DirectSolver direct_solver_;
  ribbon::Vec2 gravity_;
  double dt_ = 0.0;  // s, of the tick that was gathered for
  // This tick's bodies: Box2D's and the cord's view of each, at the same index.
  std::vector<GatheredBody> gathered_;
  std::vector<ribbon::RigidBody> rigid_;
  std::vector<ribbon::IslandCord> direct_cords_;
  std::vector<ribbon::CordReport> direct_reports_;
};

}  // namespace engine
