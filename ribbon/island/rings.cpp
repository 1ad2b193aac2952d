#include "ribbon/island/rings.h"

#include <cmath>
#include <limits>

#include "ribbon/island/ring_candidate.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/cord_parts.h"
#include "ribbon/system/wheel_sides.h"

namespace ribbon {
namespace {

// Of its strength, by which the tensions on both sides of a hand differ after an impact. It need not hold less at once:
// the tensions of second-order integrators swing.
constexpr double begin_share = 2.0;
constexpr double least_share = 0.02;  // of two links, that one is long after the step

bool may_slip(const IslandCord& cord) {
  const auto grips = cord.surroundings.grips;
  return std::any_of(grips.begin(), grips.end(), [](const Grip& grip) { return std::isfinite(grip.strength); });
}

/// Sets the rest lengths of a link and of the next one. A part of a link has its part of the mass, half of which is in
/// the point at its outer end.
void set_rest_lengths(CordParts& cord, int link, double first, double second) {
  Cord::State& state = cord.state;
  const double mass = link_mass(cord.def) / (first + second) * (first - state.rest[at(link)]);
  state.masses[at(link)] += mass;
  state.masses[at(link + 2)] -= mass;
  for (std::vector<double>* const lengths : {&state.rest, &state.rest_targets}) {
    if (lengths->empty()) continue;
    (*lengths)[at(link)] = first;
    (*lengths)[at(link + 1)] = second;
  }
  cord.elasticity->set_rest_lengths(state.rest);
}

/// Returns in which direction a rope began to run through a hand in an attempt, by sign; 0 if it did not. In a bend
/// that catches the hand it did if the tensions on both sides differ by more than the hand holds.
double runs_in_attempt(const HeldBody& held, const Grip& grip) {
  if (grip.caught) return std::abs(held.pulled) > begin_share * grip.strength ? held.pulled : 0.0;
  return held.slip_sign != 0.0 ? held.slip_sign : -held.slid_before;
}

}  // namespace

std::span<const IslandCord> Rings::thread(std::span<const IslandCord> cords, std::span<const TiedPoint> tied,
                                          std::span<const RigidBody> bodies, double dt, bool allowed) {
  rings_.clear();
  saved_cords_ = 0;
  without_rings_ = cords;
  std::size_t grips = 0;
  for (const IslandCord& cord : cords) {
    if (may_slip(cord)) grips += cord.surroundings.grips.size();
  }
  if (grips == 0) return cords;
  plain_.assign(cords.begin(), cords.end());
  plain_grips_.clear();
  plain_grips_.reserve(grips);  // spans refer to it
  for (std::size_t m = 0; m < cords.size(); ++m) {
    if (may_slip(cords[m])) find(cords, m, tied, bodies, dt, allowed);
  }
  if (rings_.empty()) return without_rings_;
  cords_.assign(cords.begin(), cords.end());
  grips_.clear();
  grips_.reserve(grips);
  axles_.clear();
  axles_.reserve(rings_.size());
  for_each_cord([this](std::size_t member, std::span<const Ring> rings) { put_on(cords_[member], rings); });
  return cords_;
}

/// Finds the rings of a cord, and which of its grips are held in bends without them.
void Rings::find(std::span<const IslandCord> cords, std::size_t member, std::span<const TiedPoint> tied,
                 std::span<const RigidBody> bodies, double dt, bool allowed) {
  const IslandCord& cord = cords[member];
  const CordParts& parts = cord.cord->parts();
  if (!may_have_rings(parts)) return;
  const auto own = cord.surroundings.grips;
  const std::size_t first_grip = plain_grips_.size();
  plain_grips_.insert(plain_grips_.end(), own.begin(), own.end());
  plain_[member].surroundings.grips = std::span(plain_grips_).subspan(first_grip);
  const auto first = static_cast<std::ptrdiff_t>(rings_.size());
  for (std::size_t k = 0; k < own.size(); ++k) {
    const RigidBody& body = bodies[at(own[k].body)];
    if (!may_become_ring(parts, own[k], body)) continue;
    RingCandidate candidate(cord, k, body, dt);
    const auto begun = std::find_if(begun_.begin(), begun_.end(),
                                    [&](const Begun& other) { return other.member == member && other.grip == k; });
    if (begun != begun_.end()) candidate.begin(begun->runs);
    if (!candidate.is_sliding || !candidate.is_near_bend) continue;
    if (candidate.is_in_bend) {
      plain_grips_[first_grip + k].caught = true;
      without_rings_ = plain_;
    }
    const int point = candidate.taken_up;
    const bool is_taken = std::any_of(rings_.begin() + first, rings_.end(),
                                      [point](const Ring& other) { return std::abs(other.taken_up - point) < 2; });
    if (!allowed || is_taken || !candidate.has_place(tied, member) || !candidate.is_alone(cords, bodies, dt)) continue;
    rings_.push_back({member, k, point, own[k].point + own[k].along, candidate.wheel()});
  }
  std::sort(rings_.begin() + first, rings_.end(), [](const Ring& a, const Ring& b) { return a.taken_up < b.taken_up; });
}

void Rings::put_on(IslandCord& cord, std::span<const Ring> rings) {
  CordParts& parts = cord.cord->parts();
  save(parts);
  const auto own = cord.surroundings.grips;
  const std::size_t first_grip = grips_.size();
  const std::size_t first_axle = axles_.size();
  for (std::size_t k = 0; k < own.size(); ++k) {
    const bool is_ring = std::any_of(rings.begin(), rings.end(), [k](const Ring& ring) { return ring.grip == k; });
    if (!is_ring) grips_.push_back(own[k]);
  }
  for (const Ring& ring : rings) {
    const Grip& grip = own[ring.grip];
    axles_.push_back({grip.body, grip.offset + grip.beside});
    parts.state.pulleys.push_back(ring.pulley);
    const int before = ring.taken_up - 1;
    const double link = 0.5 * (parts.state.rest[at(before)] + parts.state.rest[at(before + 1)]);
    set_rest_lengths(parts, before, link, link);
  }
  cord.surroundings.grips = std::span(grips_).subspan(first_grip);
  cord.surroundings.axles = std::span(axles_).subspan(first_axle);
  parts.has_rings = true;
  parts.leave_out_links_on_wheels();
}

void Rings::save(CordParts& cord) {
  if (saved_cords_ == before_.size()) before_.emplace_back();
  Before& before = before_[saved_cords_++];
  before.cord = &cord;
  before.positions = cord.state.positions;
  before.velocities = cord.state.velocities;
  before.masses = cord.state.masses;
  before.rest = cord.state.rest;
  before.rest_targets = cord.state.rest_targets;
}

void Rings::watch(IslandState& state) {
  for (const Member& member : state.members) {
    const auto tensions = IslandState::tensions_of(member, state.tensions);
    for (std::size_t k = member.first_grip; k < member.end_grip; ++k) {
      HeldBody& held = state.held[k];
      const std::size_t point = held.point - member.first_point;
      if (!member.surroundings.grips[held.grip].caught || member.cord->def.rows > 1 || held.along > 0.0) continue;
      if (point == 0 || point + 1 >= member.points) continue;
      const double pulled = tensions[point] - tensions[point - 1];
      if (std::abs(pulled) > std::abs(held.pulled)) held.pulled = pulled;
    }
  }
}

bool Rings::find_begun(const IslandState& state, std::span<const TiedPoint> tied, std::span<const RigidBody> bodies,
                       double dt) {
  const std::size_t known = begun_.size();
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    const Member& member = state.members[m];
    if (!may_have_rings(*member.cord)) continue;  // nor has it any yet
    for (std::size_t k = member.first_grip; k < member.end_grip; ++k) {
      const HeldBody& held = state.held[k];
      const RigidBody& body = bodies[at(held.rigid_index)];
      const IslandCord& cord = without_rings_[m];
      if (!may_become_ring(*member.cord, cord.surroundings.grips[held.grip], body)) continue;
      const RingCandidate candidate(cord, held.grip, body, dt);
      if (candidate.is_sliding || !candidate.is_near_bend) continue;  // it cannot be one, or need not
      const double runs = runs_in_attempt(held, candidate.grip());
      if (runs != 0.0 && candidate.has_place(tied, m) && candidate.is_alone(without_rings_, bodies, dt)) {
        begun_.push_back({m, held.grip, runs});
      }
    }
  }
  return begun_.size() > known;
}

