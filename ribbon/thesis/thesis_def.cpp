#include "ribbon/thesis/thesis_def.h"

#include <cmath>

namespace ribbon {

void check(const ThesisDef& def) {
  check_range("h", def.h, 2, 64);
  check_range("w", def.w, 2, std::floor(1e6 / def.h));
  check_range("spacing", def.spacing, 1e-6, 1e6);
  check_range("point_mass", def.point_mass, 1e-9, 1e9);
  check_range("spring_stiffness", def.spring_stiffness, 0.0, 1e15);
  check_range("bar_damping", def.bar_damping, 0.0, 1e15);
  check_range("drag", def.drag, 0.0, 1e6);
  check_range("area_stiffness", def.area_stiffness, 0.0, 1.0);
  check_range("area_floor", def.area_floor, 0.0, 0.9);
  check_range("radius", def.radius, 0.0, 0.5 * def.spacing);
  check_range("substeps", def.substeps, 1, 4096);
  check_points(def.w * def.h, def.positions, def.pins);
}

}  // namespace ribbon
