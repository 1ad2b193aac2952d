#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <vector>

#include "ribbon/rigid_circle.h"
#include "ribbon/thesis_cord.h"

namespace engine {

/// A cord's place in its coupling, in the order of adding.
using CordIndex = int;

/// The nearest cord point to somewhere.
struct CordPoint {
  CordIndex cord = 0;
  int point = 0;
  double distance = 0.0;  ///< m
};

/// Cords in somebody's Box2D world. A tick is
///
///     coupling.gather(world, dt);   // circle fixtures near a cord become the cord's rigid circles
///     coupling.step(dt);            // the cords move and push
///     coupling.apply();             // the bodies get the impulses
///     world.Step(dt, …);
///
/// The response is shared by mass: cord and bodies together keep their linear momentum to double precision. No listener
/// of the world is taken over. Between ticks bodies and fixtures may come and go: nothing of a body is kept but for
/// those that hold a cord, and a held cord is let go when its holder is no longer in the world.
class Coupling {
 public:
  /// `filter` decides as between two Box2D fixtures which circles the cord meets.
  CordIndex add(ribbon::ThesisCord cord, const b2Filter& filter = {});

  int size() const { return static_cast<int>(cords_.size()); }
  ribbon::ThesisCord& cord(CordIndex index) { return cords_[at(index)].cord; }
  const ribbon::ThesisCord& cord(CordIndex index) const { return cords_[at(index)].cord; }
  /// What happened in the cord's last step.
  const ribbon::StepReport& report(CordIndex index) const { return cords_[at(index)].report; }

  /// Reads the world as it is before a tick of dt seconds: for each cord the circles of enabled bodies that it may
  /// reach in that time, offset in their body, several a body, static, kinematic and dynamic. Sensors are ignored.
  void gather(b2World& world, double dt);
  /// Moves the cords, in the order they were added; a body pushed by one is felt by the next.
  void step(double dt);
  /// Gives each dynamic body its impulse. What single precision cannot carry of it stays with the cord.
  void apply();

  /// Makes `body` hold a point of a cord at `local_hand`, in the body's own frame. One grip a body: a second call moves
  /// it. The point is drawn to the hand at once, so start from where it is and call again to bring it nearer. Throws
  /// ribbon::DefinitionError for a cord or point that does not exist.
  void hold(CordIndex cord, int point, b2Body& body, b2Vec2 local_hand);
  /// Lets go, with the velocities that both have; false if the body held nothing.
  bool release(const b2Body& body);
  /// What the body holds.
  std::optional<CordPoint> held_by(const b2Body& body) const;
  /// Call it before destroying a body that may hold a cord. (Forgotten, the cord is let go at the next gather all the
  /// same, unless Box2D has by then put a new body at the same address, which would inherit the grip.)
  void forget(const b2Body& body) { release(body); }

  /// The cord point nearest to `position`, if one is within `reach` metres; ties go to the first.
  std::optional<CordPoint> nearest_point(ribbon::Vec2 position, double reach) const;

 private:
  struct CoupledCord {
    ribbon::ThesisCord cord;
    b2Filter filter;
    ribbon::StepReport report;
    ribbon::Box reach;  // of this tick
    std::vector<ribbon::RigidCircle> circles;
    std::vector<ribbon::Grip> grips;
  };
  struct Holder {
    b2Body* body;
    CordIndex cord;
    int point;
    b2Vec2 local_hand;
  };
  struct GatheredBody {
    b2Body* body;
    CordIndex pushed_by;  // the last cord that did, −1 for none
  };

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  void drop_holders_gone_from(const b2World& world);
  void gather_body(b2Body& body, b2Vec2 gravity, double dt);
  int body_index(b2Body& body, b2Vec2 gravity);
  void apply_to(const GatheredBody& gathered, const ribbon::RigidBody& rigid);

  std::vector<CoupledCord> cords_;
  std::vector<Holder> holders_;
  ribbon::Vec2 gravity_;
  // This tick's bodies: Box2D's and the cord's view of each, at the same index.
  std::vector<GatheredBody> gathered_;
  std::vector<ribbon::RigidBody> rigid_;
};

}  // namespace engine
