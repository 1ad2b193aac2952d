#pragma once

#include <span>

#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/thesis/mesh.h"

namespace ribbon {

/// Adds the stiffness of the bar between points a < b to the global matrix (Goto 2017, Eqs. 3.9 and 3.12–3.14):
/// k·[cc cs −cc −cs; cs ss −cs −ss; …] with the unit vector (c, s) = direction, and k in N/m. Unknowns 2a and 2a + 1
/// are x and y of point a. The rows and columns of a driven end (free_a or free_b is false) are left out: Eq. 3.15
/// without a change of the diagonal.
void add_bar_stiffness(BandedMatrix& matrix, int a, int b, Vec2 direction, double k, bool free_a, bool free_b);

/// Returns the force [N] of a bar of stiffness k [N/m] on its end a, if its ends have moved by u_a and u_b [m]; the
/// force on b is the opposite. This is −K·u, Eq. 3.17 with the restoring sign.
Vec2 bar_force(Vec2 direction, double k, Vec2 u_a, Vec2 u_b);

}  // namespace ribbon
