#pragma once

#include "ribbon/cord_def.h"

namespace test_support {

/// Returns a rope of `length` [m] that is pinned at the origin and hangs straight down.
inline ribbon::CordDef hanging(int points, double length) {
  ribbon::CordDef def;
  def.points = points;
  def.length = length;
  def.pins = {0};
  for (int p = 0; p < points; ++p) def.positions.push_back({0.0, -length * p / (points - 1)});
  return def;
}

}  // namespace test_support
