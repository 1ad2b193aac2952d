#pragma once

#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace ribbon {

/// A two-node connection between neighbouring points, a < b.
struct Connection {
  int a;               ///< index of a point
  int b;               ///< index of the other point
  double rest_length;  ///< m
};

/// Three points, counter-clockwise in the rest shape.
struct Triangle {
  int a;             ///< index of a point
  int b;             ///< index of the second point
  int c;             ///< index of the third point
  double rest_area;  ///< m²
};

/// The cord model of Goto 2017, section 3.1: w × h points on a regular grid, w along the cord and h across it.
/// Point P(i, j), 0 ≤ i < w, 0 ≤ j < h, has the index i·h + j, so that neighbours differ by at most h + 1 and the
/// stiffness matrix is a band. Everything here is fixed for the life of a cord.
struct Mesh {
  int w = 0;                            ///< points along the cord
  int h = 0;                            ///< points across it
  double spacing = 0.0;                 ///< m, between neighbours along and across
  std::vector<Connection> connections;  ///< each pair of the up to 8 neighbours once, ordered by a, then b
  std::vector<Triangle> triangles;      ///< two per cell, cut along the same diagonal in every cell
  std::vector<int> boundary;            ///< the outer boundary, counter-clockwise; the last point joins the first

  int size() const { return w * h; }                   ///< number of points
  int index(int i, int j) const { return i * h + j; }  ///< index of P(i, j)
  int column(int point) const { return point / h; }    ///< column i of a point
  int row(int point) const { return point % h; }       ///< row j of a point
};

/// Builds the mesh. Requires w, h ≥ 2 and spacing > 0 (ThesisDef checks them).
Mesh make_mesh(int w, int h, double spacing);

/// Returns the positions of a w × h grid along a path: one column every `spacing` metres of arc length from the first
/// path point; the last segment is extended if necessary. Rows lie across the path; j increases to its left. Requires
/// at least two different path points.
std::vector<Vec2> lay_along(std::span<const Vec2> path, int w, int h, double spacing);

}  // namespace ribbon