std::span<const IslandCord> Rings::undo() {
  for (std::size_t k = 0; k < saved_cords_; ++k) {
    const Before& before = before_[k];
    Cord::State& state = before.cord->state;
    state.positions = before.positions;
    state.velocities = before.velocities;
    state.masses = before.masses;
    state.rest = before.rest;
    state.rest_targets = before.rest_targets;
    state.pulleys.clear();
    before.cord->has_rings = false;
    before.cord->elasticity->set_rest_lengths(state.rest);
    before.cord->leave_out_links_on_wheels();
  }
  saved_cords_ = 0;
  rings_.clear();
  return without_rings_;
}

namespace {

Vec2 velocity_of_axle(const IslandState& state, const Wheel& wheel) {
  return state.velocities[state.center(wheel.solved_index)] +
         state.velocities[state.angle(wheel.solved_index)].x * perp(arm_of(state, wheel, state.positions));
}

/// Gives the points on a wheel the velocities of its lines. They move across these as the points at their ends do.
void turn_lines(const IslandState& state, const Wheel& wheel, const Pulley& pulley, Cord::State& cord) {
  const WheelSides sides = sides_of(state, wheel, state.positions);
  const Vec2 carried = velocity_of_axle(state, wheel);
  const double trail = wheel.trail + state.positions[state.groove_of(wheel)].x;
  double distance = 0.0;
  for (int p = pulley.def.before + 1; p < pulley.def.after; ++p) {
    distance += cord.rest[at(p - 1)];
    const bool is_before = distance < pulley.lead;
    const double share = is_before ? (pulley.lead - distance) / pulley.lead : (distance - pulley.lead) / trail;
    const Vec2 across = perp(is_before ? sides.before.line.along : sides.after.line.along);
    const Vec2 end = cord.velocities[at(is_before ? pulley.def.before : pulley.def.after)];
    cord.velocities[at(p)] += share * dot(across, end - carried) * across;
  }
}

/// Moves the point on a wheel that is nearest to the ring there, and changes the rest lengths of its links by as much.
/// Half of the rope at the ring runs in each direction. Returns the point.
int move_nearest(const IslandState& state, const Wheel& wheel, const Pulley& pulley, CordParts& cord) {
  int nearest = pulley.def.before + 1;
  double distance = 0.0;  // m, at rest, from the point before the wheel
  double part = 0.0;      // m, from the point before the nearest one to the ring
  double least = std::numeric_limits<double>::infinity();
  for (int p = pulley.def.before + 1; p < pulley.def.after; ++p) {
    const double start = distance;
    distance += cord.state.rest[at(p - 1)];
    if (std::abs(distance - pulley.lead) >= least) continue;
    least = std::abs(distance - pulley.lead);
    nearest = p;
    part = pulley.lead - start;
  }
  const double both = cord.state.rest[at(nearest - 1)] + cord.state.rest[at(nearest)];
  part = std::clamp(part, least_share * both, (1.0 - least_share) * both);
  set_rest_lengths(cord, nearest - 1, part, both - part);
  const WheelSides sides = sides_of(state, wheel, state.positions);
  cord.state.positions[at(nearest)] =
      state.positions[state.center(wheel.solved_index)] + arm_of(state, wheel, state.positions);
  cord.state.velocities[at(nearest)] =
      velocity_of_axle(state, wheel) + (0.5 * pulley.speed) * (sides.before.line.along + sides.after.line.along);
  return nearest;
}

/// Sets the tensions of the links of a wheel, at whose ring is this point. The links are damped, unlike the wheel.
void set_tensions(CordParts& cord, const Pulley& pulley, int ring) {
  const bool damped = cord.def.damping > 0.0 && std::isfinite(cord.def.stretch_stiffness);
  for (int link = pulley.def.before; link < pulley.def.after; ++link) {
    double& tension = cord.state.tensions[at(link)];
    tension = link < ring ? pulley.tension_before : pulley.tension_after;
    const Vec2 way = cord.state.positions[at(link + 1)] - cord.state.positions[at(link)];
    const double size = length(way);
    if (!damped || size == 0.0) continue;
    const double rate = dot(cord.state.velocities[at(link + 1)] - cord.state.velocities[at(link)], way) / size;
    tension += cord.def.damping * rate * cord.def.stretch_stiffness / cord.state.rest[at(link)];
  }
}

/// The pull has what the points on the wheel weigh, less what accelerates them.
Cord::Holder holder_of(const IslandState& state, const Wheel& wheel, const Pulley& pulley, Vec2 gravity) {
  const WheelSides sides = sides_of(state, wheel, state.positions);
  const std::size_t center = state.center(wheel.solved_index);
  const std::size_t angle = state.angle(wheel.solved_index);
  Cord::Holder holder;
  holder.velocity = state.velocities[center];
  holder.turning = state.velocities[angle].x;
  holder.acceleration = state.accelerations[center];
  holder.angular_acceleration = state.accelerations[angle].x;
  const Vec2 along = 0.5 * (sides.before.line.along + sides.after.line.along);
  const Vec2 acceleration = holder.acceleration + pulley.acceleration * along;
  holder.pull = pulley.tension_after * sides.after.line.along - pulley.tension_before * sides.before.line.along +
                wheel.cord_mass * (gravity - acceleration);
  holder.slips = pulley.speed != 0.0;
  return holder;
}

}  // namespace

