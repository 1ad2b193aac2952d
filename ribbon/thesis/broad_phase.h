#pragma once

#include <span>
#include <vector>

#include "ribbon/geometry/quadtree.h"
#include "ribbon/thesis/mesh.h"

namespace ribbon {

/// Which of a cord's triangles a circle may touch: a list for each circle, found through the quadtree with some slack
/// and kept until something has moved by half of it. All memory is taken in `reserve`.
class BroadPhase {
 public:
  /// With `circles_are_points` circle k belongs to point k of the mesh, and the triangles of the cells around that
  /// point are left out: they would touch it at rest.
  BroadPhase(const Mesh& mesh, bool circles_are_points);

  /// Takes the memory for up to this many circles.
  void reserve(std::size_t circles);

  /// Starts a step: the next update makes the lists anew, so that no result depends on steps gone by.
  void begin() { stale_ = true; }

  /// Makes the lists again if a point or a circle has moved more than half the slack since they were made.
  void update(std::span<const Vec2> positions, std::span<const Vec2> centers, std::span<const double> radii);

  /// The triangles, in rising order, that circle k of the last update may touch: none that it touches is missing.
  std::span<const int> near(std::size_t k) const;

  /// True for a triangle of the cells around the circle's own point.
  bool is_own(std::size_t k, int triangle) const;

  /// How often lists were made since the beginning.
  int builds() const { return builds_; }

 private:
  std::size_t room_for(std::size_t circles) const;
  bool moved_too_far(std::span<const Vec2> positions, std::span<const Vec2> centers) const;
  void build(std::span<const Vec2> positions, std::span<const Vec2> centers, std::span<const double> radii);
  bool list_around(std::size_t k, Vec2 center, double radius);

  const Mesh* mesh_;
  bool circles_are_points_;
  double slack_;  // m
  Quadtree tree_;
  std::vector<Box> boxes_;
  std::vector<Vec2> positions_then_;
  std::vector<Vec2> centers_then_;
  std::size_t room_ = 0;                 // for list entries, whatever more memory there may be
  std::vector<int> list_;                // one circle's triangles after the other's
  std::vector<std::size_t> list_start_;  // of each circle that found room, and the end of the last
  std::vector<int> all_;                 // every triangle, for circles that found no room
  bool stale_ = true;
  int builds_ = 0;
};

}  // namespace ribbon
