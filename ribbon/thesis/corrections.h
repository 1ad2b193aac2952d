#pragma once

#include <span>

#include "ribbon/thesis/mesh.h"

namespace ribbon {

// A correction moves points directly, in proportion to their inverse masses w [1/kg], 0 for a driven point. So the
// centre of mass of free points does not move: Σ m·Δx = 0.

/// Corrects the lengths of connections: Goto 2017, Eqs. 3.20 and 3.21, with a unit direction and shares by w. The ends
/// of a connection move along it by the share κ/(1 + κ) of its stretch, κ = (w_a + w_b)·stiffness·dt². Gauss–Seidel in
/// the given order. `stiffness` is in N/m, above 0, `dt` in s.
void correct_springs(std::span<const Connection> connections, double stiffness, double dt,
                     std::span<const double> inverse_mass, std::span<Vec2> positions);

/// Corrects the areas of triangles: if the signed area is below the share `floor` of the rest area, it restores the
/// share `stiffness` (0 … 1) of the missing area. So cells do not collapse or invert.
void correct_areas(std::span<const Triangle> triangles, double floor, double stiffness,
                   std::span<const double> inverse_mass, std::span<Vec2> positions);

/// Returns the signed area of a triangle, m²; negative if it is inverted.
double signed_area(Vec2 a, Vec2 b, Vec2 c);

}  // namespace ribbon
