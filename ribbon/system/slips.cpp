#include "ribbon/system/slips.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ribbon/cord_line.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/grips.h"

namespace ribbon {
namespace {

// Of a link, from a point, above which an anchor that passes it within a step is beside it and held across the way to
// it. Anything larger would let what hangs in a bend fall along a link until the next step.
constexpr double beside_share = 1e-6;

/// Returns how far a grip has slipped from its place, columns.
double slip_from_place(const IslandState& state, const Member& member, const HeldBody& held) {
  if (held.slip_sign == 0.0 && held.ahead == 0.0) return 0.0;
  const Vec2 t = grip_tangent(state, held, state.positions);
  const double columns = -dot(grip_separation(state, held, state.positions), t) / member.cord->state.rest[0];
  return std::isfinite(columns) ? columns : 0.0;
}

CordLine line_of(const IslandState& state, const Member& member, const HeldBody& held) {
  const int rows = member.cord->def.rows;
  const auto point = static_cast<int>(held.point - member.first_point);
  return {IslandState::points_of(member, state.positions), rows, point % rows};
}

/// Returns how fast the anchor of a grip moves along a direction of its cord, relative to it, m/s.
double slip_speed(const IslandState& state, const HeldBody& held, Vec2 tangent) {
  const std::size_t center = state.center(held.solved_index);
  const std::size_t angle = state.angle(held.solved_index);
  const Vec2 arm = held.arm_at(state.positions[angle].x);
  const Vec2 anchor = state.velocities[center] + state.velocities[angle].x * perp(arm);
  return dot(anchor - held.hold(state.velocities), tangent);
}

/// Where a way along a row of a cord ends.
struct WayEnd {
  int link = 0;         ///< the last link of the way
  double into = 0.0;    ///< the share of it that is gone, 0 … 1
  int sharp_bend = -1;  ///< column of a bend by more than a right angle, at which the way ends; −1: there is none
};

/// Follows a way [m] from a share of a link, forward or back, as far as the cord leads.
WayEnd follow_way(const CordLine& line, int link, double along, bool forward, double way) {
  const Vec2 first = line.tangent(link);
  double into = forward ? along : 1.0 - along;
  double left = way;
  for (;;) {
    const double to_end = (1.0 - into) * line.length_of(link);
    const int next = link + (forward ? 1 : -1);
    if (!(to_end < left)) return {link, std::min(1.0, into + left / line.length_of(link))};
    if (next < 0 || next >= line.links()) return {link, 1.0};
    const Vec2 tangent = line.tangent(next);
    if (dot(tangent, line.tangent(link)) < 0.0 || dot(tangent, first) < 0.0) return {link, 1.0, std::max(link, next)};
    left -= to_end;
    link = next;
    into = 0.0;
  }
}

/// A grip that slides past a bend between links of the directions t and t' is turned from t to t'. What keeps its speed
/// is a force across the direction between them, t + t'. So it is held across that, at the place of the cord where it
/// will be if friction alone slows it down. A bend by more than a right angle leads back: it stops the grip.
void aim_slip(IslandState& state, const Member& member, HeldBody& held, double dt) {
  if (!held.may_slip() || held.climb != 0.0 || held.across != Vec2{} || held.next == held.point) return;
  const CordLine line = line_of(state, member, held);
  const auto point = static_cast<int>(held.point - member.first_point);
  const int link = point / line.rows();
  const double speed = slip_speed(state, held, line.tangent(link));
  const double slowed = dt * held.strength * state.rigid_of(state.bodies[held.solved_index]).inverse_mass;
  const double way = dt * std::abs(speed) - dt * slowed;
  if (!(way > 0.0)) return;
  const bool forward = speed > 0.0;
  const WayEnd end = follow_way(line, link, held.along, forward, way);
  const auto point_at = [&](int column) { return member.first_point + at(column * line.rows() + point % line.rows()); };
  if (end.sharp_bend >= 0) {
    held.slid_before = end.sharp_bend - held.column;
    held.point = held.next = point_at(end.sharp_bend);
    held.along = 0.0;
    held.strength = std::numeric_limits<double>::infinity();
  } else if (end.link != link) {
    const Vec2 start = held.hold(state.positions);
    held.point = point_at(end.link);
    held.next = point_at(end.link + 1);
    held.along = forward ? end.into : 1.0 - end.into;
    held.slid_before = end.link + held.along - held.column;
    const Vec2 between = line.tangent(link) + line.tangent(end.link);
    const Vec2 t = (1.0 / length(between)) * between;
    held.across = perp(t);
    held.ahead = dot(held.hold(state.positions) - start, t);
    held.slip_sign = forward ? -1.0 : 1.0;
  }
}

/// Moves the place of a grip to where it has slipped to. Its anchor is there too from now on, or nothing would hold it
/// where it is, and goes on as it moves on its body. What is left to the body's own anchor is for later steps: drawn at
/// once, it would throw the cord. Returns false if it did not slip, or past an end.
bool follow_slip(IslandState& state, const Member& member, std::size_t k) {
  HeldBody& held = state.held[k];
  const CordDef& def = member.cord->def;
  const double column = held.column + held.slid_before + slip_from_place(state, member, held);
  const bool stays = held.slip_sign == 0.0 && held.ahead == 0.0;
  if (stays || held.climb != 0.0 || !(column >= 0.0 && column <= def.points - 1.0)) return false;
  const std::size_t point = held.point - member.first_point;
  const CordLine line = line_of(state, member, held);
  const Vec2 center = state.positions[state.center(held.solved_index)];
  const double angle = state.positions[state.angle(held.solved_index)].x;
  const auto from_body = [angle](Vec2 v) { return times(rotation(angle), v); };
  const auto to_body = [angle](Vec2 v) { return times(rotation(-angle), v); };
  const Vec2 anchor = center + held.arm_at(angle) + from_body(held.beside);
  const double nearest = line.nearest_column(std::min(static_cast<int>(column), line.links() - 1), anchor);
  if (!std::isfinite(nearest)) return false;  // its distance is no double
  const int whole = std::min(static_cast<int>(nearest), line.links());
  held.slid_before = nearest - held.column;
  held.point = member.first_point + at(whole * def.rows) + point % at(def.rows);
  held.next = whole < line.links() ? held.point + at(def.rows) : held.point;
  held.along = nearest - whole;
  held.ahead = 0.0;
  const Vec2 place = held.hold(state.positions);
  const Vec2 off = anchor - place;
  const bool passes_point = held.along == 0.0 && whole > 0 && whole < line.links();
  held.across = passes_point && length(off) > beside_share * line.length_of(whole) ? (1.0 / length(off)) * off : Vec2{};
  held.beside = to_body(off);
  held.travel = member.surroundings.grips[held.grip].travel;
  held.arm = to_body(place - center) - held.share * held.travel;
  return true;
}

}  // namespace

void find_slips(IslandState& state) {
  for (const Member& member : state.members) {
    for (std::size_t k = member.first_grip; k < member.end_grip; ++k) {
      HeldBody& held = state.held[k];
      held.slid = held.slid_before + slip_from_place(state, member, held);
    }
  }
}

void aim_slips(IslandState& state, double dt) {
  for (const Member& member : state.members) {
    if (!member.cord->state.pulleys.empty()) continue;  // the place could get onto a wheel
    for (std::size_t k = member.first_grip; k < member.end_grip; ++k) aim_slip(state, member, state.held[k], dt);
  }
}

bool follow_slips(IslandState& state, double dt) {
  bool any = false;
  for (const Member& member : state.members) {
    if (!member.cord->state.pulleys.empty()) continue;
    for (std::size_t k = member.first_grip; k < member.end_grip; ++k) {
      if (!follow_slip(state, member, k)) continue;
      aim_slip(state, member, state.held[k], dt);
      any = true;
    }
  }
  state.restart = state.restart || any;
  return any;
}

}  // namespace ribbon
