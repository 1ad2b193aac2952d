#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "game/lab/joint_chain.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/cord.h"

namespace test_support {

/// How a CoupledWorld represents its cords.
struct CordMethod {
  bool chain = false;               ///< as a JointChain instead of a cord of the direct solver
  bool thesis = false;              ///< as a cord of the thesis
  double spring_share = 0.45;       ///< k of its springs: correction per iteration, relative to a link's error, below 1
  ribbon::Accuracy accuracy;        ///< of a cord
  int substeps = 1;                 ///< per tick: world steps for a chain, iterations for the thesis's method
  int velocity_iterations = 8;      ///< per substep
  int position_iterations = 3;      ///< per substep
  bool chain_self_contact = false;  ///< its boxes collide, except neighbours: CordDef::self_contact
};

/// A Box2D world of 60 ticks per second with cords, which may be chains of Box2D's joints or cords of the thesis, so
/// that one scene is run with all of them. Nothing in it sleeps.
class CoupledWorld {
 public:
  explicit CoupledWorld(const CordMethod& method, ribbon::Vec2 gravity = {0.0, -9.81});
  CoupledWorld(const CoupledWorld&) = delete;
  CoupledWorld& operator=(const CoupledWorld&) = delete;

  static constexpr double dt = 1.0 / 60.0;  // s
  /// The category of the boxes of all chains; boxes of different chains collide as those of one chain.
  static constexpr uint16 box_category = 2;
  static constexpr uint16 edge_category = 4;

  /// Adds a cord; returns its index. A chain must be a rope: its boxes have the cord's thickness and friction. A cord
  /// of the thesis is a grid with the same number of columns of square cells: a rope has a second row to its right at
  /// the distance of a link, both rows with the same mass. It collides with circles, and with itself if declared,
  /// without friction or thickness.
  int add(ribbon::CordDef def);
  b2Body& add_circle(b2BodyType type, ribbon::Vec2 position, double radius, double mass, double friction);
  /// Adds a body of static edges from corner to corner.
  b2Body& add_edges(const std::vector<ribbon::Vec2>& corners, double friction);
  /// Adds a body without a shape.
  b2Body& add_load(b2BodyType type, ribbon::Vec2 position, double mass, double inertia);
  /// The body holds the cord's first or last point, at their present positions.
  void hold(int cord, int point, b2Body& body);
  /// Sets a constant force on a point, N. For a chain, on its first or last point. A cord of the thesis accepts no
  /// forces and gets the momentum at the start of each tick.
  void pull(int cord, int point, ribbon::Vec2 force);

  void tick() {
    step_cords();
    step_world();
  }
  /// All of a tick but world.Step.
  void step_cords();
  void step_world();

  int cords() const { return method_.chain ? static_cast<int>(chains_.size()) : coupling.size(); }
  const CordMethod& method() const { return method_; }
  /// Returns the points of a cord; the ends of a chain's boxes: the front end of the first and all rear ends, so that
  /// gaps of joints count as stretch; the row of a cord of the thesis that represents a rope.
  std::vector<ribbon::Vec2> points(int cord) const;
  /// Returns the closed outline of a ribbon or a cord of the thesis, or a rope's points.
  std::vector<ribbon::Vec2> outline(int cord) const;
  bool is_closed(int cord) const { return rows(cord) > 1; }
  /// Returns the contact radius around the outline, m.
  double radius(int cord) const { return method_.thesis ? 0.0 : defs_[at(cord)].radius; }
  const ribbon::CordDef& def(int cord) const { return defs_[static_cast<std::size_t>(cord)]; }
  /// Returns the tension of the link at a rope's first or last point, N; NaN for a cord of the thesis.
  double tension(int cord, int point) const;
  /// Returns the momentary velocity of a body's centre.
  ribbon::Vec2 velocity(const b2Body& body) const { return coupling.body(body).velocity(); }
  /// Returns the kinetic, potential and elastic energy of cords and bodies, J.
  double energy() const;
  /// Returns the scale for energies, J: total weight and pulls, times the length of the longest cord.
  double energy_scale() const;
  /// Runs ticks in which all velocities decrease by a tenth each.
  void settle(int ticks);

  b2World world;
  ribbon::box2d::Coupling coupling;

 private:
  struct Chain {
    game::lab::JointChain boxes;
    b2Joint* first = nullptr;  // holds its first point
    b2Joint* last = nullptr;
  };
  struct Pull {
    int cord;
    int point;
    ribbon::Vec2 force;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int rows(int cord) const { return method_.thesis ? coupling.cord(cord).shape().rows : defs_[at(cord)].rows; }
  /// Returns the point of the coupling's cord that represents a point of the definition.
  int index_of(int cord, int point) const { return point * (rows(cord) / defs_[at(cord)].rows); }
  void pull_thesis_cords();
  void add_chain(const ribbon::CordDef& def);
  bool is_first(int cord, int point) const;
  /// Returns the chain's first or last point, whichever is nearer to the cord's point.
  int end_of(const Chain& chain, int cord, int point) const;
  void damp_bodies(float damping);
  void hold_chain(int cord, int point, b2Body& body);

  CordMethod method_;
  std::vector<ribbon::CordDef> defs_;  // with their positions
  std::vector<Chain> chains_;
  std::vector<Pull> pulls_;
  b2Body* ground_ = nullptr;  // holds the pinned points of chains
};

}  // namespace test_support
