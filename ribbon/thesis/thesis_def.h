#pragma once

#include <vector>

#include "ribbon/definition.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// What a cord of the thesis's method is made of. Every term that stays at 0 or false is neither assembled nor run.
struct ThesisDef {
  int w = 25;                       ///< points along the cord, 2 … 1,000,000 / h
  int h = 2;                        ///< points across it, 2 … 64
  double spacing = 0.05;            ///< m, between neighbours at rest, 1e-6 … 1e6
  double point_mass = 0.002;        ///< kg a point, 1e-9 … 1e9
  double spring_stiffness = 190.0;  ///< N/m, Ks of Eq. 3.20 as a physical stiffness, 0 … 1e15: the memory of shape
  double bar_damping = 5.0;     ///< N·s/m, η of the FEM bars, 0 … 1e15: 1–10 times substeps·mass/dt behaves well
  double drag = 0.0;            ///< 1/s, rate at which free motion dies away, 0 … 1e6
  double area_stiffness = 0.5;  ///< share of a squashed triangle's missing area given back a substep, 0 … 1
  double area_floor = 0.3;      ///< of the rest area, below which a triangle counts as squashed, 0 … 0.9
  bool self_collision = false;  ///< point circles against the cord's own triangles
  double radius = 0.0;          ///< m, of the point circles, 0 … spacing / 2 (more would touch at rest); 0 takes
                                ///< 0.4 · spacing
  int substeps = 8;             ///< N of Fig. 3.6, 1 … 4096: accuracy for time

  /// Initial positions by index, w·h of them; empty lays the grid out from the origin along +x.
  std::vector<Vec2> positions;
  /// Points constrained to where they start (red in Fig. 4.1), by index.
  std::vector<int> pins;
};

/// Throws DefinitionError at the first field that is out of its range; changes nothing.
void check(const ThesisDef& def);

}  // namespace ribbon