void Rings::take_off(const IslandState& state) {
  for_each_cord(
      [&](std::size_t member, std::span<const Ring> rings) { take_off(state, state.members[member], rings); });
}

void Rings::take_off(const IslandState& state, const Member& member, std::span<const Ring> rings) {
  CordParts& cord = *member.cord;
  std::vector<Cord::Holder>& holders = cord.state.holders;
  const auto is_ring = [rings](int grip) {
    return std::any_of(rings.begin(), rings.end(), [grip](const Ring& ring) { return ring.grip == at(grip); });
  };
  for (Cord::Holder& holder : holders) {  // their grips were counted without the rings
    int left = holder.grip;
    for (holder.grip = 0; is_ring(holder.grip) || left > 0; ++holder.grip) left -= is_ring(holder.grip) ? 0 : 1;
  }
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const Wheel& wheel = state.wheels[member.first_wheel + k];
    const Pulley& pulley = cord.state.pulleys[k];
    turn_lines(state, wheel, pulley, cord.state);
    Cord::Holder holder = holder_of(state, wheel, pulley, cord.def.gravity_scale * state.gravity);
    holder.point = move_nearest(state, wheel, pulley, cord);
    holder.grip = static_cast<int>(rings[k].grip);
    holder.slid = holder.point - rings[k].column;
    set_tensions(cord, pulley, holder.point);
    const auto behind = std::upper_bound(holders.begin(), holders.end(), holder.point,
                                         [](int point, const Cord::Holder& other) { return point < other.point; });
    holders.insert(behind, holder);
  }
  cord.state.pulleys.clear();
  cord.has_rings = false;
  cord.state.restart = true;
  cord.leave_out_links_on_wheels();
}

}  // namespace ribbon
