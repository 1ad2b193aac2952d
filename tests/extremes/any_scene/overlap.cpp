// Overlaps at the start.

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/extremes/any_scene/oracles.h"
#include "tests/support/slot.h"

namespace any_scene {

using ribbon::Vec2;

namespace {

using test_support::slot;

/// Returns a solid's core as segments: a circle's centre, an edge, a box's sides.
std::vector<std::array<Vec2, 2>> sides(const Solid& solid, const Pose& pose) {
  const Vec2 h = solid.half;
  if (solid.shape == Shape::circle) return {{pose.position, pose.position}};
  if (solid.shape == Shape::edge) return {{pose.to_world({-h.x, 0.0}), pose.to_world({h.x, 0.0})}};
  const std::array<Vec2, 4> corners = {pose.to_world({-h.x, -h.y}), pose.to_world({h.x, -h.y}),
                                       pose.to_world({h.x, h.y}), pose.to_world({-h.x, h.y})};
  std::vector<std::array<Vec2, 2>> all;
  for (std::size_t k = 0; k < 4; ++k) all.push_back({corners[k], corners[(k + 1) % 4]});
  return all;
}

double roundness(const Solid& solid) { return solid.shape == Shape::circle ? solid.half.x : skin(solid); }

}  // namespace

double overlap(const Solid& a, const Solid& b) {
  const Pose pose_a = pose_of(a);
  const Pose pose_b = pose_of(b);
  const double inside = std::max(a.shape == Shape::box ? depth(a, pose_a, b.position, b.position) : -1.0,
                                 b.shape == Shape::box ? depth(b, pose_b, a.position, a.position) : -1.0);
  double between = std::numeric_limits<double>::infinity();
  for (const auto& s : sides(a, pose_a)) {
    for (const auto& t : sides(b, pose_b)) between = std::min(between, distance(s[0], s[1], t[0], t[1]));
  }
  return (inside > 0.0 ? inside : -between) + roundness(a) + roundness(b);
}

double overlap(const ribbon::CordDef& cord, const Outline& line, const Solid& solid) {
  const Pose pose = pose_of(solid);
  double deepest = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < line.links(); ++k) {
    deepest = std::max(deepest, depth(solid, pose, line.start(k), line.end(k)));
  }
  return deepest + cord.radius + (solid.shape == Shape::circle ? 0.0 : roundness(solid));
}

double Oracles::overlap(const Snapshot& now) const {
  double deepest = 0.0;
  const int cords = static_cast<int>(scene_.cords.size());
  const int solids = static_cast<int>(scene_.solids.size());
  for (int a = 0; a < cords; ++a) {
    const ribbon::CordDef& def = scene_.cords[slot(a)].def;
    for (int b = a; b < cords; ++b) {
      const double both = def.radius + scene_.cords[slot(b)].def.radius;
      deepest = std::max(deepest, both - nearest(a, b, now, both));
    }
    for (int s = 0; s < solids; ++s) {
      deepest = std::max(deepest, any_scene::overlap(def, now.cords[slot(a)], scene_.solids[slot(s)]));
    }
  }
  for (int a = 0; a < solids; ++a) {
    for (int b = a + 1; b < solids; ++b) {
      const Solid& first = scene_.solids[slot(a)];
      const Solid& second = scene_.solids[slot(b)];
      if (first.motion == Motion::fixed && second.motion == Motion::fixed) continue;
      deepest = std::max(deepest, any_scene::overlap(first, second));
    }
  }
  return deepest;
}

}  // namespace any_scene
