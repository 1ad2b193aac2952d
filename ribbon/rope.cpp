#include "ribbon/rope.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ribbon {
namespace {

std::vector<Vec2> start_positions(const RopeDef& def) {
  if (!def.positions.empty()) return def.positions;
  std::vector<Vec2> straight;
  for (int p = 0; p < def.points; ++p) straight.push_back({def.length * p / (def.points - 1), 0.0});
  return straight;
}

/// Half of each link's mass stands at either of its ends.
std::vector<double> lumped_masses(const RopeDef& def) {
  const double link = def.mass / (def.points - 1);
  std::vector<double> masses;
  for (int p = 0; p < def.points; ++p) masses.push_back(p == 0 || p == def.points - 1 ? 0.5 * link : link);
  return masses;
}

const RopeDef& checked(const RopeDef& def) {
  check(def);
  return def;
}

}  // namespace

void check(const RopeDef& def) {
  check_range("points", def.points, 2, 1e6);
  check_range("length", def.length, 1e-6, 1e6);
  check_range("mass", def.mass, 1e-9, 1e9);
  if (!(def.stretch_stiffness == std::numeric_limits<double>::infinity())) {
    check_range("stretch_stiffness", def.stretch_stiffness, 1e-6, 1e18);
  }
  check_range("substeps", def.substeps, 1, 4096);
  check_range("tolerance", def.tolerance, 1e-12, 1.0);
  check_range("max_iterations", def.max_iterations, 1, 1000);
  check_points(def.points, def.positions, def.pins);
}

Rope::Rope(const RopeDef& def)
    : def_(checked(def)),
      link_length_(def.length / (def.points - 1)),
      compliance_(link_length_ / def.stretch_stiffness),
      positions_(start_positions(def)),
      velocities_(positions_.size()),
      accelerations_(positions_.size()),
      targets_(positions_),
      masses_(lumped_masses(def)),
      tensions_(positions_.size() - 1),
      constrained_(positions_.size()),
      starts_(positions_),
      predicted_(positions_),
      x0_(positions_),
      v0_(positions_),
      x1_(positions_),
      v1_(positions_),
      velocity_(positions_),
      tension0_(tensions_),
      links_(tensions_.size()) {
  for (const int pin : def_.pins) constrained_[index(pin)] = 1;
}

void Rope::check_point(int point) const { check_range("point", point, 0, def_.points - 1); }

void Rope::attach_mass(int point, double mass) {
  check_point(point);
  check_range("attached mass", mass, 0.0, 1e12);
  masses_[index(point)] = lumped_masses(def_)[index(point)] + mass;
  restart_ = true;
}

void Rope::constrain(int point, Vec2 target) {
  check_point(point);
  check_coordinates("target", target);
  targets_[index(point)] = target;
  constrained_[index(point)] = 1;
  restart_ = true;
}

void Rope::release(int point) {
  check_point(point);
  constrained_[index(point)] = 0;
  restart_ = true;
}

void Rope::set_velocity(int point, Vec2 velocity) {
  check_point(point);
  check_coordinates("velocity", velocity);
  velocities_[index(point)] = velocity;
  restart_ = true;
}

Rope::State Rope::save() const {
  return {positions_, velocities_, accelerations_, targets_, masses_, tensions_, constrained_, restart_};
}

void Rope::restore(const State& state) {
  const std::size_t n = positions_.size();
  for (const std::size_t size :
       {state.positions.size(), state.velocities.size(), state.accelerations.size(), state.targets.size(),
        state.masses.size(), state.tensions.size() + 1, state.constrained.size()}) {
    if (size != n)
      throw DefinitionError("state is of another cord; accepted is one of " + std::to_string(n) + " points");
  }
  positions_ = state.positions;
  velocities_ = state.velocities;
  accelerations_ = state.accelerations;
  targets_ = state.targets;
  masses_ = state.masses;
  tensions_ = state.tensions;
  constrained_ = state.constrained;
  restart_ = state.restart;
}

}  // namespace ribbon
