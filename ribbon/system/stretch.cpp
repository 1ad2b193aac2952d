#include "ribbon/system/stretch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ribbon {
namespace {

/// m
double length_of(const Member& member) {
  const std::vector<double>& rest = member.cord->state.rest;
  return std::accumulate(rest.begin(), rest.end(), 0.0);
}

}  // namespace

double largest_strain(const Member& member, std::span<const Vec2> x) {
  const CordDef& def = member.cord->def;
  if (std::isfinite(def.stretch_stiffness)) return 0.0;
  double max = 0.0;
  for (std::size_t link = 0; link + 1 < member.points; ++link) {
    if (member.cord->is_on_wheel(link)) continue;
    const std::size_t p = member.first_point + link;
    const double strain = length(x[p + 1] - x[p]) / member.cord->state.rest[link] - 1.0;
    max = std::max(max, def.tension_only ? strain : std::abs(strain));
  }
  return max;
}

double largest_strain(const IslandState& state, std::span<const Vec2> x) {
  double max = 0.0;
  for (const Member& member : state.members) max = std::max(max, largest_strain(member, x));
  return max;
}

bool became_stretched(const IslandState& state, double strain) {
  const double now = largest_strain(state, state.positions);
  return now > strain && now > largest_strain(state, state.start.positions);
}

bool is_stretched(const IslandState& state, const Member& member) {
  const double strain = largest_strain(member, state.positions);
  return strain > max_strain && strain > largest_strain(member, state.start.positions);
}

bool is_stretched(const IslandState& state) {
  const double displacement = highest_start_speed(state) * state.dt;
  return std::any_of(state.members.begin(), state.members.end(), [&](const Member& member) {
    return is_stretched(state, member) && displacement < length_of(member);
  });
}

bool is_stretched_by_step(const IslandState& state) {
  return std::any_of(state.members.begin(), state.members.end(), [&](const Member& member) {
    return largest_strain(member, state.positions) > std::max(max_strain, member.start_strain);
  });
}

double highest_start_speed(const IslandState& state) {
  double highest = 0.0;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.has_speed(p)) highest = std::max(highest, length(state.start.velocities[p]));
    if (p < state.points && state.constrained[p] != 0) highest = std::max(highest, length(state.drive_velocities[p]));
  }
  return highest;
}

}  // namespace ribbon
