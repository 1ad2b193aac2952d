#include "ribbon/system/cord_parts.h"

#include <algorithm>

#include "ribbon/elastic/chain.h"
#include "ribbon/elastic/lattice.h"

namespace ribbon {
namespace {

std::unique_ptr<Elasticity> make_elasticity(const CordDef& def) {
  if (def.rows == 1 && def.bending_stiffness == 0.0) return std::make_unique<Chain>(def);
  return std::make_unique<Lattice>(def);
}

std::vector<Vec2> initial_positions(const CordDef& def) {
  if (!def.positions.empty()) return def.positions;
  std::vector<Vec2> straight;
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) {
      const double across = def.rows > 1 ? def.width * j / (def.rows - 1) : 0.0;
      straight.push_back({def.length * i / (def.points - 1), across});
    }
  }
  return straight;
}

/// The outline of a rope goes from end to end, that of a ribbon around it: along the lowest row and back along the
/// highest.
std::vector<int> outline_of(const CordDef& def) {
  std::vector<int> outline;
  const int n = def.points;
  const int rows = def.rows;
  for (int i = 0; i < n; ++i) outline.push_back(i * rows);
  if (rows == 1) return outline;
  for (int j = 1; j < rows; ++j) outline.push_back((n - 1) * rows + j);
  for (int i = n - 2; i >= 0; --i) outline.push_back(i * rows + rows - 1);
  for (int j = rows - 2; j > 0; --j) outline.push_back(j);
  return outline;
}

/// kg: an equal share of each link or cell around the point.
double own_mass(const CordDef& def, std::size_t point) {
  const auto columns = static_cast<std::size_t>(def.points);
  const auto rows = static_cast<std::size_t>(def.rows);
  const auto share = [](std::size_t k, std::size_t n) { return k == 0 || k == n - 1 ? 0.5 : 1.0; };
  const double link = def.mass_per_length * def.length / (def.points - 1);
  if (rows == 1) return link * share(point, columns);
  return link * share(point / rows, columns) * share(point % rows, rows) / static_cast<double>(rows - 1);
}

}  // namespace

CordParts::CordParts(const CordDef& cord_def)
    : def(cord_def), elasticity(make_elasticity(cord_def)), outline(outline_of(cord_def)) {
  state.positions = initial_positions(def);
  const std::size_t n = state.positions.size();
  state.velocities.resize(n);
  state.accelerations.resize(n);
  state.targets = state.positions;
  state.kinds.assign(n, PointKind::free);
  for (const int pin : def.pins) state.kinds[static_cast<std::size_t>(pin)] = PointKind::constrained;
  for (std::size_t p = 0; p < n; ++p) own_masses.push_back(own_mass(def, p));
  state.masses = own_masses;
  state.rest.assign(static_cast<std::size_t>(def.points) - 1, def.length / (def.points - 1));
  state.tensions.resize(elasticity->tension_count());
  elasticity->set_rest_lengths(state.rest);
  elasticity->find_tensions(state.positions, state.tensions);
}

Motion CordParts::motion_of_tensions() const {
  return {state.positions, state.damping_excluded ? std::span<const Vec2>{} : std::span<const Vec2>(state.velocities)};
}

/// The point moves at constant velocity, so the forces on it are in balance.
Vec2 CordParts::holding_force(std::size_t point, Vec2 gravity) const {
  Vec2 others = elasticity->force_on(point, motion_of_tensions(), state.tensions) +
                state.masses[point] * (def.gravity_scale * gravity) -
                (def.drag * own_masses[point]) * state.velocities[point];
  if (!state.loads.empty()) others += state.loads[point];
  if (!state.medium_forces.empty()) others += state.medium_forces[point];
  return -others;
}

Cord::Energy CordParts::energy(Vec2 gravity) const {
  Cord::Energy sum;
  sum.elastic = elasticity->energy(motion_of_tensions(), state.tensions);
  for (std::size_t p = 0; p < size(); ++p) {
    sum.kinetic += 0.5 * state.masses[p] * dot(state.velocities[p], state.velocities[p]);
    sum.potential -= state.masses[p] * dot(def.gravity_scale * gravity, state.positions[p]);
  }
  for (std::size_t p = 0; p < state.loads.size(); ++p) sum.potential -= dot(state.loads[p], state.positions[p]);
  return sum;
}

Cord::Sweep CordParts::find_sweep() const {
  const std::vector<Vec2>& x = state.positions;
  Cord::Sweep found{{x[0], x[0]}, 0.0, state.asleep ? 0.0 : elasticity->energy({x, state.velocities}, state.tensions)};
  const auto include = [&box = found.box](Vec2 point) {
    box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y)};
    box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y)};
  };
  for (std::size_t p = 0; p < x.size(); ++p) {
    include(x[p]);
    if (state.kinds[p] != PointKind::free) include(state.targets[p]);
    found.speed2 = std::max(found.speed2, dot(state.velocities[p], state.velocities[p]));
  }
  return found;
}

void CordParts::remember_sweep() {
  if (!sweep) sweep = find_sweep();
}

void CordParts::disturb() {
  state.restart = true;
  sweep.reset();
  wake();
}

void CordParts::wake() {
  if (state.asleep) sweep.reset();
  state.rest_time = 0.0;
  state.asleep = false;
}

void CordParts::fall_asleep() {
  if (state.asleep) return;
  state.asleep = true;
  sweep.reset();
  exclude_damping();
  std::fill(state.velocities.begin(), state.velocities.end(), Vec2{});
  std::fill(state.accelerations.begin(), state.accelerations.end(), Vec2{});
  state.restart = true;
}

void CordParts::exclude_damping() {
  if (def.damping == 0.0 || state.damping_excluded) return;
  elasticity->add_damping({state.positions, state.velocities}, -1.0, state.tensions);
  state.damping_excluded = true;
}

void CordParts::include_damping() {
  if (!state.damping_excluded) return;
  elasticity->add_damping({state.positions, state.velocities}, 1.0, state.tensions);
  state.damping_excluded = false;
}

}  // namespace ribbon
