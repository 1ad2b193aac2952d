#include <algorithm>
#include <cmath>
#include <limits>

#include "ribbon/elastic/link.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/island/island.h"

// Bodies that hold cords: where along them, and their part of the solve by blocks.

namespace ribbon {
namespace {

constexpr double grip_share = 1e-7;   // least compliance of a grip along the cord, as a share of the point's own give
constexpr double drawn_share = 0.25;  // of a link, that a point is drawn to a hand that is elsewhere in a step
constexpr double unworthy_travel = 1e-3;  // of a link, that a hand may move on its body without counting as work

}  // namespace

/// A body that nothing pushes and that holds a point drives it; all others are solved with the cord.
void Island::take_hold(Member& member) {
  member.first_hold = held_.size();
  for (std::size_t k = 0; k < member.met.grips.size(); ++k) {
    const Grip& grip = member.met.grips[k];
    const RigidBody& body = rigid_[at(grip.body)];
    if (body.inverse_mass > 0.0 || grip.along != 0.0 || grip.climb != 0.0) {
      add_hold(member, k);
    } else if (const std::size_t p = member.first + at(grip.point); constrained_[p] == 0) {
      const Vec2 hand = times(rotation(step_dt_ * body.angular_velocity), grip.offset + grip.travel);
      drive(p, (1.0 / step_dt_) * (body.position + step_dt_ * body.velocity + hand - positions_[p]));
    }
  }
  member.last_hold = held_.size();
  for (std::size_t k = member.first_hold; k < member.last_hold; ++k) held_[k].body = body_slot(held_[k].rigid);
}

/// The arm begins where the cord is, so that nothing jumps, and ends at the hand, or as much nearer as a point may be
/// drawn in a step.
void Island::add_hold(Member& member, std::size_t index) {
  const Grip& grip = member.met.grips[index];
  const RigidBody& body = rigid_[at(grip.body)];
  const Cord& cord = *member.cord;
  HeldBody held;
  held.grip = index;
  held.rigid = grip.body;
  held.turns = body.inverse_inertia > 0.0;
  held.strength = grip.strength;
  const int column = grip.point / cord.def_.rows;
  held.column = column + grip.along;
  held.climb = std::clamp(held.column + grip.climb, 0.0, cord.def_.points - 1.0) - held.column;
  held.point = member.first + at(grip.point);
  held.next = held.point;
  held.along = grip.along;
  if (grip.along > 0.0 || (held.may_slip() && column + 1 < cord.def_.points)) held.next += at(cord.def_.rows);
  held.arm = held.hold(positions_) - body.position;
  const Vec2 off = grip.offset - held.arm;
  const double most = drawn_share * cord.rest_lengths_[0];
  held.travel = grip.travel + (length(off) > most ? (most / length(off)) * off : off);
  const double way = length(held.travel) + std::abs(held.climb) * cord.rest_lengths_[0];
  held.way = way > unworthy_travel * cord.rest_lengths_[0] ? way : 0.0;
  const auto first = held_.begin() + static_cast<std::ptrdiff_t>(member.first_hold);
  const auto after = std::upper_bound(first, held_.end(), held.point,
                                      [](std::size_t point, const HeldBody& other) { return point < other.point; });
  held_.insert(after, held);
}

/// Takes grips that climb to where they are at the end of the stage.
void Island::climb(const Member& member) {
  const auto rows = at(member.cord->def_.rows);
  for (std::size_t k = member.first_hold; k < member.last_hold; ++k) {
    HeldBody& held = held_[k];
    if (held.climb == 0.0) continue;
    const double column = held.column + held.share * held.climb;
    const double whole = std::min(std::floor(column), member.cord->def_.points - 2.0);
    held.point = member.first + static_cast<std::size_t>(whole) * rows + (held.point - member.first) % rows;
    held.next = held.point + rows;
    held.along = column - whole;
    has_pattern_ = false;
  }
}

/// Where the cord is held less where the hand is.
Vec2 Island::hold_gap(const HeldBody& held, std::span<const Vec2> x) const {
  return held.hold(x) - x[center(held.body)] - held.arm_at(x[angle(held.body)].x);
}

/// Where between its points a hold presses on the cord, as a share of the way. A hand that has slipped by w along t,
/// the direction of a link of length L, stays on the line of the link as that turns: with n = perp(t) and the gap −w·t
/// what closes across, n·c, changes by n·δc + δn·c = n·δc + w·n·(δb − δa)/L, as if it were held w/L further on.
double Island::pressed_along(const HeldBody& held) const {
  if (held.next == held.point || !(held.slides != 0.0 || is_limited(held))) return held.along;
  const Vec2 ab = positions_[held.next] - positions_[held.point];
  const double size2 = dot(ab, ab);
  const double slid = size2 > 0.0 ? -dot(hold_gap(held, positions_), ab) / size2 : 0.0;
  return held.along + std::clamp(slid, -1.0, 1.0);
}

/// A hold's pull λ on the body is an unknown: with c = x − X − s the gap, which is to close, ∂c/∂φ = −perp(s) and
/// ∂²c/∂φ² = s. One that slips along the cord does so against its strength, and only closes across; so does one that
/// may slip where contacts are posed once, for then a limited row holds it along the cord.
void Island::load_holds() {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const HeldBody& held = held_[k];
    const Vec2 arm = held.arm_at(positions_[angle(held.body)].x);
    const Vec2 u = -perp(arm);
    const Vec2 t = hold_tangent(held, positions_);
    const bool slips = held.slides != 0.0 || is_limited(held);
    const Block across = slips ? Block{t.y * t.y, -t.x * t.y, t.x * t.x} : Block{1.0, 0.0, 1.0};
    const auto closing = [&across](Vec2 v) {
      return Vec2{across.xx * v.x + across.xy * v.y, across.xy * v.x + across.yy * v.y};
    };
    const int dual = hold_dual(k);
    const std::array<int, 4> slots = hold_slots(held);
    const double pressed = pressed_along(held);
    const std::array<double, 3> pressing = {1.0 - pressed, pressed, -1.0};
    const std::array<double, 3> pulling = {1.0 - held.along, held.along, -1.0};
    const Vec2 against = (held.slides * (slips ? held.strength : 0.0)) * t;
    for (std::size_t i = 0; i < 3; ++i) {
      right_side_[at(slots[i])] -= pulling[i] * against;
      const double w = pressing[i];
      if (w != 0.0) blocks_.add(slots[i], dual, w * across.xx, w * across.xy, w * across.xy, w * across.yy);
    }
    const Vec2 turning = closing(u);
    blocks_.add(slots[3], dual, turning.x, turning.y, 0.0, 0.0);
    right_side_[at(slots[3])].x -= dot(u, against);
    blocks_.add(slots[3], std::max(0.0, dot(hold_pull(tensions_, k), arm)), 0.0, 0.0);
    const double least = min_dual_compliance / std::max(inertia_[held.point], inertia_[held.next]);
    blocks_.make_dual(dual);
    blocks_.add(dual, -least - (1.0 - across.xx), across.xy, -least - (1.0 - across.yy));
    right_side_[at(dual)] = -closing(hold_gap(held, positions_));
  }
}

