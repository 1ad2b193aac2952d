#include "engine/replay/cord_extremes.h"

#include <cmath>
#include <limits>

namespace engine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The maximum of two numbers; infinity if `b` is NaN.
double greater(double a, double b) { return std::isnan(b) ? infinity : b > a ? b : a; }

}  // namespace

double largest_stretch(const ribbon::Cord& cord) {
  const auto x = cord.positions();
  const auto rows = static_cast<std::size_t>(cord.def().rows);
  double max_stretch = -infinity;
  for (std::size_t p = rows; p < x.size(); ++p) {
    const double rest = cord.rest_length(static_cast<int>(p / rows) - 1);
    max_stretch = greater(max_stretch, length(x[p] - x[p - rows]) / rest - 1.0);
  }
  return max_stretch;
}

double largest_speed(const ribbon::Cord& cord) {
  double max_speed = 0.0;
  for (const ribbon::Vec2 velocity : cord.velocities()) max_speed = greater(max_speed, length(velocity));
  return max_speed;
}

bool is_finite(const ribbon::Cord& cord) {
  const auto all_finite = [](std::span<const ribbon::Vec2> vectors) {
    for (const ribbon::Vec2 v : vectors) {
      if (!std::isfinite(v.x) || !std::isfinite(v.y)) return false;
    }
    return true;
  };
  return all_finite(cord.positions()) && all_finite(cord.velocities());
}

}  // namespace engine
