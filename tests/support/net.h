#pragma once

#include <box2d/box2d.h>

#include "ribbon/box2d/coupling.h"
#include "ribbon/cord_def.h"

namespace test_support {

/// A net of 20 × 20 cords that are tied at 400 places. It hangs from its upper corners, which move towards each other
/// in the first second.
struct Net {
  static constexpr int cords = 20;          ///< each way
  static constexpr double mesh = 0.2;       ///< m
  static constexpr double dt = 1.0 / 60.0;  ///< s

  explicit Net(const ribbon::Accuracy& accuracy);
  /// Advances net and world; in parts for what is timed.
  void tick_cords();
  void tick_world() { world.Step(static_cast<float>(dt), 8, 3); }
  void tick();
  /// Drops a ball of 0.2 m radius into its middle.
  void drop_ball(double mass);
  /// Returns the largest strain of a link.
  double strain() const;

  b2World world{b2Vec2(0.0F, -9.81F)};
  ribbon::box2d::Coupling coupling;
  b2Body* ball = nullptr;
  int ticks = 0;
};

}  // namespace test_support
