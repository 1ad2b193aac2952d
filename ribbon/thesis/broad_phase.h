#pragma once

#include <span>
#include <vector>

#include "ribbon/geometry/quadtree.h"
#include "ribbon/thesis/mesh.h"

namespace ribbon {

/// Lists the triangles of a cord that each circle may touch: a Verlet list with a skin, found with a quadtree. The
/// lists stay valid until a point or circle has moved by half the skin. Only the constructor and `reserve` allocate
/// memory.
class BroadPhase {
 public:
  /// Creates the lists of a mesh. With `circles_are_points`, circle k belongs to point k of the mesh; its list leaves
  /// out the triangles of the cells around that point, which would touch it at rest.
  BroadPhase(const Mesh& mesh, bool circles_are_points);

  /// Allocates memory for up to this many circles.
  void reserve(std::size_t circles);

  /// Starts a step: the next update builds the lists. So no result depends on earlier steps.
  void begin() { stale_ = true; }

  /// Builds the lists if a point or circle has moved by more than half the skin since the last build.
  void update(std::span<const Vec2> positions, std::span<const Vec2> centers, std::span<const double> radii);

  /// Returns the triangles that circle k of the last update may touch, in ascending order. It includes all that it
  /// touches.
  std::span<const int> near(std::size_t k) const;

  /// Returns whether the triangle belongs to a cell around the point of circle k.
  bool is_own(std::size_t k, int triangle) const;

  /// Returns the number of builds so far.
  int builds() const { return builds_; }

 private:
  std::size_t capacity_for(std::size_t circles) const;
  bool moved_too_far(std::span<const Vec2> positions, std::span<const Vec2> centers) const;
  void build(std::span<const Vec2> positions, std::span<const Vec2> centers, std::span<const double> radii);
  bool list_near(std::size_t k, Vec2 center, double radius);

  const Mesh* mesh_;
  bool circles_are_points_;
  double skin_;  // m
  Quadtree tree_;
  std::vector<Box> boxes_;
  std::vector<Vec2> built_positions_;
  std::vector<Vec2> built_centers_;
  std::size_t capacity_ = 0;             // of list_; does not depend on how much memory it has
  std::vector<int> list_;                // triangles, circle by circle
  std::vector<std::size_t> list_start_;  // index in list_ of each circle with a complete list, and the end of the last
  std::vector<int> all_;                 // all triangles: the list of all other circles
  bool stale_ = true;
  int builds_ = 0;
};

}  // namespace ribbon
