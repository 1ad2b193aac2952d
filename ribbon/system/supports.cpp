#include "ribbon/system/supports.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ribbon {
namespace {

constexpr double stiffness_share = 2000.0;  // of the island's mass by the square of the step
constexpr std::size_t usual_supports = 32;  // of an island: it gets memory for so many at once
constexpr double resting_distance = 1e-9;   // m, up to which a support is at its body
constexpr double resting_speed = 1e-2;      // m/s, of a place, below which it does not hit its support

/// Returns how far a body is from its support at x, m; negative if it is pushed.
double distance_of(const IslandState& state, const BodySupport& support, std::span<const Vec2> x) {
  double along = dot(support.normal, x[state.center(support.solved_index)]) +
                 support.lever * x[state.angle(support.solved_index)].x;
  if (support.gives_way()) {
    along -=
        dot(support.normal, x[state.center(support.other)]) + support.other_lever * x[state.angle(support.other)].x;
  }
  return support.gap + along - support.start - (support.speed + support.push_speed) * state.now;
}

SlotRow row_of(const IslandState& state, const BodySupport& support) {
  SlotRow row;
  row.add(static_cast<int>(state.center(support.solved_index)), support.normal);
  row.add(static_cast<int>(state.angle(support.solved_index)), {support.lever, 0.0});
  if (!support.gives_way()) return row;
  row.add(static_cast<int>(state.center(support.other)), -support.normal);
  row.add(static_cast<int>(state.angle(support.other)), {-support.other_lever, 0.0});
  return row;
}

/// Returns the force of a support at the current positions, N.
double force_of(const IslandState& state, const BodySupport& support) {
  return std::max(0.0, -state.supports.stiffness * distance_of(state, support, state.positions));
}

/// Returns the place of a body among those that are solved with the cords, or BodySupport::none.
std::size_t find_solved(const IslandState& state, int body) {
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    if (state.bodies[k].index == body) return k;
  }
  return BodySupport::none;
}

/// Returns whether a member before that one has the same support.
bool has_earlier(const IslandState& state, const Member& of, const Support& support) {
  for (const Member& member : state.members) {
    if (&member == &of) return false;
    const auto& supports = member.surroundings.supports;
    if (std::find(supports.begin(), supports.end(), support) != supports.end()) return true;
  }
  return false;
}

bool moves(const IslandState& state, int body) { return body >= 0 && state.rigid[at(body)].inverse_mass > 0.0; }

double lever_of(const IslandState& state, std::size_t body, Vec2 arm, Vec2 normal) {
  return state.bodies[body].turns ? cross(arm, normal) : 0.0;
}

void add_support(IslandState& state, const Support& support, std::size_t index) {
  BodySupport added;
  const RigidBody& body = state.rigid[at(support.body)];
  added.solved_index = index;
  added.normal = support.normal;
  added.lever = lever_of(state, index, support.arm, support.normal);
  added.start = dot(support.normal, body.start()) - added.lever * body.pushed_turn;
  double push = dot(support.normal, body.pushed) + added.lever * body.pushed_turn;
  if (support.other >= 0) {
    const RigidBody& other = state.rigid[at(support.other)];
    added.other = find_solved(state, support.other);
    added.other_lever = lever_of(state, added.other, support.other_arm, support.normal);
    added.start -= dot(support.normal, other.start()) - added.other_lever * other.pushed_turn;
    push -= dot(support.normal, other.pushed) + added.other_lever * other.pushed_turn;
  }
  added.gap = support.gap;
  added.speed = support.speed;
  added.push_speed = push / state.dt;
  if (state.supports.all.empty()) state.supports.all.reserve(usual_supports);
  state.supports.all.push_back(added);
}

/// Adds the supports of a member that no earlier one has.
void add_supports_of(IslandState& state, const Member& member) {
  for (const Support& support : member.surroundings.supports) {
    const std::size_t index = find_solved(state, support.body);
    if (index == BodySupport::none) continue;
    if (!moves(state, support.body) && !moves(state, support.other)) continue;
    if (!has_earlier(state, member, support)) add_support(state, support, index);
  }
}

/// Returns the speed with which a body gets away from its support at the start of the step, m/s.
double separation_speed(const IslandState& state, const BodySupport& support) {
  return row_of(state, support).along(state.velocities) - support.speed - support.push_speed;
}

}  // namespace

void add_supporting_bodies(IslandState& state) {
  const auto add_once = [&] {
    const std::size_t before = state.bodies.size();
    for (const Member& member : state.members) {
      for (const Support& support : member.surroundings.supports) {
        if (support.other < 0) continue;
        const bool has_body = find_solved(state, support.body) != BodySupport::none;
        const bool has_other = find_solved(state, support.other) != BodySupport::none;
        if (has_body != has_other) (void)state.solved_body(has_body ? support.other : support.body);
      }
    }
    return state.bodies.size() > before;
  };
  while (add_once()) {
  }
}

void couple_supports(const IslandState& state, BlockLdlt& matrix) {
  for (const BodySupport& support : state.supports.all) {
    if (support.gives_way()) row_of(state, support).couple(matrix);
  }
}

void add_supports(IslandState& state) {
  for (const Member& member : state.members) add_supports_of(state, member);
  if (!state.supports.any()) return;
  double mass = 0.0;
  for (std::size_t p = 0; p < state.points; ++p) mass += state.masses[p];
  for (std::size_t k = 0; k < state.bodies.size(); ++k) mass += state.masses[state.center(k)];
  state.supports.stiffness = stiffness_share * mass / (state.dt * state.dt);
  for (BodySupport& support : state.supports.all) {
    support.hits = support.gap > resting_distance || separation_speed(state, support) < -resting_speed;
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
    double least = inertia[state.center(support.solved_index)];
    if (support.gives_way()) least = std::min(least, inertia[state.center(support.other)]);
    return state.supports.stiffness * std::abs(distance) <= tolerance * least;
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
    const double force = force_of(state, support);
    const auto push = [&](std::size_t solved, double along, double lever) {
      RigidBody& body = state.rigid[at(state.bodies[solved].index)];
      body.support_force += along * support.normal;
      body.support_torque += along * lever;
    };
    push(support.solved_index, force, support.lever);
    if (support.gives_way()) push(support.other, -force, support.other_lever);
  }
}

}  // namespace ribbon
