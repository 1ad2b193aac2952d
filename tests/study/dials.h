#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ribbon/cord_def.h"

namespace study {

/// How the cords of a level are solved: what a sweep turns.
struct Dials {
  std::string solver = "direct";       ///< or thesis, box2d_chain, box2d_max_distance (tests/study/chain_mover.h)
  std::string integrator = "tr_bdf2";  ///< or implicit_euler; of the direct solver
  int substeps = 1;
  double tolerance = 5e-4;  ///< m, of the direct solver
  double points = 1.0;      ///< times the links that the level's cords have
  int iterations = 0;  ///< at most, of Newton's a solve (0: 8); of chains of Box2D's velocities a substep, and 3/8 of
                       ///< it of positions
  int rows = 1;        ///< of a ribbon to take the place of each rope

  bool operator==(const Dials&) const = default;
};

/// What decides to which motion a run converges.
struct Mesh {
  double points = 1.0;
  int rows = 1;

  bool operator==(const Mesh&) const = default;
  bool operator<(const Mesh& other) const { return std::pair(points, rows) < std::pair(other.points, other.rows); }
};

Mesh mesh_of(const Dials& dials);

/// tr_bdf2 substeps=1 tolerance=0.0005 points=x2
std::string name_of(const Dials& dials);

/// Of the direct solver.
ribbon::Accuracy accuracy_of(const Dials& dials);

/// Whether chains of Box2D's joints are to stand in for the cords.
bool is_box2d(const Dials& dials);

/// Both integrators, 1 … 8 substeps, three tolerances; few and many iterations; half and twice the points; two and
/// three rows; the thesis's method; Box2D's chains. `quick`: the presets, and one step away from them.
std::vector<Dials> grid(bool quick);

/// The converged motion of cords of such a mesh: 64 or 128 substeps solved to the tenth of a micrometre, half as
/// many for `quick` and for ribbons.
Dials reference(const Mesh& mesh, bool second, bool quick);

}  // namespace study
