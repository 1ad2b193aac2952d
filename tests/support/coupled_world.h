#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "ribbon/box2d/coupling.h"
#include "ribbon/cord.h"
#include "tests/support/joint_chain.h"

namespace test_support {

/// How a CoupledWorld makes its cords.
struct CordMethod {
  bool chain = false;               ///< a JointChain instead of a cord of the direct solver
  bool thesis = false;              ///< or a cord of the thesis's
  double spring_share = 0.45;       ///< k of its springs: of a link's error, given back an iteration, 0 … below 1
  ribbon::Accuracy accuracy;        ///< of a cord
  int substeps = 1;                 ///< a tick: the world's own steps for a chain, iterations of the thesis's
  int velocity_iterations = 8;      ///< a substep
  int position_iterations = 3;      ///< a substep
  bool chain_meets_itself = false;  ///< its boxes meet all but their neighbours: CordDef::self_contact
};

/// A Box2D world of 60 ticks a second with cords in it, which may be chains of Box2D's own or cords of the thesis's
/// instead, so that one set-up does for all. Nothing in it sleeps.
class CoupledWorld {
 public:
  explicit CoupledWorld(const CordMethod& method, ribbon::Vec2 gravity = {0.0, -9.81});
  CoupledWorld(const CoupledWorld&) = delete;
  CoupledWorld& operator=(const CoupledWorld&) = delete;

  static constexpr double dt = 1.0 / 60.0;  // s
  /// Of the boxes of all chains: with others' they collide as with their own.
  static constexpr uint16 box_category = 2;
  static constexpr uint16 edge_category = 4;

  /// Returns its index. Of a chain, that of a rope: its boxes are as thick as the cord, and have its friction. Of the
  /// thesis's, a grid of as many columns of square cells: a rope has a second row to its right, a link away, both rows
  /// of the same weight. It meets circles, and itself if it declares that, without friction or thickness.
  int add(ribbon::CordDef def);
  b2Body& add_circle(b2BodyType type, ribbon::Vec2 position, double radius, double mass, double friction);
  /// Of static edges, from corner to corner.
  b2Body& add_edges(const std::vector<ribbon::Vec2>& corners, double friction);
  /// A body without a shape.
  b2Body& add_load(b2BodyType type, ribbon::Vec2 position, double mass, double inertia);
  /// The body holds the cord's first point, or its last, where both are.
  void hold(int cord, int point, b2Body& body);
  /// A force on a point, N, from now on. Of a chain, on its first point or its last; of the thesis's, which takes no
  /// forces, its momentum at the start of each tick.
  void pull(int cord, int point, ribbon::Vec2 force);

  void tick() {
    our_share();
    step_world();
  }
  /// All of a tick but world.Step.
  void our_share();
  void step_world();

  int cords() const { return method_.chain ? static_cast<int>(chains_.size()) : coupling.size(); }
  const CordMethod& method() const { return method_; }
  /// The points of a cord, or the ends of a chain's boxes: from the front end of the first on through all hind ends, so
  /// that joints that come apart count as stretch. Of the thesis's, those of the row that stands for a rope.
  std::vector<ribbon::Vec2> points(int cord) const;
  /// The closed outline of a ribbon and of the thesis's cords, or a cord's points.
  std::vector<ribbon::Vec2> outline(int cord) const;
  bool is_closed(int cord) const { return rows(cord) > 1; }
  /// m, around the outline, that nothing else comes into.
  double radius(int cord) const { return method_.thesis ? 0.0 : defs_[at(cord)].radius; }
  const ribbon::CordDef& def(int cord) const { return defs_[static_cast<std::size_t>(cord)]; }
  /// N, at a rope's first point, or its last: of its link there. No number of the thesis's.
  double tension(int cord, int point) const;
  /// The momentary velocity of a body's centre.
  ribbon::Vec2 velocity(const b2Body& body) const { return coupling.velocity(body); }
  /// J, of cords and bodies, kinetic, potential and elastic.
  double energy() const;
  /// J, what energies are compared with: the weight of all, and what pulls, times the length of the longest cord.
  double energy_scale() const;
  /// Ticks in which all that moves loses a tenth of its velocity each.
  void calm(int ticks);

  b2World world;
  ribbon::box2d::Coupling coupling;

 private:
  struct Chain {
    JointChain boxes;
    b2Joint* first = nullptr;  // what holds its first point
    b2Joint* last = nullptr;
  };
  struct Pull {
    int cord;
    int point;
    ribbon::Vec2 force;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int rows(int cord) const { return method_.thesis ? coupling.cord(cord).shape().rows : defs_[at(cord)].rows; }
  /// The point of the coupling's cord that stands for one of the definition's.
  int index_of(int cord, int point) const { return point * (rows(cord) / defs_[at(cord)].rows); }
  void pull_thesis_cords();
  void add_chain(const ribbon::CordDef& def);
  bool is_first(int cord, int point) const;
  /// The chain's first or last point, whichever the cord's is nearer to.
  int end_of(const Chain& chain, int cord, int point) const;
  void damp_bodies(float damping);
  void hold_chain(int cord, int point, b2Body& body);

  CordMethod method_;
  std::vector<ribbon::CordDef> defs_;  // with their positions
  std::vector<Chain> chains_;
  std::vector<Pull> pulls_;
  b2Body* ground_ = nullptr;  // that holds what is pinned of chains
};

}  // namespace test_support
