#include "ribbon/system/supports.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ribbon {
namespace {

constexpr double stiffness_share = 2000.0;  // of the island's mass by the square of the step
constexpr std::size_t usual_supports = 8;   // of an island: it gets memory for so many at once
constexpr double resting_distance = 1e-9;   // m, up to which a support is at its body
constexpr double resting_speed = 1e-2;      // m/s, of a place, below which it does not hit its support

/// Returns how far a body is from its support at x, m; negative if it is pushed.
double distance_of(const IslandState& state, const BodySupport& support, std::span<const Vec2> x) {
  return support.gap + dot(support.normal, x[state.center(support.solved_index)]) - support.start +
         support.lever * x[state.angle(support.solved_index)].x - support.speed * state.now;
}

SlotRow row_of(const IslandState& state, const BodySupport& support) {
  SlotRow row;
  row.add(static_cast<int>(state.center(support.solved_index)), support.normal);
  row.add(static_cast<int>(state.angle(support.solved_index)), {support.lever, 0.0});
  return row;
}

/// Returns the force of a support at the current positions, N.
double force_of(const IslandState& state, const BodySupport& support) {
  return std::max(0.0, -state.supports.stiffness * distance_of(state, support, state.positions));
}

/// Adds the supports of a member's bodies, but not of those that have some already.
void add_supports_of(IslandState& state, const Member& member) {
  const std::size_t before = state.supports.all.size();
  for (const Support& support : member.surroundings.supports) {
    const RigidBody& body = state.rigid[at(support.body)];
    const auto solved = std::find_if(state.bodies.begin(), state.bodies.end(),
                                     [&](const SolvedBody& of) { return of.index == support.body; });
    if (solved == state.bodies.end() || body.inverse_mass == 0.0) continue;
    const auto index = static_cast<std::size_t>(solved - state.bodies.begin());
    const auto earlier = state.supports.all.begin() + static_cast<std::ptrdiff_t>(before);
    if (std::any_of(state.supports.all.begin(), earlier, [&](const BodySupport& s) { return s.solved_index == index; }))
      continue;
    if (state.supports.all.empty()) state.supports.all.reserve(usual_supports);
    BodySupport added;
    added.solved_index = index;
    added.normal = support.normal;
    added.lever = solved->turns ? cross(support.arm, support.normal) : 0.0;
    added.start = dot(support.normal, body.position);
    added.gap = support.gap;
    added.speed = support.speed;
    state.supports.all.push_back(added);
  }
}

}  // namespace

void add_supports(IslandState& state) {
  for (const Member& member : state.members) add_supports_of(state, member);
  if (!state.supports.any()) return;
  double mass = 0.0;
  for (std::size_t p = 0; p < state.points; ++p) mass += state.masses[p];
  for (std::size_t k = 0; k < state.bodies.size(); ++k) mass += state.masses[state.center(k)];
  state.supports.stiffness = stiffness_share * mass / (state.dt * state.dt);
  for (BodySupport& support : state.supports.all) {
    const double approach = dot(support.normal, state.velocities[state.center(support.solved_index)]) +
                            support.lever * state.velocities[state.angle(support.solved_index)].x - support.speed;
    support.hits = support.gap > resting_distance || approach < -resting_speed;
  }
}

/// The first system of a stage has those that pushed before. Each is solved as if it could pull too, and is left out of
/// the next one if it did. So the line search does not see that a stiff spring begins or ends within a step.
bool find_loaded(IslandState& state) {
  const bool begins = std::exchange(state.supports.stage_begins, false);
  bool changed = false;
  for (BodySupport& support : state.supports.all) {
    const bool pushed =
        support.push == BodySupport::Push::unknown ? !support.hits : support.push == BodySupport::Push::yes;
    const bool loads = begins ? pushed : distance_of(state, support, state.positions) < 0.0;
    changed = changed || loads != support.loaded;
    support.loaded = loads;
  }
  return changed;
}

void load_supports(const IslandState& state, BlockLdlt& blocks, std::span<Vec2> right_side) {
  if (state.supports.are_rows) return;
  for (const BodySupport& support : state.supports.all) {
    if (!support.loaded) continue;
    const SlotRow row = row_of(state, support);
    blocks.add_outer(state.supports.stiffness, row.slots(), row.derivatives());
    row.push(-state.supports.stiffness * distance_of(state, support, state.positions), right_side);
  }
}

bool are_supports_settled(const IslandState& state, std::span<const double> inertia, double tolerance) {
  return std::all_of(state.supports.all.begin(), state.supports.all.end(), [&](const BodySupport& support) {
    const double distance = distance_of(state, support, state.positions);
    if (support.loaded == (distance < 0.0)) return true;
    return state.supports.stiffness * std::abs(distance) <= tolerance * inertia[state.center(support.solved_index)];
  });
}

/// A push that is there at the end of the first stage was there all along, unless the body has hit the support.
void end_stage_of_supports(IslandState& state) {
  for (BodySupport& support : state.supports.all) {
    const bool pushes = distance_of(state, support, state.positions) < 0.0;
    const auto before = std::exchange(support.push, pushes ? BodySupport::Push::yes : BodySupport::Push::no);
    const bool changed = before == BodySupport::Push::unknown ? pushes && support.hits : before != support.push;
    state.supports.changed = state.supports.changed || changed;
  }
}

double support_energy(const IslandState& state) {
  double sum = 0.0;
  for (const BodySupport& support : state.supports.all) {
    const double depth = std::min(0.0, distance_of(state, support, state.positions));
    sum += 0.5 * state.supports.stiffness * depth * depth;
  }
  return sum;
}

double support_potential(const IslandState& state, std::span<const Vec2> x) {
  if (state.supports.are_rows) return 0.0;
  double sum = 0.0;
  for (const BodySupport& support : state.supports.all) {
    if (!support.loaded) continue;
    const double distance = distance_of(state, support, x);
    sum += 0.5 * state.supports.stiffness * distance * distance;
  }
  return sum;
}

void append_support_rows(const IslandState& state, LimitedRows& rows) {
  for (const BodySupport& support : state.supports.all) {
    rows.add({row_of(state, support), distance_of(state, support, state.positions), 1.0 / state.supports.stiffness, 0.0,
              std::numeric_limits<double>::infinity(), force_of(state, support)});
  }
}

void store_support_forces(const IslandState& state) {
  for (const SolvedBody& solved : state.bodies) {
    RigidBody& body = state.rigid[at(solved.index)];
    body.support_force = {};
    body.support_torque = 0.0;
  }
  for (const BodySupport& support : state.supports.all) {
    RigidBody& body = state.rigid[at(state.bodies[support.solved_index].index)];
    const double force = force_of(state, support);
    body.support_force += force * support.normal;
    body.support_torque += force * support.lever;
  }
}

}  // namespace ribbon
