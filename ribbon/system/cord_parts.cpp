#include "ribbon/system/cord_parts.h"

#include <algorithm>
#include <utility>

#include "ribbon/cord_forces.h"
#include "ribbon/elastic/chain.h"
#include "ribbon/elastic/lattice.h"

namespace ribbon {
namespace {

std::unique_ptr<Elasticity> make_elasticity(const CordDef& def) {
  if (def.rows == 1 && def.bending_stiffness == 0.0) return std::make_unique<Chain>(def);
  return std::make_unique<Lattice>(def);
}

void write_initial_positions(const CordDef& def, std::vector<Vec2>& positions) {
  positions = def.positions;
  if (!positions.empty()) return;
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) {
      const double across = def.rows > 1 ? def.width * j / (def.rows - 1) : 0.0;
      positions.push_back({def.length * i / (def.points - 1), across});
    }
  }
}

/// The outline of a rope goes from end to end, that of a ribbon around it: along the lowest row and back along the
/// highest.
void write_outline(const CordDef& def, std::vector<int>& outline) {
  outline.clear();
  const int n = def.points;
  const int rows = def.rows;
  for (int i = 0; i < n; ++i) outline.push_back(i * rows);
  if (rows == 1) return;
  for (int j = 1; j < rows; ++j) outline.push_back((n - 1) * rows + j);
  for (int i = n - 2; i >= 0; --i) outline.push_back(i * rows + rows - 1);
  for (int j = rows - 2; j > 0; --j) outline.push_back(j);
}

/// Moves the memory of the lists of a state, empty, into another state.
void keep_memory(Cord::State& from, Cord::State& to) {
  const auto keep = [](auto& old, auto& list) {
    old.clear();
    list = std::move(old);
  };
  keep(from.positions, to.positions);
  keep(from.velocities, to.velocities);
  keep(from.accelerations, to.accelerations);
  keep(from.targets, to.targets);
  keep(from.kinds, to.kinds);
  keep(from.masses, to.masses);
  keep(from.loads, to.loads);
  keep(from.tensions, to.tensions);
  keep(from.rest, to.rest);
  keep(from.rest_targets, to.rest_targets);
  keep(from.rest_speeds, to.rest_speeds);
  keep(from.breaking_forces, to.breaking_forces);
  keep(from.holders, to.holders);
  keep(from.touches, to.touches);
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

CordParts::CordParts(const CordDef& cord_def) : def(cord_def), elasticity(make_elasticity(cord_def)) { start(); }

void CordParts::renew() {
  const bool is_chain = def.rows == 1 && def.bending_stiffness == 0.0;
  if (!(is_chain && elasticity->become(def))) elasticity = make_elasticity(def);
  start();
}

void CordParts::reserve() {
  const std::size_t points = size();
  def.positions.reserve(points);
  def.pins.reserve(points);
  own_masses.reserve(points);
  outline.reserve(points);
  rest_start.reserve(points);
  rest_end.reserve(points);
  state.loads.reserve(points);
  state.rest_targets.reserve(points);
  state.rest_speeds.reserve(points);
  state.breaking_forces.reserve(points);
  state.touches.reserve(points);
}

/// Sets everything but the definition and the elasticity.
void CordParts::start() {
  Cord::State old = std::exchange(state, {});
  keep_memory(old, state);
  sweep.reset();
  rest_start.clear();
  rest_end.clear();
  own_rest_start.clear();
  own_rest_end.clear();
  own_masses.clear();
  write_outline(def, outline);
  write_initial_positions(def, state.positions);
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
  leave_out_links_on_wheels();
  elasticity->find_tensions(state.positions, state.tensions);
}

void CordParts::leave_out_links_on_wheels() {
  on_wheels.clear();
  if (!state.pulleys.empty()) on_wheels.assign(state.rest.size(), 0);
  for (const Pulley& pulley : state.pulleys) {
    const auto first = on_wheels.begin();
    std::fill(first + pulley.def.before, first + pulley.def.after, char{1});
  }
  elasticity->leave_out(on_wheels);
}

Motion CordParts::motion_of_tensions() const {
  return {state.positions, state.damping_excluded ? std::span<const Vec2>{} : std::span<const Vec2>(state.velocities)};
}

double CordParts::tension(std::size_t link) const {
  if (def.rows == 1) return state.tensions[link];
  const auto rows = static_cast<std::size_t>(def.rows);
  const auto middle = [&](std::size_t column) {
    return 0.5 * (state.positions[column * rows + (rows - 1) / 2] + state.positions[column * rows + rows / 2]);
  };
  const Vec2 along = middle(link + 1) - middle(link);
  return dot(elasticity->section_force(link, motion_of_tensions(), state.tensions), unit_or(along, length(along), {}));
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

double CordParts::mass_by_ring(std::size_t point) const {
  if (def.rows > 1 || !state.rest_targets.empty()) return 0.0;
  const double link = def.length / (def.points - 1);
  double longer = 0.0;
  if (point > 0) longer += state.rest[point - 1] - link;
  if (point < state.rest.size()) longer += state.rest[point] - link;
  return 0.5 * def.mass_per_length * longer;
}

CordEnergy CordParts::energy(Vec2 gravity) const {
  CordEnergy sum;
  sum.elastic = elasticity->energy(motion_of_tensions(), state.tensions);
  for (std::size_t p = 0; p < size(); ++p) {
    sum.kinetic += 0.5 * state.masses[p] * dot(state.velocities[p], state.velocities[p]);
    sum.potential -= state.masses[p] * dot(def.gravity_scale * gravity, state.positions[p]);
  }
  for (std::size_t p = 0; p < state.loads.size(); ++p) sum.potential -= dot(state.loads[p], state.positions[p]);
  return sum;
}

CordSweep CordParts::find_sweep() const {
  const std::vector<Vec2>& x = state.positions;
  const double elastic = state.asleep ? 0.0 : elasticity->energy({x, state.velocities}, state.tensions);
  CordSweep found{{x[0], x[0]}, 0.0, elastic, state.rest[0]};
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
