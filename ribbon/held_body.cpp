#include "ribbon/held_body.h"

#include <algorithm>

#include "ribbon/complex.h"

namespace ribbon {

/// The series of sine and cosine for a 64th of the angle, six times doubled: within 5e-14 up to two turns.
Vec2 rotation(double angle) {
  const double a = angle / 64.0;
  const double a2 = a * a;
  Vec2 turned{1.0 - a2 / 2.0 * (1.0 - a2 / 12.0 * (1.0 - a2 / 30.0 * (1.0 - a2 / 56.0 * (1.0 - a2 / 90.0)))),
              a * (1.0 - a2 / 6.0 * (1.0 - a2 / 20.0 * (1.0 - a2 / 42.0 * (1.0 - a2 / 72.0))))};
  for (int k = 0; k < 6; ++k) turned = times(turned, turned);
  return (1.0 / length(turned)) * turned;
}

Vec2 HeldBody::arm_at(double angle) const { return times(rotation(angle), arm + share * travel); }

CarriedLoad HeldStep::load(std::size_t point, Vec2 residual) const {
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
