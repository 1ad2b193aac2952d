#include "ribbon/system/load_cords.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ribbon/linear/index.h"
#include "ribbon/system/cord_in_medium.h"
#include "ribbon/system/grips.h"
#include "ribbon/system/overstretch.h"
#include "ribbon/system/stretch.h"
#include "ribbon/system/supports.h"
#include "ribbon/system/tie_groups.h"
#include "ribbon/system/wheels.h"

namespace ribbon {
namespace {

constexpr double same_velocity = 1e-5;    // m/s or rad/s, and as a share: what single precision explains
constexpr double max_tolerance = 0.2;     // of a link, above which a tolerance would not hold it
constexpr double wheel_tolerance = 1e-4;  // the same, of a cord on a wheel: a line that is not tangent pulls it round
constexpr double resolved_digits = 16.0;  // min. tolerance, in roundings of the largest coordinate

Accuracy higher(const Accuracy& a, const Accuracy& b) {
  return {a.integrator == Integrator::tr_bdf2 ? a.integrator : b.integrator,
          std::max(a.substeps, b.substeps),
          std::max(a.max_iterations, b.max_iterations),
          std::min(a.tolerance, b.tolerance),
          std::max(a.max_work, b.max_work),
          a.soft_contacts && b.soft_contacts};
}

void reset(IslandState& state) {
  state.overstretched = state.coupled = state.driven = state.in_medium = state.reeling = state.unlocking =
      state.restart = state.jolted = state.keeps_unsolved = state.taken_back = state.turning_gained = false;
  state.members.clear();
  state.bodies.clear();
  state.held.clear();
  state.wheels.clear();
  state.supports.all.clear();
  state.supports.are_rows = false;
  state.ties.slots.clear();
  state.ties.by_cord.clear();
  state.ties.gaps.clear();
  state.ties.apart = state.ties.closing = false;
  state.points = 0;
  state.duals = 0;
  state.now = 0.0;
}

std::size_t add_members(IslandState& state, std::span<const IslandCord> cords) {
  std::size_t tensions = 0;
  state.accuracy = cords[0].cord->parts().def.accuracy;
  for (const IslandCord& island_cord : cords) {
    CordParts& cord = island_cord.cord->parts();
    Member& member = state.members.emplace_back();
    member.cord = &cord;
    member.surroundings = island_cord.surroundings;
    member.id = island_cord.id;
    member.first_point = state.points;
    member.points = cord.size();
    member.first_tension = tensions;
    member.tensions = cord.state.tensions.size();
    member.first_dual = state.duals;
    state.duals += cord.elasticity->dual_count();
    state.points += member.points;
    tensions += member.tensions;
    state.accuracy = higher(state.accuracy, cord.def.accuracy);
  }
  return tensions;
}

template <typename T>
void copy_to(std::span<T> target, const std::vector<T>& source) {
  std::copy(source.begin(), source.end(), target.begin());
}

void load_motion(IslandState& state, const Member& member) {
  CordParts& cord = *member.cord;
  cord.exclude_damping();
  copy_to(IslandState::points_of(member, state.positions), cord.state.positions);
  copy_to(IslandState::points_of(member, state.velocities), cord.state.velocities);
  copy_to(IslandState::points_of(member, state.accelerations), cord.state.accelerations);
  copy_to(IslandState::points_of(member, state.masses), cord.state.masses);
  const auto falls = IslandState::points_of(member, state.free_accelerations);
  std::fill(falls.begin(), falls.end(), cord.def.gravity_scale * state.gravity);
  state.restart = state.restart || cord.state.restart;
}

/// A tolerance above a fifth of a link would not hold it. One below what a coordinate resolves could not be met.
void find_tolerance(IslandState& state) {
  state.tolerance = state.accuracy.tolerance;
  state.min_tolerance = 0.0;
  for (const Member& member : state.members) {
    const CordParts& cord = *member.cord;
    const Vec2 x = cord.state.positions[0];
    const double largest = std::abs(x.x) + std::abs(x.y) + cord.def.length;  // of a coordinate, about
    state.min_tolerance =
        std::max(state.min_tolerance, resolved_digits * std::numeric_limits<double>::epsilon() * largest);
    double shortest = cord.def.length / (cord.def.points - 1);
    for (std::size_t e = 0; e < cord.state.rest_targets.size(); ++e) {
      shortest = std::min({shortest, cord.state.rest[e], cord.state.rest_targets[e]});
    }
    state.tolerance =
        std::min(state.tolerance, (cord.state.pulleys.empty() ? max_tolerance : wheel_tolerance) * shortest);
  }
  state.tolerance = std::max(state.tolerance, state.min_tolerance);
}

void drive_points(IslandState& state, const Member& member) {
  const Cord::State& cord = member.cord->state;
  const auto constrained = IslandState::points_of(member, state.constrained);
  std::transform(cord.kinds.begin(), cord.kinds.end(), constrained.begin(),
                 [](PointKind kind) { return static_cast<char>(kind != PointKind::free); });
  for (std::size_t i = 0; i < member.points; ++i) {
    const std::size_t p = member.first_point + i;
    if (constrained[i] != 0) state.drive(p, (1.0 / state.dt) * (cord.targets[i] - state.positions[p]));
  }
}

/// kg: the cord, what is attached to it, and the heaviest body near it, which may press it against something else. A
/// body that cannot be pushed does not count.
double pressing_mass(const IslandState& state, const Member& member) {
  const auto mass_of = [&](int body) {
    const double inverse_mass = state.rigid[at(body)].inverse_mass;
    return inverse_mass > 0.0 ? 1.0 / inverse_mass : 0.0;
  };
  const std::vector<double>& points = member.cord->state.masses;
  double mass = std::accumulate(points.begin(), points.end(), 0.0);
  for (std::size_t k = member.first_grip; k < member.end_grip; ++k) mass += mass_of(state.held[k].rigid_index);
  double heaviest = 0.0;
  for (const RigidCircle& circle : member.surroundings.circles) heaviest = std::max(heaviest, mass_of(circle.body));
  for (const RigidSegment& segment : member.surroundings.segments) {
    heaviest = std::max(heaviest, mass_of(segment.body));
  }
  return mass + heaviest;
}

/// Finds which cords ties connect.
void connect_ties(IslandState& state, std::span<const TiedPoint> tied) {
  DisjointSets& connected = state.ties.connected;
  connected.begin(state.members.size());
  for (std::size_t k = 1; k < tied.size(); ++k) {
    if (tied[k].group == tied[k - 1].group) connected.join(at(tied[k - 1].cord), at(tied[k].cord));
  }
}

/// Adds up the masses that press cords against something over all that ties connect: what hangs from a cord presses it.
void join_pressing_masses(IslandState& state) {
  DisjointSets& connected = state.ties.connected;
  std::vector<Member>& members = state.members;
  for (std::size_t m = 0; m < members.size(); ++m) {
    if (const std::size_t of = connected.root(m); of != m) members[of].pressing_mass += members[m].pressing_mass;
  }
  for (std::size_t m = 0; m < members.size(); ++m) members[m].pressing_mass = members[connected.root(m)].pressing_mass;
}

/// Returns whether an inextensible rope is stretched that ties connect with a cord: it holds back what they draw.
bool is_held_back(IslandState& state, int cord) {
  DisjointSets& connected = state.ties.connected;
  const std::size_t root = connected.root(at(cord));
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    if (connected.root(m) == root && state.members[m].start_strain > max_strain) return true;
  }
  return false;
}

std::size_t slot_of(const IslandState& state, const TiedPoint& tied) {
  return state.members[at(tied.cord)].first_point + at(tied.point);
}

/// What one point of a group does, all do. If one is driven, the others are driven beside it.
void tie_together(IslandState& state, std::span<const TiedPoint> group, ApartTies apart) {
  const auto first = static_cast<int>(slot_of(state, group[0]));
  const auto driver = std::find_if(group.begin(), group.end(),
                                   [&](const TiedPoint& tied) { return state.constrained[slot_of(state, tied)] != 0; });
  const std::size_t reference = driver == group.end() ? at(first) : slot_of(state, *driver);
  for (const TiedPoint& tied : group) {
    const std::size_t slot = slot_of(state, tied);
    const TiedSlot of{static_cast<int>(slot), first};
    if (of.slot != first) state.ties.slots.push_back(of);
    if (slot == reference || state.constrained[slot] != 0) continue;
    const Vec2 gap = state.positions[slot] - state.positions[reference];
    const bool draws = apart == ApartTies::drawn && are_apart(gap) && !is_held_back(state, tied.cord);
    const Vec2 closing = draws ? closing_in_step(*state.members[at(tied.cord)].cord, gap, state.dt) : Vec2{};
    state.ties.apart = state.ties.apart || are_apart(gap);
    state.ties.closing = state.ties.closing || draws;
    if (driver != group.end()) {
      state.drive(slot, state.drive_velocities[reference] - (1.0 / state.dt) * closing);
    } else if (gap != Vec2{}) {
      state.ties.gaps.push_back({of, gap, closing});
    }
  }
}

/// Ties only those points of a group that are where another one is.
void release_apart(IslandState& state, std::span<const TiedPoint> group) {
  std::vector<TiedPoint>& left = state.ties.released;
  left.assign(group.begin(), group.end());
  for (auto next = left.begin(); next != left.end();) {
    const Vec2 place = state.positions[slot_of(state, *next)];
    const auto end = std::stable_partition(next, left.end(), [&](const TiedPoint& tied) {
      return !are_apart(state.positions[slot_of(state, tied)] - place);
    });
    tie_together(state, {next, end}, ApartTies::released);
    next = end;
  }
}

void load_group(IslandState& state, std::span<const TiedPoint> group, ApartTies apart) {
  const auto number = static_cast<int>(slot_of(state, group[0]));
  for (const TiedPoint& tied : group) state.ties.by_cord.push_back({number, tied.cord, tied.point});
  if (apart == ApartTies::released) {
    release_apart(state, group);
  } else {
    tie_together(state, group, apart);
  }
}

void load_ties(IslandState& state, std::span<const TiedPoint> tied, ApartTies apart) {
  if (tied.empty()) return;
  connect_ties(state, tied);
  for (Member& member : state.members) member.start_strain = largest_strain(member, state.positions);
  for (std::size_t first = 0; first < tied.size();) {
    std::size_t end = first + 1;
    while (end < tied.size() && tied[end].group == tied[first].group) ++end;
    load_group(state, tied.subspan(first, end - first), apart);
    first = end;
  }
  std::sort(state.ties.slots.begin(), state.ties.slots.end(),
            [](const TiedSlot& a, const TiedSlot& b) { return a.slot < b.slot; });
  std::sort(state.ties.by_cord.begin(), state.ties.by_cord.end(), [](const TiedPoint& a, const TiedPoint& b) {
    return a.cord != b.cord ? a.cord < b.cord : a.point < b.point;
  });
  join_pressing_masses(state);
}

void load_medium(IslandState& state, Member& member) {
  member.in_medium = is_in_medium(*member.cord, member.surroundings);
  state.in_medium = state.in_medium || member.in_medium;
}

/// Finds where the reels take the rest lengths in this step. The speed of a reel that arrives jumps.
void load_reel(IslandState& state, const Member& member) {
  CordParts& cord = *member.cord;
  bool reeling = false;
  for (std::size_t e = 0; e < cord.state.rest_targets.size(); ++e) {
    const double rest = cord.state.rest[e];
    const double left = cord.state.rest_targets[e] - rest;
    const double max_change = cord.state.rest_speeds[e] * state.dt;
    const bool arrives = std::abs(left) <= max_change;
    cord.rest_start[e] = rest;
    cord.rest_end[e] = arrives ? cord.state.rest_targets[e] : rest + std::copysign(max_change, left);
    reeling = reeling || left != 0.0;
    state.restart = state.restart || (left != 0.0 && arrives);
  }
  state.reeling = state.reeling || reeling;
  state.driven = state.driven || reeling;
}

/// A body that something has pushed begins where it was expected, with a velocity that makes up for the push p in the
/// step: x + v·dt = (x − p) + (v + p/dt)·dt.
void load_push(IslandState& state, std::size_t k) {
  const RigidBody& body = state.rigid_of(state.bodies[k]);
  state.pushes.resize(state.slots());
  state.pushes[state.center(k)] = (1.0 / state.dt) * body.pushed;
  state.pushes[state.angle(k)] = {body.pushed_turn / state.dt, 0.0};
  for (const std::size_t slot : {state.center(k), state.angle(k)}) state.velocities[slot] += state.pushes[slot];
}

void load_body(IslandState& state, std::size_t k) {
  const SolvedBody& solved = state.bodies[k];
  const RigidBody& body = state.rigid_of(solved);
  const std::size_t center = state.center(k);
  const std::size_t angle = state.angle(k);
  state.positions[center] = body.start();
  state.positions[angle] = {-body.pushed_turn, 0.0};
  state.velocities[center] = body.velocity + body.inverse_mass * body.impulse;
  state.velocities[angle] = {body.angular_velocity + body.inverse_inertia * body.angular_impulse, 0.0};
  if (body.was_pushed()) load_push(state, k);
  const bool kinematic = body.inverse_mass == 0.0;
  state.accelerations[center] = kinematic ? Vec2{} : body.acceleration;  // that of a body which holds no cord
  state.accelerations[angle] = {};
  state.free_accelerations[center] = body.acceleration;
  state.free_accelerations[angle] = {};
  state.masses[center] = kinematic ? 0.0 : 1.0 / body.inverse_mass;
  state.masses[angle] = kinematic ? 0.0 : solved.turns ? 1.0 / body.inverse_inertia : 1.0;
  state.constrained[center] = kinematic ? 1 : 0;
  state.constrained[angle] = kinematic || !solved.turns ? 1 : 0;
  for (const std::size_t slot : {center, angle}) {
    state.drive_starts[slot] = state.positions[slot];
    state.drive_velocities[slot] = state.velocities[slot];
  }
}

/// Reads the acceleration of a body that held the same point in the last step. It is out of date if something else has
/// changed the body's velocity since then.
void load_body_accelerations(IslandState& state, const Member& member) {
  const auto& holders = member.cord->state.holders;
  state.restart = state.restart || holders.size() != member.end_grip - member.first_grip;
  for (std::size_t k = member.first_grip; k < member.end_grip && !state.restart; ++k) {
    const Cord::Holder& before = holders[k - member.first_grip];
    const HeldBody& held = state.held[k];
    const std::size_t center = state.center(held.solved_index);
    const std::size_t angle = state.angle(held.solved_index);
    state.accelerations[center] = before.acceleration;
    state.accelerations[angle] = {before.angular_acceleration, 0.0};
    const double jump = length(state.velocities[center] - before.velocity);
    const double turn = std::abs(state.velocities[angle].x - before.turning);
    state.restart = at(before.point) + member.first_point != held.point ||
                    jump > same_velocity * (1.0 + length(before.velocity)) ||
                    turn > same_velocity * (1.0 + std::abs(before.turning));
  }
}

/// Returns whether the island is a single cord of which each body holds another point and is not supported, so that the
/// cord's own solver can solve it.
bool is_single_cord(const IslandState& state) {
  if (state.members.size() != 1 || !state.wheels.empty() || state.supports.any()) return false;
  if (state.held.size() != state.bodies.size()) return false;
  for (std::size_t k = 0; k < state.held.size(); ++k) {
    const HeldBody& held = state.held[k];
    if (held.solved_index != k || !held.is_fixed_at_point() || state.rigid[at(held.rigid_index)].inverse_mass == 0.0)
      return false;
    if (k > 0 && held.point <= state.held[k - 1].point) return false;
  }
  return true;
}

}  // namespace

