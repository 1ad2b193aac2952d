#pragma once

#include <vector>

#include "ribbon/definition.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Defines a cord of the thesis's method. A term that stays at 0 or false is neither assembled nor run.
struct ThesisDef {
  int w = 25;                       ///< points along the cord, 2 … 1,000,000 / h
  int h = 2;                        ///< points across it, 2 … 64
  double spacing = 0.05;            ///< m, between neighbours at rest, 1e-6 … 1e6
  double point_mass = 0.002;        ///< kg per point, 1e-9 … 1e9
  double spring_stiffness = 190.0;  ///< N/m, Ks of Eq. 3.20 as a physical stiffness, 0 … 1e15; restores the shape
  double bar_damping = 5.0;         ///< N·s/m, η of the FEM bars, 0 … 1e15; use 1–10 times substeps·mass/dt
  double drag = 0.0;                ///< 1/s, decay rate of velocities, 0 … 1e6
  double area_stiffness = 0.5;  ///< share of the missing area of a compressed triangle that a substep restores, 0 … 1
  double area_floor = 0.3;      ///< share of the rest area below which a triangle is restored, 0 … 0.9
  bool self_collision = false;  ///< circles around the points collide with the cord's triangles
  double radius = 0.0;          ///< m, of the point circles, 0 … spacing / 2 (more would touch at rest); 0 takes
                                ///< 0.4 · spacing
  int substeps = 8;             ///< N of Fig. 3.6, 1 … 4096; more cost more and are more accurate

  /// m, initial positions of w·h points by index. If empty, the grid starts at the origin and extends along +x.
  std::vector<Vec2> positions;
  /// Indices of points that are fixed at their initial positions (red in Fig. 4.1).
  std::vector<int> pins;
};

/// Throws DefinitionError for the first field that is out of range.
void check(const ThesisDef& def);

}  // namespace ribbon
