#pragma once

#include <span>

#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/thesis/mesh.h"

namespace ribbon {

/// Adds the stiffness of the bar between points a < b to the global matrix (Goto 2017, Eqs. 3.9 and 3.12–3.14):
/// k·[cc cs −cc −cs; cs ss −cs −ss; …] with (c, s) = direction, a unit vector, and k in N/m. Unknowns 2a, 2a + 1 are
/// the x and y of point a. A driven end (free_a or free_b false) has its rows and columns left out, Eq. 3.15 with the
/// diagonal kept as it is.
void add_bar_stiffness(BandedMatrix& matrix, int a, int b, Vec2 direction, double k, bool free_a, bool free_b);

/// The force in newtons with which a bar of stiffness k pulls its end a when its ends have moved by u_a and u_b
/// metres; its other end feels the opposite. This is −K·u of Eq. 3.17, the restoring sign.
Vec2 bar_force(Vec2 direction, double k, Vec2 u_a, Vec2 u_b);

}  // namespace ribbon
