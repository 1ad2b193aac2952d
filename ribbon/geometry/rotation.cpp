#include "ribbon/geometry/rotation.h"

#include <cmath>
#include <limits>

namespace ribbon {
namespace {

// 2π as the sum of two doubles.
constexpr double turn = 6.283185307179586;
constexpr double turn_remainder = 2.4492935982947064e-16;

/// Returns a modulo `turn` for a ≥ 0, without rounding: if two doubles differ by a factor of at most 2, their
/// difference is a double (Sterbenz 1974).
double modulo_turn(double a) {
  double turns = turn;
  while (turns <= 0.5 * a) turns *= 2.0;
  for (; turns >= turn; turns *= 0.5) {
    if (a >= turns) a -= turns;
  }
  return a;
}

/// Returns an angle of the same direction, at most two turns. Error: 1e-15 rad plus 1e-32 of the angle. Angles of up to
/// two turns and angles that are not finite are returned unchanged.
double within_two_turns(double angle) {
  while (std::abs(angle) > 2.0 * turn && std::abs(angle) <= std::numeric_limits<double>::max()) {
    const double size = std::abs(angle);
    const double left = modulo_turn(size);
    const double reduced = left - (size - left) / turn * turn_remainder;
    angle = angle < 0.0 ? -reduced : reduced;
  }
  return angle;
}

}  // namespace

/// Evaluates the series of sine and cosine for a 64th of the angle and doubles the angle six times.
Vec2 rotation(double angle) {
  const double a = within_two_turns(angle) / 64.0;
  const double a2 = a * a;
  Vec2 turned{1.0 - a2 / 2.0 * (1.0 - a2 / 12.0 * (1.0 - a2 / 30.0 * (1.0 - a2 / 56.0 * (1.0 - a2 / 90.0)))),
              a * (1.0 - a2 / 6.0 * (1.0 - a2 / 20.0 * (1.0 - a2 / 42.0 * (1.0 - a2 / 72.0))))};
  for (int k = 0; k < 6; ++k) turned = times(turned, turned);
  return (1.0 / length(turned)) * turned;
}

}  // namespace ribbon
