#include "ribbon/system/grips.h"

#include <algorithm>
#include <cmath>

#include "ribbon/elastic/link.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double grip_share = 1e-7;  // min. compliance of a grip along the cord, as a share of the point's own
constexpr double max_draw = 0.25;    // of a link, by which a step draws a point towards an anchor that is elsewhere
constexpr double min_travel = 1e-3;  // of a link, above which the displacement of an anchor counts as work

/// The arm begins where the cord is, so that nothing jumps. It ends at the anchor, or as much nearer to it as a step
/// may draw a point: less, if steps before it were taken back, which otherwise would hang.
HeldBody make_grip(const IslandState& state, const Member& member, std::size_t index) {
  const Grip& grip = member.surroundings.grips[index];
  const RigidBody& body = state.rigid[at(grip.body)];
  const CordDef& def = member.cord->def;
  const double link = member.cord->state.rest[0];
  HeldBody held;
  held.grip = index;
  held.rigid_index = grip.body;
  held.turns = body.inverse_inertia > 0.0;
  if (!grip.caught) held.strength = grip.strength;
  held.across = grip.across;
  held.returns = grip.returns;
  held.beside = grip.beside;
  const int column = grip.point / def.rows;
  held.column = column + grip.along;
  held.climb = std::clamp(held.column + grip.climb, 0.0, def.points - 1.0) - held.column;
  held.point = member.first_point + at(grip.point);
  held.next = held.point;
  held.along = grip.along;
  if (grip.along > 0.0 || (held.may_slip() && column + 1 < def.points)) held.next += at(def.rows);
  held.arm = held.hold(state.positions) - body.position;
  const Vec2 off = grip.offset - held.arm;
  const double max_off = member.cord->state.depenetration_share * max_draw * link;
  held.travel = grip.travel + (length(off) > max_off ? (max_off / length(off)) * off : off);
  // What brings a grip back that has slipped past a bend, or was pushed off its cord, is not its own work.
  const Vec2 own_travel = held.may_slip() || held.returns ? grip.travel : held.travel;
  const double displacement = length(own_travel) + std::abs(held.climb) * link;
  held.displacement = displacement > min_travel * link ? displacement : 0.0;
  return held;
}

bool yields_along(const HeldBody& held) { return held.slip_sign != 0.0 || held.limited; }

/// Returns where between its points a grip acts on the cord, as a share of the link. An anchor that has slipped by w
/// along t, the direction of a link of length L, stays on the line of the link as the link turns. With n = perp(t) and
/// the separation c = −w·t, the part across, n·c, changes by
///
///     n·δc + δn·c = n·δc + w·n·(δb − δa)/L,
///
/// as if the grip were w/L further along.
double acting_share(const IslandState& state, const HeldBody& held) {
  if (held.next == held.point || !yields_along(held) || held.across != Vec2{}) return held.along;
  const Vec2 ab = state.positions[held.next] - state.positions[held.point];
  const double size2 = dot(ab, ab);
  const double slip = size2 > 0.0 ? -dot(grip_separation(state, held, state.positions), ab) / size2 : 0.0;
  return held.along + std::clamp(slip, -1.0, 1.0);
}

/// Adds one grip to the system. With c = x − X − s the separation, which is to close, and φ the body's angle,
/// ∂c/∂φ = −perp(s) and ∂²c/∂φ² = s. A grip that slips along the cord closes across it only, and pulls along it with
/// its strength. So does one that may slip where contacts are linearised once: there a limited row holds it along the
/// cord.
void load_grip(const IslandState& state, std::size_t k, std::span<const double> inertia, BlockLdlt& blocks,
               std::span<Vec2> right_side) {
  const HeldBody& held = state.held[k];
  const Vec2 arm = held.arm_at(state.positions[state.angle(held.solved_index)].x);
  const Vec2 u = -perp(arm);
  const Vec2 t = grip_tangent(state, held, state.positions);
  const bool slips = yields_along(held);
  const Block across = slips ? Block{t.y * t.y, -t.x * t.y, t.x * t.x} : Block{1.0, 0.0, 1.0};
  const auto closing = [&across](Vec2 v) {
    return Vec2{across.xx * v.x + across.xy * v.y, across.xy * v.x + across.yy * v.y};
  };
  const int dual = state.grip_dual(k);
  const std::array<int, 4> slots = grip_slots(state, held);
  const double acting = acting_share(state, held);
  const std::array<double, 3> acts = {1.0 - acting, acting, -1.0};
  const std::array<double, 3> pulls = {1.0 - held.along, held.along, -1.0};
  const Vec2 friction = (slips && !held.limited ? held.slip_sign * held.strength : 0.0) * t;
  for (std::size_t i = 0; i < 3; ++i) {
    right_side[at(slots[i])] -= pulls[i] * friction;
    const double w = acts[i];
    if (w != 0.0) blocks.add(slots[i], dual, w * across.xx, w * across.xy, w * across.xy, w * across.yy);
  }
  const Vec2 turning = closing(u);
  blocks.add(slots[3], dual, turning.x, turning.y, 0.0, 0.0);
  right_side[at(slots[3])].x -= dot(u, friction);
  blocks.add(slots[3], std::max(0.0, dot(grip_pull(state, state.tensions, k), arm)), 0.0, 0.0);
  const double compliance = min_dual_compliance / std::max(inertia[held.point], inertia[held.next]);
  blocks.make_dual(dual);
  blocks.add(dual, -compliance - (1.0 - across.xx), across.xy, -compliance - (1.0 - across.yy));
  right_side[at(dual)] = -closing(grip_separation(state, held, state.positions));
}

}  // namespace

