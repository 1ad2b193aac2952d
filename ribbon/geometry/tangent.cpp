#include "ribbon/geometry/tangent.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/geometry/rotation.h"

namespace ribbon {
namespace {

constexpr double min_length = 1e-3;  // of a line, in radii
constexpr double max_exponent = 40.0;

/// A line of length s touches the wheel at R·n, and runs along t = sense·perp(n). A point before it is at r = R·n −
/// s·t, one behind it at R·n + s·t. As complex numbers, r = n·(R ∓ i·sense·s), so n = r·(R ± i·sense·s)/|r|².
TangentLine line(Vec2 r, double radius, double sense, double side) {
  const double min = min_length * radius;
  const double size = std::sqrt(std::max(dot(r, r) - radius * radius, min * min));
  const Vec2 turned = times(r, {radius, side * sense * size});
  const double turned_size = length(turned);
  const Vec2 normal = turned_size > 0.0 ? (1.0 / turned_size) * turned : Vec2{1.0, 0.0};
  return {normal, sense * perp(normal), size};
}

}  // namespace

TangentLine arriving_line(Vec2 r, double radius, double sense) { return line(r, radius, sense, 1.0); }
TangentLine leaving_line(Vec2 r, double radius, double sense) { return line(r, radius, sense, -1.0); }

namespace {

TangentLine straight_line(Vec2 from_groove, double radius, Vec2 normal, double side) {
  const double size = std::max(length(from_groove), min_length * radius);
  return {normal, (side / size) * from_groove, size};
}

}  // namespace

TangentLine line_to_groove(Vec2 r, double radius, Vec2 normal) {
  return straight_line(r - radius * normal, radius, normal, -1.0);
}
TangentLine line_from_groove(Vec2 r, double radius, Vec2 normal) {
  return straight_line(r - radius * normal, radius, normal, 1.0);
}

/// Within a right angle, half of it has the tangent sin/(1 + cos). It is halved three times more, to at most a 16th of
/// a right angle, where the series of the arctangent converges fast.
double angle_between(Vec2 a, Vec2 b) {
  const double cosine = dot(a, b);
  const double sine = cross(a, b);
  if (cosine < 0.0) {
    constexpr double right = 0.5 * std::numbers::pi;
    return sine < 0.0 ? angle_between(-perp(a), b) - right : angle_between(perp(a), b) + right;
  }
  double t = sine / (1.0 + cosine);
  for (int k = 0; k < 3; ++k) t /= 1.0 + std::sqrt(1.0 + t * t);
  const double t2 = t * t;
  double series = 0.0;
  for (int k = 15; k >= 1; k -= 2) series = 1.0 / k - t2 * series;
  return 16.0 * t * series;
}

double exponential(double x) {
  const double part = std::min(x, max_exponent) / 256.0;
  double power = 1.0;
  for (int k = 10; k >= 1; --k) power = 1.0 + part / k * power;
  for (int k = 0; k < 8; ++k) power *= power;
  return power;
}

}  // namespace ribbon