void Island::update_holds() {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    HeldBody& held = held_[k];
    const Vec2 t = hold_tangent(held, positions_);
    Vec2 pull = right_side_[at(hold_dual(k))];
    if (is_limited(held)) {
      pull += (held.along_pull - dot(pull, t)) * t;
    } else if (held.slides == 0.0 && std::abs(dot(pull, t)) > held.strength) {
      held.slides = std::copysign(1.0, dot(pull, t));
      slips_ = true;
    }
    if (held.slides != 0.0 && !is_limited(held)) pull += (held.slides * held.strength - dot(pull, t)) * t;
    const std::size_t first = next_.size() - 2 * (held_.size() - k);
    next_[first] = pull.x;
    next_[first + 1] = pull.y;
  }
}

/// Appends a row for each hold that may slip: along the cord it gives way by next to nothing up to its strength.
void Island::append_slips() {
  for (HeldBody& held : held_) {
    if (!is_limited(held)) continue;
    const Vec2 t = hold_tangent(held, positions_);
    const Vec2 u = -perp(held.arm_at(positions_[angle(held.body)].x));
    SlotRow row;
    row.add(static_cast<int>(held.point), (1.0 - held.along) * t);
    row.add(static_cast<int>(held.next), held.along * t);
    row.add(static_cast<int>(center(held.body)), -t);
    row.add(static_cast<int>(angle(held.body)), {dot(u, t), 0.0});
    const double give = grip_share / std::max(inertia_[held.point], inertia_[held.next]);
    limited_.add({row, dot(t, hold_gap(held, positions_)), give, -held.strength, held.strength, -held.along_pull});
  }
}