void add_grips(IslandState& state, Member& member) {
  member.first_grip = state.held.size();
  for (std::size_t k = 0; k < member.surroundings.grips.size(); ++k) {
    const Grip& grip = member.surroundings.grips[k];
    const RigidBody& body = state.rigid[at(grip.body)];
    if (body.inverse_mass > 0.0 || grip.along != 0.0 || grip.climb != 0.0 ||
        (std::isfinite(grip.strength) && !grip.caught)) {
      const HeldBody held = make_grip(state, member, k);
      const auto first = state.held.begin() + static_cast<std::ptrdiff_t>(member.first_grip);
      const auto after = std::upper_bound(first, state.held.end(), held.point,
                                          [](std::size_t point, const HeldBody& other) { return point < other.point; });
      state.held.insert(after, held);
    } else if (const std::size_t p = member.first_point + at(grip.point); state.constrained[p] == 0) {
      const Vec2 anchor = times(rotation(state.dt * body.angular_velocity), grip.offset + grip.travel);
      state.drive(p, (1.0 / state.dt) * (body.position + state.dt * body.velocity + anchor - state.positions[p]));
    }
  }
  member.end_grip = state.held.size();
  for (std::size_t k = member.first_grip; k < member.end_grip; ++k) {
    state.held[k].solved_index = state.solved_body(state.held[k].rigid_index);
  }
}

bool move_climbing_grips(IslandState& state, const Member& member) {
  const auto rows = at(member.cord->def.rows);
  bool moved = false;
  for (std::size_t k = member.first_grip; k < member.end_grip; ++k) {
    HeldBody& held = state.held[k];
    if (held.climb == 0.0) continue;
    const double column = held.column + held.share * held.climb;
    const double whole = std::min(std::floor(column), member.cord->def.points - 2.0);
    const std::size_t row = (held.point - member.first_point) % rows;
    held.point = member.first_point + static_cast<std::size_t>(whole) * rows + row;
    held.next = held.point + rows;
    held.along = column - whole;
    moved = true;
  }
  return moved;
}

std::array<int, 4> grip_slots(const IslandState& state, const HeldBody& held) {
  return {static_cast<int>(held.point), static_cast<int>(held.next), static_cast<int>(state.center(held.solved_index)),
          static_cast<int>(state.angle(held.solved_index))};
}

Vec2 grip_separation(const IslandState& state, const HeldBody& held, std::span<const Vec2> x) {
  return held.hold(x) - x[state.center(held.solved_index)] - held.arm_at(x[state.angle(held.solved_index)].x);
}

Vec2 grip_tangent(const IslandState& state, const HeldBody& held, std::span<const Vec2> x) {
  std::size_t a = held.point;
  std::size_t b = held.next;
  for (const Member& member : state.members) {
    const auto rows = at(member.cord->def.rows);
    if (a != b || !member.has_point(a)) continue;
    b + rows < member.end_point() ? b += rows : a -= rows;
  }
  const Vec2 ab = x[b] - x[a];
  if (held.across != Vec2{}) return dot(perp(held.across), ab) < 0.0 ? -perp(held.across) : perp(held.across);
  const double size = length(ab);
  return size > 0.0 ? (1.0 / size) * ab : Vec2{1.0, 0.0};
}

Vec2 grip_pull(const IslandState& state, std::span<const double> tensions, std::size_t grip) {
  const std::size_t first = tensions.size() - 2 * (state.held.size() - grip);
  return {tensions[first], tensions[first + 1]};
}

