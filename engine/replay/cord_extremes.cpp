#include "engine/replay/cord_extremes.h"

#include <cmath>
#include <limits>

namespace engine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The greater of two; infinity if the second is not a number.
double greater(double a, double b) { return std::isnan(b) ? infinity : b > a ? b : a; }

}  // namespace

double largest_stretch(const ribbon::Cord& cord) {
  const auto x = cord.positions();
  const auto rows = static_cast<std::size_t>(cord.def().rows);
  double most = -infinity;
  for (std::size_t p = rows; p < x.size(); ++p) {
    const double rest = cord.rest_length(static_cast<int>(p / rows) - 1);
    most = greater(most, length(x[p] - x[p - rows]) / rest - 1.0);
  }
  return most;
}

double largest_speed(const ribbon::Cord& cord) {
  double most = 0.0;
  for (const ribbon::Vec2 velocity : cord.velocities()) most = greater(most, length(velocity));
  return most;
}

bool is_finite(const ribbon::Cord& cord) {
  const auto holds = [](std::span<const ribbon::Vec2> vectors) {
    for (const ribbon::Vec2 v : vectors) {
      if (!std::isfinite(v.x) || !std::isfinite(v.y)) return false;
    }
    return true;
  };
  return holds(cord.positions()) && holds(cord.velocities());
}

}  // namespace engine
