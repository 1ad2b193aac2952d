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

}  // namespace ribbon