Vec2 grip_reaction(const IslandState& state, std::size_t grip) {
  if (state.coupled) return grip_pull(state, state.tensions, grip);
  const std::size_t k = state.held[grip].solved_index;
  const RigidBody& body = state.rigid_of(state.bodies[k]);
  const std::size_t c = state.center(k);
  return (1.0 / state.dt) * (state.masses[c] * (state.velocities[c] - body.velocity - state.dt * body.acceleration));
}

void load_grips(const IslandState& state, std::span<const double> inertia, BlockLdlt& blocks,
                std::span<Vec2> right_side) {
  for (std::size_t k = 0; k < state.held.size(); ++k) load_grip(state, k, inertia, blocks, right_side);
}

bool update_grips(IslandState& state, std::span<const Vec2> solution, std::span<double> next) {
  bool slip_began = false;
  for (std::size_t k = 0; k < state.held.size(); ++k) {
    HeldBody& held = state.held[k];
    const Vec2 t = grip_tangent(state, held, state.positions);
    Vec2 pull = solution[at(state.grip_dual(k))];
    if (held.limited) {
      pull += (held.slip_force - dot(pull, t)) * t;
    } else if (held.slip_sign == 0.0 && std::abs(dot(pull, t)) > held.strength) {
      held.slip_sign = std::copysign(1.0, dot(pull, t));
      slip_began = true;
    }
    if (held.slip_sign != 0.0 && !held.limited) pull += (held.slip_sign * held.strength - dot(pull, t)) * t;
    const std::size_t first = next.size() - 2 * (state.held.size() - k);
    next[first] = pull.x;
    next[first + 1] = pull.y;
  }
  return slip_began;
}

double grip_potential(const IslandState& state, std::span<const double> max_tensions, std::span<const Vec2> x) {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.held.size(); ++k) {
    const HeldBody& held = state.held[k];
    const Vec2 separation = grip_separation(state, held, x);
    const double slope = length(grip_pull(state, max_tensions, k));
    if (held.limited) {
      sum += slope * std::abs(cross(grip_tangent(state, held, x), separation));
    } else if (held.slip_sign == 0.0) {
      sum += slope * length(separation);
    } else {
      const Vec2 t = grip_tangent(state, held, x);
      sum += slope * std::abs(cross(t, separation)) + held.slip_sign * held.strength * dot(t, separation);
    }
  }
  return sum;
}

void append_slip_rows(const IslandState& state, std::span<const double> inertia, LimitedRows& rows) {
  for (const HeldBody& held : state.held) {
    if (!held.limited) continue;
    const Vec2 t = grip_tangent(state, held, state.positions);
    const Vec2 u = -perp(held.arm_at(state.positions[state.angle(held.solved_index)].x));
    SlotRow row;
    row.add(static_cast<int>(held.point), (1.0 - held.along) * t);
    row.add(static_cast<int>(held.next), held.along * t);
    row.add(static_cast<int>(state.center(held.solved_index)), -t);
    row.add(static_cast<int>(state.angle(held.solved_index)), {dot(u, t), 0.0});
    const double compliance = grip_share / std::max(inertia[held.point], inertia[held.next]);
    const double separation = dot(t, grip_separation(state, held, state.positions)) - held.ahead;
    rows.add({row, separation, compliance, -held.strength, held.strength, -held.slip_force});
  }
}

void take_slip_rows(IslandState& state, const LimitedRows& rows) {
  std::size_t row = rows.rows().size();
  for (std::size_t k = state.held.size(); k-- > 0;) {
    HeldBody& held = state.held[k];
    if (!held.limited) continue;
    held.slip_force = -rows.rows()[--row].force;
    held.slip_sign = std::abs(held.slip_force) < held.strength ? 0.0 : std::copysign(1.0, held.slip_force);
  }
}

double grip_work(const IslandState& state) {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.held.size(); ++k) {
    const HeldBody& held = state.held[k];
    if (held.displacement == 0.0) continue;
    const std::size_t c = state.center(held.solved_index);
    const double dt = state.start.dt;
    const Vec2 acceleration = (1.0 / dt) * (state.velocities[c] - state.start.velocities[c]);
    const Vec2 pull = state.coupled ? grip_pull(state, state.tensions, k)
                                    : state.masses[c] * (acceleration - state.free_accelerations[c]);
    sum += 2.0 * length(pull) * held.displacement * dt / state.dt;
  }
  return sum;
}

}  // namespace ribbon
