#pragma once

#include <box2d/box2d.h>

#include <utility>
#include <vector>

#include "ribbon/cord_def.h"

namespace game::lab {

/// A rope of Box2D's joints: a thin box for each link, as thick as the cord, with its friction, restitution and drag.
/// Revolute joints connect them; if the cord has bending stiffness, soft weld joints: revolute joints with a spring of
/// EI/l and the cord's damping. A link's moment of inertia is that of its mass at its two ends, so that the exact
/// motion is that of the cord's points. The boxes live as long as the world.
class JointChain {
 public:
  /// Creates the chain at the definition's positions. The boxes have `filter`; neighbours never collide. The caller
  /// holds the pinned points.
  JointChain(b2World& world, const ribbon::CordDef& def, const b2Filter& filter);

  /// Returns the number of boxes plus one.
  int points() const { return static_cast<int>(boxes_.size()) + 1; }
  /// Returns the position of point 0 … points() − 1, m: the front end of the first box, then all rear ends, so that
  /// gaps of joints count as stretch.
  b2Vec2 point(int k) const;
  /// Returns the ends of a box, m.
  std::pair<b2Vec2, b2Vec2> ends(int box) const;
  const std::vector<b2Body*>& boxes() const { return boxes_; }
  /// Returns the box with that point at its end.
  b2Body& box_of(int point) const { return *boxes_[index_of(point)]; }

  /// Joins a body to a point of the chain at their present positions: the body is the joint's body A.
  b2RevoluteJoint& hold(int point, b2Body& body) const;

 private:
  static std::size_t index_of(int point) { return point == 0 ? 0 : static_cast<std::size_t>(point) - 1; }

  b2World* world_;
  std::vector<b2Body*> boxes_;
  std::vector<float> half_lengths_;  // m
};

}  // namespace game::lab
