#pragma once

#include <span>

#include "ribbon/thesis/mesh.h"

namespace ribbon {

// Corrections move points directly. Each is shared by the points' inverse masses w [1/kg], 0 for a driven point, so
// that the centre of mass of the free points stays where it is: Σ m·Δx = 0.

/// Spring correction (Goto 2017, Eqs. 3.20 and 3.21, with the direction normalised and shared by w): moves each
/// connection's ends along it by the share κ/(1 + κ) of its stretch, κ = (w_a + w_b)·stiffness·dt². Gauss–Seidel in
/// the order given. `stiffness` in N/m, above 0; `dt` in s.
void correct_springs(std::span<const Connection> connections, double stiffness, double dt,
                     std::span<const double> inverse_mass, std::span<Vec2> positions);

/// Area correction: a triangle whose signed area has fallen below `floor` of its rest area gets back the share
/// `stiffness` (0 … 1) of what it lacks. This keeps cells from collapsing and turning over.
void correct_areas(std::span<const Triangle> triangles, double floor, double stiffness,
                   std::span<const double> inverse_mass, std::span<Vec2> positions);

/// Half the cross product of two sides, m²; negative when the triangle has turned over.
double signed_area(Vec2 a, Vec2 b, Vec2 c);

}  // namespace ribbon
