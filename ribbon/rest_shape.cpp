#include "ribbon/rest_shape.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "ribbon/cord.h"

namespace ribbon {
namespace {

constexpr int max_steps = 300;
constexpr double step = 0.5;           // s
constexpr double tolerance = 1e-7;     // of the length, of the solve
constexpr double smallest = 1e-12;     // m, tolerance of the solve
constexpr double growth = 2.0;         // of the lightness from step to step
constexpr double retreat = 16.0;       // its divisor after a step that was not solved
constexpr double contraction = 10.0;   // lightness·(ω·dt)² of the slowest mode in the last step
constexpr double max_lightness = 1e3;  // above, the least compliance of links would lengthen an inextensible rope

/// What the cord is made of, with terms left out that do no work at rest.
CordDef quasi_static(const CordDef& def) {
  CordDef still = def;
  still.damping = still.drag = 0.0;
  still.drag_across = still.drag_along = still.displaced_area = 0.0;
  still.self_contact = still.cord_contact = still.allow_sleep = false;
  still.accuracy = {Integrator::implicit_euler, 1, 50, std::max(smallest, tolerance * def.length), 2000, false};
  return still;
}

double greatest_distance(std::span<const Vec2> a, std::span<const Vec2> b) {
  double most = 0.0;
  for (std::size_t p = 0; p < a.size(); ++p) most = std::max(most, length(a[p] - b[p]));
  return most;
}

}  // namespace

/// A step of implicit Euler from rest takes the points to the minimum of
///
///     Σ m·|x − x₀|²/(2·dt²) + potential energy.
///
/// Repeated from rest it is the proximal point method: the potential energy falls in each step, down to a minimum. The
/// mass m is divided by a lightness that grows, while the weight stays: pseudo-transient continuation (Kelley & Keyes
/// 1998). Of the slowest mode, with ω² about g/L, a step leaves 1/(1 + lightness·(ω·dt)²). An unsolved step is taken
/// again with more mass.
void lay_at_rest(CordDef& def, Vec2 gravity) {
  check(def);
  if (def.positions.empty()) throw DefinitionError("positions are empty; accepted are those of lay_along, or others");
  if (def.pins.empty()) throw DefinitionError("pins are empty; accepted is a cord that hangs from one point or more");
  CordDef light = quasi_static(def);
  const double weight = std::abs(def.gravity_scale) * length(gravity);
  const double lightest =
      std::clamp(contraction * def.length / std::max(weight * step * step, 1e-300), 1.0, max_lightness);
  double lightness = 1.0;
  for (int k = 0; k < max_steps; ++k) {
    light.mass_per_length = def.mass_per_length / lightness;
    Cord cord(light);
    const bool is_solved = cord.step(step, lightness * gravity).unconverged == 0;
    if (!is_solved && lightness > 1.0) {
      lightness = std::max(1.0, lightness / retreat);
      continue;
    }
    const double moved = greatest_distance(cord.positions(), light.positions);
    light.positions.assign(cord.positions().begin(), cord.positions().end());
    if (is_solved && lightness == lightest && moved <= 0.5 * tolerance * def.length) {
      def.positions = std::move(light.positions);
      return;
    }
    lightness = std::min(growth * lightness, lightest);
  }
  throw DefinitionError("the cord does not come to rest; accepted is one that hangs from its pins");
}

}  // namespace ribbon
