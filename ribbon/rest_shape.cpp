#include "ribbon/rest_shape.h"

#include <algorithm>

#include "ribbon/cord.h"

namespace ribbon {
namespace {

constexpr int max_steps = 2000;
constexpr double step = 0.5;        // s
constexpr double tolerance = 1e-7;  // of the length: a step moves no point further
constexpr double smallest = 1e-12;  // m, tolerance of the solve

/// What the cord is made of, with terms left out that do no work at rest.
CordDef quasi_static(const CordDef& def) {
  CordDef still = def;
  still.damping = still.drag = 0.0;
  still.drag_across = still.drag_along = still.displaced_area = 0.0;
  still.self_contact = still.cord_contact = still.allow_sleep = false;
  still.accuracy = {Integrator::implicit_euler, 1, 50, std::max(smallest, 0.1 * tolerance * def.length), 10'000, false};
  return still;
}

}  // namespace

/// A step of implicit Euler from rest takes the points to the minimum of
///
///     Σ m·|x − x₀|²/(2·dt²) + potential energy.
///
/// Repeated from rest it is the proximal point method: the potential energy falls in each step, down to a minimum.
void lay_at_rest(CordDef& def, Vec2 gravity) {
  check(def);
  if (def.positions.empty()) throw DefinitionError("positions are empty; accepted are those of lay_along, or others");
  if (def.pins.empty()) throw DefinitionError("pins are empty; accepted is a cord that hangs from one point or more");
  Cord cord(quasi_static(def));
  auto moved = [&cord, before = def.positions]() mutable {
    double most = 0.0;
    for (std::size_t p = 0; p < before.size(); ++p) most = std::max(most, length(cord.positions()[p] - before[p]));
    before.assign(cord.positions().begin(), cord.positions().end());
    return most;
  };
  for (int k = 0; k < max_steps; ++k) {
    cord.step(step, gravity);
    for (int p = 0; p < def.points * def.rows; ++p) cord.set_velocity(p, {});
    if (moved() > tolerance * def.length) continue;
    def.positions.assign(cord.positions().begin(), cord.positions().end());
    return;
  }
  throw DefinitionError("the cord does not come to rest; accepted is one that hangs from its pins");
}

}  // namespace ribbon