/// After a solve: what they pull with, and whether they slip.
void Island::take_slips() {
  std::size_t row = limited_.rows().size();
  for (std::size_t k = held_.size(); k-- > 0;) {
    HeldBody& held = held_[k];
    if (!is_limited(held)) continue;
    held.along_pull = -limited_.rows()[--row].force;
    held.slides = std::abs(held.along_pull) < held.strength ? 0.0 : std::copysign(1.0, held.along_pull);
  }
}

bool Island::is_limited(const HeldBody& held) const { return posing_ && held.may_slip(); }

/// Along the cord where it is held.
Vec2 Island::hold_tangent(const HeldBody& held, std::span<const Vec2> x) const {
  std::size_t a = held.point;
  std::size_t b = held.next;
  for (const Member& member : members_) {
    const auto rows = at(member.cord->def_.rows);
    if (a != b || a < member.first || a >= member.first + member.count) continue;
    b + rows < member.first + member.count ? b += rows : a -= rows;
  }
  const Vec2 ab = x[b] - x[a];
  const double size = length(ab);
  return size > 0.0 ? (1.0 / size) * ab : Vec2{1.0, 0.0};
}

/// What a grip that slips has left open along the cord is how far it has slipped.
void Island::slip() {
  for (HeldBody& held : held_) {
    if (held.slides == 0.0) continue;
    const double along = -dot(hold_gap(held, positions_), hold_tangent(held, positions_));
    for (const Member& member : members_) {
      if (held.point >= member.first && held.point < member.first + member.count) {
        const double slid = along / member.cord->rest_lengths_[0];
        held.slid = std::isfinite(slid) ? slid : 0.0;
      }
    }
  }
}

Vec2 Island::hold_pull(std::span<const double> tensions, std::size_t hold) const {
  const std::size_t first = tensions.size() - 2 * (held_.size() - hold);
  return {tensions[first], tensions[first + 1]};
}

double Island::hold_potential(std::span<const Vec2> x) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const Vec2 gap = hold_gap(held_[k], x);
    const double most = length(hold_pull(most_tensions_, k));
    if (is_limited(held_[k])) {
      sum += most * std::abs(cross(hold_tangent(held_[k], x), gap));
    } else if (held_[k].slides == 0.0) {
      sum += most * length(gap);
    } else {
      const Vec2 t = hold_tangent(held_[k], x);
      sum += most * std::abs(cross(t, gap)) + held_[k].slides * held_[k].strength * dot(t, gap);
    }
  }
  return sum;
}

/// J, the most that hands which move on their bodies, or along a cord, can have done in a substep: by twice what they
/// pull with at its end or, of bodies that nothing else moves, pulled with on average.
double Island::work_of_hands(double dt) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    if (held_[k].way == 0.0) continue;
    const std::size_t c = center(held_[k].body);
    const Vec2 pull = together_
                          ? hold_pull(tensions_, k)
                          : masses_[c] * ((1.0 / dt) * (velocities_[c] - v0_[c]) - bodies_[held_[k].body].acceleration);
    sum += 2.0 * length(pull) * held_[k].way * dt / step_dt_;
  }
  return sum;
}

/// Of the hold's solve, or of what moved the body if nothing else did.
Vec2 Island::pull_of(std::size_t hold, double dt) const {
  if (together_) return hold_pull(tensions_, hold);
  const std::size_t k = held_[hold].body;
  const RigidBody& body = rigid_[at(bodies_[k].index)];
  return (1.0 / dt) * (masses_[center(k)] * (velocities_[center(k)] - body.velocity - dt * body.acceleration));
}

}  // namespace ribbon
