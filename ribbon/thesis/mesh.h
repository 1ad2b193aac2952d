#pragma once

#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace ribbon {

/// A two-node connection between neighbouring points, a < b.
struct Connection {
  int a;               ///< index of a point
  int b;               ///< of the other
  double rest_length;  ///< m
};

/// Three points, counter-clockwise in the rest shape.
struct Triangle {
  int a;             ///< index of a point
  int b;             ///< of the next
  int c;             ///< of the last
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
  std::vector<Triangle> triangles;      ///< two a cell, cut along the same diagonal in every cell
  std::vector<int> boundary;            ///< the outer boundary, counter-clockwise; the last point joins the first

  int size() const { return w * h; }                   ///< how many points
  int index(int i, int j) const { return i * h + j; }  ///< of P(i, j)
  int column(int point) const { return point / h; }    ///< i of a point
  int row(int point) const { return point % h; }       ///< j of a point
};

/// Builds the model. w, h ≥ 2 and spacing > 0 are the caller's to ensure (ThesisDef checks them).
Mesh make_mesh(int w, int h, double spacing);

/// Positions of a w × h grid whose middle line follows `path` by arc length, one column every `spacing` metres from
/// the first path point on; past the end the last segment goes on straight. Rows lie across the path, j upwards to
/// its left. Needs at least two path points that differ.
std::vector<Vec2> lay_along(std::span<const Vec2> path, int w, int h, double spacing);

}  // namespace ribbon
