#include "ribbon/system/stretch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ribbon {
namespace {

constexpr double square_rounding = 1e-12;  // by which squares may misjudge a length

/// m
double length_of(const Member& member) {
  const std::vector<double>& rest = member.cord->state.rest;
  return std::accumulate(rest.begin(), rest.end(), 0.0);
}

/// Returns false only if no strain of a cord's links at `x` exceeds this one. Cheaper than the largest strain: it takes
/// no roots.
bool may_exceed(double strain, const Member& member, std::span<const Vec2> x) {
  if (std::isfinite(member.cord->def.stretch_stiffness)) return false;
  const double most = (1.0 - square_rounding) * (1.0 + strain);
  const double least = member.cord->def.tension_only ? 0.0 : std::max(0.0, (1.0 + square_rounding) * (1.0 - strain));
  const double most2 = most * most;
  const double least2 = least * least;
  const std::vector<double>& rest = member.cord->state.rest;
  for (std::size_t link = 0; link + 1 < member.points; ++link) {
    const std::size_t p = member.first_point + link;
    const Vec2 along = x[p + 1] - x[p];
    const double size2 = dot(along, along);
    const double rest2 = rest[link] * rest[link];
    if (!(size2 <= most2 * rest2 && size2 >= least2 * rest2) && !member.cord->is_on_wheel(link)) return true;
  }
  return false;
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
  const bool any = std::any_of(state.members.begin(), state.members.end(),
                               [&](const Member& member) { return may_exceed(strain, member, state.positions); });
  if (!any) return false;
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
