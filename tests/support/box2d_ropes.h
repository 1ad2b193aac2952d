#pragma once

#include <box2d/b2_rope.h>
#include <box2d/box2d.h>

#include <vector>

namespace test_support {

/// The rope of the heavy_swing scene (tests/support/exact_chain.h) of Box2D's joints: rigid links without shapes,
/// revolute joints between them, the load as a separate body. A link's moment of inertia is that of its mass at its two
/// ends, so that the exact solution is that of the chain of points. Alternatives that are not used: bodies and joints
/// in the reverse order (the same from 16 substeps on), a load that is part of the last link (0.89 instead of 0.94 m at
/// 16 substeps, worse at 64 and with the max-distance joint).
class Box2dChain {
 public:
  enum class Limit { none, max_distance };
  /// `max_distance` adds a joint that limits the distance of the load from the pin to the rope's length.
  explicit Box2dChain(Limit limit);

  void step(float dt, int velocity_iterations, int position_iterations) {
    world_.Step(dt, velocity_iterations, position_iterations);
  }
  const std::vector<b2Body*>& links() const { return links_; }
  const b2Body& load() const { return *load_; }

 private:
  b2Body* make_body(float x, float mass, float inertia);
  void join(b2Body* a, b2Body* b, float x);
  void keep_near(b2Body* pin);

  b2World world_;
  std::vector<b2Body*> links_;
  b2Body* load_ = nullptr;
};

/// The same rope as a b2Rope: point masses, position-based dynamics, stretch only.
class Box2dRope {
 public:
  explicit Box2dRope(const b2RopeTuning& tuning);

  void step(float dt, int iterations) { rope_.Step(dt, iterations, b2Vec2_zero); }
  std::vector<b2Vec2> positions() const;

 private:
  b2Rope rope_;
};

/// Its tuning: stretch by `model`, without damping and bending. `hertz` is the stiffness of XPBD's stretch, as the
/// frequency of two points on a link.
b2RopeTuning without_bending(b2StretchingModel model, float hertz);

}  // namespace test_support