void load_cords(IslandState& state, std::span<const IslandCord> cords, std::span<const TiedPoint> tied,
                ApartTies apart) {
  reset(state);
  const std::size_t tensions = add_members(state, cords);
  for (Member& member : state.members) load_medium(state, member);
  state.resize(state.points, tensions);
  for (const Member& member : state.members) load_motion(state, member);
  find_tolerance(state);
  for (Member& member : state.members) {
    drive_points(state, member);
    add_grips(state, member);
    add_wheels(state, member);
    if (member.may_touch() || !tied.empty()) member.pressing_mass = pressing_mass(state, member);
    load_reel(state, member);
    load_overstretch(state, member);
    member.cord->include_damping();
    copy_to(IslandState::tensions_of(member, state.tensions), member.cord->state.tensions);
    state.unlocking = member.cord->elasticity->unlock(member.cord->state.positions) || state.unlocking;
  }
  load_ties(state, tied, apart);
}

void load_bodies(IslandState& state) {
  state.pushes.clear();
  for (std::size_t k = 0; k < state.bodies.size(); ++k) load_body(state, k);
  load_wheels(state);
  add_supports(state);
  for (const Member& member : state.members) load_body_accelerations(state, member);
  state.coupled = !is_single_cord(state);
}

void reset_rest_lengths(const IslandState& state) {
  for (const Member& member : state.members) {
    CordParts& cord = *member.cord;
    reset_overstretch(cord);
    if (!cord.state.rest_targets.empty()) cord.state.rest = cord.rest_start;
  }
}

}  // namespace ribbon
