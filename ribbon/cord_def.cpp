#include "ribbon/cord_def.h"

#include <cmath>

namespace ribbon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check_cells(const CordDef& def) {
  if (def.rows != 2 || def.elements == Elements::bars) {
    if (def.cell_stiffness != 0.0) refuse("cell_stiffness", def.cell_stiffness, "0 unless two rows have cells");
  } else if (!(def.cell_stiffness == 0.0)) {
    check_range("cell_stiffness", def.cell_stiffness, 1e-12 * def.stretch_stiffness, def.stretch_stiffness);
  }
}

void check_rope(const CordDef& def) {
  if (def.width != 0.0) refuse("width", def.width, "0 for a rope (rows is 1); its thickness is radius");
  if (def.poisson_ratio != 0.0) refuse("poisson_ratio", def.poisson_ratio, "0 for a rope (rows is 1)");
  if (def.area_stiffness != 0.0) refuse("area_stiffness", def.area_stiffness, "0 for a rope (rows is 1)");
  if (def.elements != Elements::cells) refuse("elements", 1, "0 (cells) for a rope (rows is 1)");
  if (def.points == 2 && def.bending_stiffness > 0.0) {
    refuse("bending_stiffness", def.bending_stiffness, "0 for a rope of two points");
  }
}

void check_ribbon(const CordDef& def) {
  check_range("width", def.width, 1e-6, 1e6);
  if (def.stretch_stiffness == infinity) {
    refuse("stretch_stiffness", def.stretch_stiffness, "1e-06 to 1e+18 for a ribbon (rows is above 1)");
  }
  if (def.tension_only) refuse("tension_only", 1, "0 (false) for a ribbon (rows is above 1)");
  if (def.elements == Elements::bars) {
    if (def.bending_stiffness != 0.0)
      refuse("bending_stiffness", def.bending_stiffness, "0 with bars, which bend as they do");
    if (def.poisson_ratio != 0.0) refuse("poisson_ratio", def.poisson_ratio, "0 with bars");
    if (def.area_stiffness != 0.0) refuse("area_stiffness", def.area_stiffness, "0 with bars");
  } else if (def.rows > 2) {
    const double solid = def.stretch_stiffness * def.width * def.width / 12.0;
    // The limit is a trillionth higher, because solid() computes the same product in another order.
    if (!(def.bending_stiffness > 0.0 && def.bending_stiffness <= solid * (1.0 + 1e-12))) {
      check_range("bending_stiffness", def.bending_stiffness, 1e-12 * solid, solid);
    }
  }
}

}  // namespace

void check(const Accuracy& accuracy) {
  check_range("accuracy.substeps", accuracy.substeps, 1, 4096);
  check_range("accuracy.max_iterations", accuracy.max_iterations, 1, 1000);
  check_range("accuracy.tolerance", accuracy.tolerance, 1e-12, 1.0);
  check_range("accuracy.max_work", accuracy.max_work, 1, 1e6);
}

bool feels_medium(const CordDef& def) {
  return def.drag_across > 0.0 || def.drag_along > 0.0 || def.displaced_area > 0.0;
}

void check_size(const CordDef& def) {
  check_range("rows", def.rows, 1, 64);
  check_range("points", def.points, 2, std::floor(1e6 / def.rows));
}

void check(const CordDef& def) {
  check_size(def);
  check_range("length", def.length, 1e-6, 1e6);
  check_range("radius", def.radius, 0.0, 1e6);
  check_range("mass_per_length", def.mass_per_length, 1e-12, 1e12);
  if (!(def.stretch_stiffness == infinity)) check_range("stretch_stiffness", def.stretch_stiffness, 1e-6, 1e18);
  check_range("bending_stiffness", def.bending_stiffness, 0.0, 1e18);
  check_range("poisson_ratio", def.poisson_ratio, -0.9, 0.9);
  check_range("area_stiffness", def.area_stiffness, 0.0, 1e3);
  check_range("damping", def.damping, 0.0, 1e3);
  check_range("drag", def.drag, 0.0, 1e6);
  check_range("gravity_scale", def.gravity_scale, -1e3, 1e3);
  check_range("drag_across", def.drag_across, 0.0, 1e3);
  check_range("drag_along", def.drag_along, 0.0, 1e3);
  check_range("displaced_area", def.displaced_area, 0.0, 1e12);
  if (!(def.breaking_force > 0.0)) refuse("breaking_force", def.breaking_force, "above 0, up to infinity");
  check_range("friction", def.friction, 0.0, 10.0);
  check_range("restitution", def.restitution, 0.0, 1.0);
  check(def.accuracy);
  def.rows == 1 ? check_rope(def) : check_ribbon(def);
  check_cells(def);
  check_points(def.points * def.rows, def.positions, def.pins);
}

void RibbonMaterial::apply_to(CordDef& def) const {
  def.stretch_stiffness = stretch_stiffness;
  def.bending_stiffness = bending_stiffness;
  def.poisson_ratio = poisson_ratio;
}

RibbonMaterial solid(double youngs_modulus, double poisson_ratio, double thickness, double width) {
  check_range("youngs_modulus", youngs_modulus, 1e-12, 1e18);
  check_range("poisson_ratio", poisson_ratio, -0.9, 0.9);
  check_range("thickness", thickness, 1e-12, 1e18);
  check_range("width", width, 1e-6, 1e6);
  const double modulus = youngs_modulus * thickness;
  return {modulus * width, modulus * width * width * width / 12.0, poisson_ratio};
}

RibbonMaterial solid_of_shear_and_area(double shear, double area, double width) {
  check_range("shear", shear, 1e-12, 1e18);
  check_range("area", area, 1e-12, 1e18);
  return solid(4.0 * shear * area / (shear + area), (area - shear) / (area + shear), 1.0, width);
}

}  // namespace ribbon
