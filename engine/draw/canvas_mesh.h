#pragma once

#include <span>
#include <vector>

#include "engine/draw/line_profile.h"
#include "ribbon/vec2.h"

namespace engine {

/// A corner of a mesh, in pixels. `cover` is the fraction of a pixel that the shape covers, 0 … 1, interpolated over
/// the triangle. For antialiasing, shapes have a border one pixel wide in which it falls to 0.
struct MeshVertex {
  ribbon::Vec2 at;
  double cover = 1.0;
};

/// A straight piece of a line, with square ends. The cover depends on the distance from its middle line.
struct MeshBar {
  ribbon::Vec2 from, to;  ///< px, apart
  Profile profile;
};

/// A circle. The cover depends on the distance from it; a circle of radius 0 is a disc.
struct MeshRing {
  ribbon::Vec2 center;  ///< px
  double radius;        ///< px
  Profile profile;
};

/// Triangles, three indices each, in either order; bars and rings, which cost a fraction of the triangles that they
/// replace. Where these overlap, the largest cover counts.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<int> indices;
  std::vector<MeshBar> bars;
  std::vector<MeshRing> rings;

  bool is_empty() const { return indices.empty() && bars.empty() && rings.empty(); }
  void clear() {
    vertices.clear();
    indices.clear();
    bars.clear();
    rings.clear();
  }
};

/// Returns whether all indices are in range, all lengths within ±1e12 px, all covers within 0 … 1 and all bars and
/// rings have a size.
bool is_paintable(const Mesh& mesh);

/// The functions below add a shape in pixels. They add nothing for input that is not finite, beyond ±1e12 px or without
/// size, and no triangle without area. Lines, discs and rings add bars and rings, the others triangles.
void add_disc(Mesh& mesh, ribbon::Vec2 center, double radius);
/// An annulus of `width`, centred on the circle.
void add_ring(Mesh& mesh, ribbon::Vec2 center, double radius, double width);
/// A line with round joints and ends through at least two distinct points.
void add_polyline(Mesh& mesh, std::span<const ribbon::Vec2> points, double width);
/// A convex polygon, in either order.
void add_convex(Mesh& mesh, std::span<const ribbon::Vec2> corners);
/// Triangles with a rim one pixel wide outside the boundary of their union. Adds nothing if an index is out of range.
void add_triangles(Mesh& mesh, std::span<const ribbon::Vec2> vertices, std::span<const int> indices);
/// An axis-aligned rectangle with round corners.
void add_rounded_rectangle(Mesh& mesh, ribbon::Vec2 corner, ribbon::Vec2 size, double corner_radius);

}  // namespace engine
