#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "ribbon/elastic/stage.h"
#include "ribbon/rigid_circle.h"

namespace ribbon {

/// A grip: a body that holds a place of a cord. In the solve of a single cord, whose grips are at points, its centre of
/// mass X = x − s follows from the point x and the arm s, from the centre of mass to the anchor, turned by φ. So the
/// body adds one unknown, φ, which is eliminated at that point. With M = m/q², J = I/q² (q: see Stage), R and P the
/// residuals of X and φ, u = perp(s) = −∂X/∂φ and p = P − u·R:
///
///     D = J + M·|s|² + max(0, −R·s)                the last term geometric: of an arm that is pulled outwards
///     A_x ← A_x + M − M²·u·uᵀ/D        r_x ← r_x + R + M·u·p/D        δφ = (p + M·u·δx)/D
///
/// A body that does not turn has D = ∞.
struct HeldBody {
  std::size_t point = 0;         ///< slot; the grip is between this point
  std::size_t next = 0;          ///< and this one,
  double along = 0.0;            ///< at this share of the link
  std::size_t grip = 0;          ///< index into the grips of the cord
  int rigid_index = 0;           ///< index into the bodies of the step
  std::size_t solved_index = 0;  ///< index into the bodies that are solved with the cord
  bool turns = true;             ///< its moment of inertia is finite
  Vec2 arm;                      ///< m, s at the start of the step
  Vec2 travel;                ///< m, displacement of the anchor on the body in the step, in the directions of its start
  double share = 0.0;         ///< of the step that has gone by at the end of the stage, 0 … 1
  double column = 0.0;        ///< position along the cord at the start of the step
  double climb = 0.0;         ///< columns, displacement along the cord in the step
  double displacement = 0.0;  ///< m, of the anchor in the step, on the body and along the cord
  double strength = std::numeric_limits<double>::infinity();  ///< N, above which it slips
  bool returns = false;                                       ///< its anchor was pushed off its place
  Vec2 across;               ///< unit vector, in which it is held while it slips; zero: across its link
  double ahead = 0.0;        ///< m along the cord, by which its place is ahead of where it is; see aim_slips
  double slip_sign = 0.0;    ///< sign of the force along the cord with which it slips; 0 if it sticks
  bool limited = false;      ///< a limited row holds it along the cord, because contacts are linearised once
  double slip_force = 0.0;   ///< N, on the body along the cord, by that row
  double slid = 0.0;         ///< columns, slip along the cord in the step
  double slid_before = 0.0;  ///< columns, the part of it that the place has followed; see follow_slips
  /// N, of a grip that a bend catches: by how much the tension behind it was greater than the one before it, where they
  /// differed most at the end of a substep.
  double pulled = 0.0;
  Vec2 beside;  ///< m, Grip::beside, in directions of the start of the step

  Vec2 arm_at(double angle) const;
  bool may_slip() const { return strength < std::numeric_limits<double>::infinity(); }
  bool is_fixed_at_point() const { return along == 0.0 && climb == 0.0 && !may_slip(); }
  /// Where the cord is held, m.
  Vec2 hold(std::span<const Vec2> x) const { return x[point] + along * (x[next] - x[point]); }
};

/// A body's part in a Newton step.
struct HeldStep {
  Vec2 u;             ///< m
  double inertia;     ///< M, N/m
  double moment;      ///< p, N·m
  double compliance;  ///< 1/D, 1/(N·m)

  /// What the body adds to the point that it holds.
  CondensedBody load(std::size_t point, Vec2 residual) const;
  /// δφ for a step of the point.
  double turning(Vec2 step) const { return compliance * (moment + inertia * dot(u, step)); }
};

/// Returns the step for `arm` s, inertias M and J, and the residuals of X [N] and φ [N·m].
HeldStep held_step(const HeldBody& held, Vec2 arm, double inertia, double angular_inertia, Vec2 residual,
                   double angular_residual);

}  // namespace ribbon
