#include "ribbon/system/held_body.h"

#include <algorithm>

#include "ribbon/geometry/rotation.h"

namespace ribbon {

Vec2 HeldBody::arm_at(double angle) const { return times(rotation(angle), arm + share * travel); }

CondensedBody HeldStep::load(std::size_t point, Vec2 residual) const {
  const double along = -inertia * inertia * compliance;
  return {point,
          {inertia + along * u.x * u.x, along * u.x * u.y, inertia + along * u.y * u.y},
          residual + (inertia * compliance * moment) * u};
}

HeldStep held_step(const HeldBody& held, Vec2 arm, double inertia, double angular_inertia, Vec2 residual,
                   double angular_residual) {
  const Vec2 u = perp(arm);
  const double stiffness = angular_inertia + inertia * dot(arm, arm) + std::max(0.0, -dot(residual, arm));
  return {u, inertia, angular_residual - dot(u, residual), held.turns ? 1.0 / stiffness : 0.0};
}

}  // namespace ribbon
