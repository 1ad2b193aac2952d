#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "ribbon/cord_def.h"

namespace test_support {

/// A rope as Box2D's joints make it: a thin box for each link, as thick as the cord, with its friction, restitution and
/// drag. Revolute joints hold them together; where the cord resists bending, soft weld joints, which are revolute ones
/// with a spring of EI/l, damped as the cord is. A link's moment of inertia is that of its mass at its two ends, so
/// that the exact motion is that of the cord's points. Its boxes live as long as the world.
class JointChain {
 public:
  /// Where the definition's positions are. `filter` says what the boxes meet; neighbours never meet. What is pinned is
  /// left to who holds it.
  JointChain(b2World& world, const ribbon::CordDef& def, const b2Filter& filter);

  /// One more than boxes.
  int points() const { return static_cast<int>(boxes_.size()) + 1; }
  /// m, of point 0 … points() − 1: the front end of the first box, then all hind ends, so that joints that come apart
  /// count as stretch.
  b2Vec2 point(int k) const;
  /// The box that the point is an end of.
  b2Body& box_of(int point) const { return *boxes_[index_of(point)]; }

  /// Joins a body to a point of the chain, where both are: the body is the joint's first.
  b2RevoluteJoint& hold(int point, b2Body& body) const;

 private:
  static std::size_t index_of(int point) { return point == 0 ? 0 : static_cast<std::size_t>(point) - 1; }

  b2World* world_;
  std::vector<b2Body*> boxes_;
  std::vector<float> half_lengths_;  // m
};

/// Moves the place where a joint holds its first body, in the body's own frame. Box2D has no call for it, and a joint
/// that is made anew forgets the impulses from which it starts the next step.
void move_first_anchor(b2RevoluteJoint& joint, b2Vec2 local);
void move_first_anchor(b2DistanceJoint& joint, b2Vec2 local);

}  // namespace test_support
