#include "game/simulation/sweep.h"

#include <array>
#include <cmath>
#include <limits>

namespace game {
namespace {

using ribbon::Vec2;

/// Returns the solutions of c0 + c1·t + c2·t² = 0, in rising order; NaN for those that do not exist.
std::array<double, 2> roots(double c0, double c1, double c2) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (c2 == 0.0) return {c1 == 0.0 ? none : -c0 / c1, none};
  const double square = c1 * c1 - 4.0 * c2 * c0;
  if (square < 0.0) return {none, none};
  const double q = -0.5 * (c1 + std::copysign(std::sqrt(square), c1));
  const double one = q / c2;
  const double other = q == 0.0 ? one : c0 / q;
  return one < other ? std::array{one, other} : std::array{other, one};
}

/// Returns the first meeting of a moving point with a moving segment. They meet while the point is in line with the
/// segment: cross(b − a, p − a) = 0, a polynomial of degree two in time.
std::optional<Meeting> first_meeting(Vec2 p_from, Vec2 p_to, const Segment& from, const Segment& to) {
  const Vec2 d0 = from.b - from.a;
  const Vec2 d1 = (to.b - to.a) - d0;
  const Vec2 e0 = p_from - from.a;
  const Vec2 e1 = (p_to - to.a) - e0;
  for (const double t : roots(cross(d0, e0), cross(d0, e1) + cross(d1, e0), cross(d1, e1))) {
    if (!(t > 0.0 && t <= 1.0)) continue;
    const Vec2 d = d0 + t * d1;
    const double place = dot(e0 + t * e1, d) / dot(d, d);
    if (place >= 0.0 && place <= 1.0) return Meeting{t, place};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Meeting> swept_crossing(const Segment& from, const Segment& to, const Segment& edge_from,
                                      const Segment& edge_to) {
  std::optional<Meeting> first;
  const auto take = [&first](const std::optional<Meeting>& found, std::optional<double> place) {
    if (found && (!first || found->time < first->time)) first = Meeting{found->time, place.value_or(found->place)};
  };
  take(first_meeting(edge_from.a, edge_to.a, from, to), {});
  take(first_meeting(edge_from.b, edge_to.b, from, to), {});
  take(first_meeting(from.a, to.a, edge_from, edge_to), 0.0);
  take(first_meeting(from.b, to.b, edge_from, edge_to), 1.0);
  return first;
}

}  // namespace game
