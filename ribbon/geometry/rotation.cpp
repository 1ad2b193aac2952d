#include "ribbon/geometry/rotation.h"

#include <cmath>
#include <limits>

namespace ribbon {
namespace {

// 2π is the sum of both.
constexpr double turn = 6.283185307179586;
constexpr double rest_of_turn = 2.4492935982947064e-16;

/// a modulo `turn` for a ≥ 0. Nothing is rounded: of two numbers that differ by a factor of 2 at the most the
/// difference is a double (Sterbenz 1974).
double modulo_turn(double a) {
  double turns = turn;
  while (turns <= 0.5 * a) turns *= 2.0;
  for (; turns >= turn; turns *= 0.5) {
    if (a >= turns) a -= turns;
  }
  return a;
}

/// The same direction by an angle of up to two turns. Within 1e-15 rad plus 1e-32 of the angle; one of up to two turns
/// is returned as it is, and so is one that is not finite.
double within_two_turns(double angle) {
  while (std::abs(angle) > 2.0 * turn && std::abs(angle) <= std::numeric_limits<double>::max()) {
    const double size = std::abs(angle);
    const double left = modulo_turn(size);
    const double reduced = left - (size - left) / turn * rest_of_turn;
    angle = angle < 0.0 ? -reduced : reduced;
  }
  return angle;
}

}  // namespace

/// The series of sine and cosine for a 64th of the angle, six times doubled.
Vec2 rotation(double angle) {
  const double a = within_two_turns(angle) / 64.0;
  const double a2 = a * a;
  Vec2 turned{1.0 - a2 / 2.0 * (1.0 - a2 / 12.0 * (1.0 - a2 / 30.0 * (1.0 - a2 / 56.0 * (1.0 - a2 / 90.0)))),
              a * (1.0 - a2 / 6.0 * (1.0 - a2 / 20.0 * (1.0 - a2 / 42.0 * (1.0 - a2 / 72.0))))};
  for (int k = 0; k < 6; ++k) turned = times(turned, turned);
  return (1.0 / length(turned)) * turned;
}

}  // namespace ribbon
