#pragma once

#include <box2d/box2d.h>

#include "ribbon/box2d/box2d.h"
#include "ribbon/ribbon.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

namespace ribbon::box2d {

/// A rope of 2 m at height y, fixed at both ends.
inline Cord rope(double y = 0.0) {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.positions = test_support::equally_spaced(def.points, {0.0, y}, {0.1, 0.0});
  def.pins = {0, 20};
  return Cord(def);
}

inline ThesisCord curtain() {
  ThesisDef def;
  def.pins = {0, 1};
  return ThesisCord(def);
}

struct RopeWorld : test_support::ShapeWorld {
  b2Body& ball(Vec2 position) { return *add_ball(position, 0.1, 0.3); }
};

}  // namespace ribbon::box2d
