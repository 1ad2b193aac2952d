#pragma once

#include <string>
#include <vector>

namespace study {

/// How the cords of a level are solved: what a sweep turns.
struct Dials {
  std::string solver = "direct";       ///< or thesis, box2d_chain, box2d_max_distance (tests/study/chain_mover.h)
  std::string integrator = "tr_bdf2";  ///< or implicit_euler; of the direct solver
  int substeps = 1;
  double tolerance = 5e-4;  ///< m, of the direct solver
  double points = 1.0;      ///< times the links that the level's cords have
  int iterations = 0;       ///< of Box2D's velocities a substep, of its chains; of positions 3/8 of it

  bool operator==(const Dials&) const = default;
};

/// tr_bdf2 substeps=1 tolerance=0.0005 points=x2
std::string name_of(const Dials& dials);

/// Whether chains of Box2D's joints are to stand in for the cords.
bool is_box2d(const Dials& dials);

/// Both integrators, 1 … 8 substeps, three tolerances; half and twice the points; the thesis's method; Box2D's
/// chains. `quick`: the presets, and one step away from them.
std::vector<Dials> grid(bool quick);

/// The converged motion of a cord of so many points: 64 or 128 substeps solved to the tenth of a micrometre, half as
/// many for `quick`.
Dials reference(double points, bool second, bool quick);

}  // namespace study
