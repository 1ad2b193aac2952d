#pragma once

#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace engine {

/// A corner of a mesh, in pixels. `cover` is how much of a pixel the shape takes here, 0 to 1, interpolated over the
/// triangle: shapes get a border one pixel wide along which it falls to 0, and that is the antialiasing.
struct MeshVertex {
  ribbon::Vec2 at;
  double cover = 1.0;
};

/// Triangles, three indices each, in either order. They may overlap: the largest cover counts.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<int> indices;

  void clear() {
    vertices.clear();
    indices.clear();
  }
};

/// True if all indices are in range and all numbers such that it can be painted.
bool is_paintable(const Mesh& mesh);

/// These add a shape to a mesh, all in pixels. Input that is not finite (beyond 1e12 pixels counts as such) or has no
/// size adds nothing; no triangle without area is ever added.
void add_disc(Mesh& mesh, ribbon::Vec2 center, double radius);
/// The annulus of this width along the middle of a circle's rim.
void add_ring(Mesh& mesh, ribbon::Vec2 center, double radius, double width);
/// A line with round joints and ends, through two or more points in different places.
void add_polyline(Mesh& mesh, std::span<const ribbon::Vec2> points, double width);
/// A convex polygon, in either order.
void add_convex(Mesh& mesh, std::span<const ribbon::Vec2> corners);
/// Triangles with a rim one pixel wide outside their common boundary. Adds nothing if an index is out of range.
void add_triangles(Mesh& mesh, std::span<const ribbon::Vec2> vertices, std::span<const int> indices);
/// An axis-aligned rectangle with round corners.
void add_rounded_rectangle(Mesh& mesh, ribbon::Vec2 corner, ribbon::Vec2 size, double corner_radius);

}  // namespace engine
