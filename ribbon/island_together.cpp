#include <algorithm>
#include <cmath>

#include "ribbon/island.h"
#include "ribbon/link.h"

// The linear solve of several cords, and of bodies that hold or touch them anywhere, as one system of blocks.

namespace ribbon {

/// Points in their order, each body after the last point that it is coupled with, and then its holds: so what is
/// coupled nearby fills little.
void Island::make_pattern() {
  last_point_.assign(bodies_.size(), -1);
  const auto take = [this](int center_slot, int point) {
    int& last = last_point_[(at(center_slot) - count_) / 2];
    last = std::max(last, point);
  };
  for (const HeldBody& held : held_) take(static_cast<int>(center(held.body)), static_cast<int>(held.next));
  contacts_.for_each_touched(take);
  order_.clear();
  const auto append_bodies = [this](int after) {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (last_point_[k] != after) continue;
      order_.push_back(static_cast<int>(center(k)));
      order_.push_back(static_cast<int>(angle(k)));
      for (std::size_t hold = 0; hold < held_.size(); ++hold) {
        if (held_[hold].body == k) order_.push_back(hold_dual(hold));
      }
    }
  };
  append_bodies(-1);
  for (const Member& member : members_) {
    member.cord->elasticity_->order(static_cast<int>(member.first), first_dual(member), order_, append_bodies);
  }
  blocks_.begin_pattern(order_);
  for (const Member& member : members_) {
    member.cord->elasticity_->couple(blocks_, static_cast<int>(member.first), first_dual(member));
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    blocks_.couple(static_cast<int>(center(k)), static_cast<int>(angle(k)));
  }
  for (std::size_t hold = 0; hold < held_.size(); ++hold) {
    for (const int slot : hold_slots(held_[hold])) blocks_.couple(slot, hold_dual(hold));
  }
  contacts_.couple(blocks_);
  blocks_.end_pattern();
}

/// Slots of unknown tensions follow those of points and bodies, those of holds follow them.
int Island::first_dual(const Member& member) const { return static_cast<int>(positions_.size() + member.first_dual); }
int Island::hold_dual(std::size_t hold) const { return static_cast<int>(positions_.size() + duals_ + hold); }

std::array<int, 4> Island::hold_slots(const HeldBody& held) const {
  return {static_cast<int>(held.point), static_cast<int>(held.next), static_cast<int>(center(held.body)),
          static_cast<int>(angle(held.body))};
}

bool Island::newton_step_together(Stage& stage) {
  slips_ = false;
  if (!has_pattern_ || !contacts_.are_coupled(blocks_)) make_pattern();
  has_pattern_ = true;
  blocks_.set_zero();
  right_side_.resize(positions_.size() + duals_ + held_.size());
  for (const Member& member : members_) {
    member.cord->elasticity_->load(stage_of(stage, member), part(positions_, member.first, member.count),
                                   part(tensions_, member.first_tension, member.tensions), blocks_,
                                   static_cast<int>(member.first), first_dual(member), right_side_);
  }
  for (std::size_t p = count_; p < positions_.size(); ++p) {
    right_side_[p] = stage.residual(p, positions_[p]);
    blocks_.add(static_cast<int>(p), inertia_[p], 0.0, inertia_[p]);
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) right_side_[angle(k)].y = 0.0;
  load_holds();
  contacts_.load(positions_, blocks_, right_side_);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] == 0) continue;
    right_side_[p] = {};
    blocks_.hold(static_cast<int>(p));
  }
  if (!blocks_.solve(right_side_)) return false;
  std::copy(right_side_.begin(), right_side_.begin() + static_cast<std::ptrdiff_t>(positions_.size()),
            direction_.begin());
  for (const Member& member : members_) {
    member.cord->elasticity_->update(stage_of(stage, member), part(positions_, member.first, member.count),
                                     part(tensions_, member.first_tension, member.tensions),
                                     part(direction_, member.first, member.count),
                                     part(right_side_, at(first_dual(member)), member.cord->elasticity_->dual_count()),
                                     part(next_, member.first_tension, member.tensions));
  }
  update_holds();
  contacts_.update(direction_);
  return true;
}

/// Where the cord is held less where the hand is.
Vec2 Island::hold_gap(const HeldBody& held, std::span<const Vec2> x) const {
  return held.hold(x) - x[center(held.body)] - held.arm_at(x[angle(held.body)].x);
}

/// A hold's pull λ on the body is an unknown: with c = x − X − s the gap, which is to close, ∂c/∂φ = −perp(s) and
/// ∂²c/∂φ² = s. One that slips along the cord does so against its strength, and only closes across.
void Island::load_holds() {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const HeldBody& held = held_[k];
    const Vec2 arm = held.arm_at(positions_[angle(held.body)].x);
    const Vec2 u = -perp(arm);
    const Vec2 t = hold_tangent(held);
    const bool slips = held.slides != 0.0;
    const Block across = slips ? Block{t.y * t.y, -t.x * t.y, t.x * t.x} : Block{1.0, 0.0, 1.0};
    const auto closing = [&across](Vec2 v) {
      return Vec2{across.xx * v.x + across.xy * v.y, across.xy * v.x + across.yy * v.y};
    };
    const int dual = hold_dual(k);
    const std::array<int, 4> slots = hold_slots(held);
    const std::array<double, 3> weights = {1.0 - held.along, held.along, -1.0};
    const Vec2 against = (held.slides * (slips ? held.strength : 0.0)) * t;
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 0.0) continue;
      blocks_.add(slots[i], dual, weights[i] * across.xx, weights[i] * across.xy, weights[i] * across.xy,
                  weights[i] * across.yy);
      right_side_[at(slots[i])] -= weights[i] * against;
    }
    const Vec2 turning = closing(u);
    blocks_.add(slots[3], dual, turning.x, turning.y, 0.0, 0.0);
    right_side_[at(slots[3])].x -= dot(u, against);
    blocks_.add(slots[3], std::max(0.0, dot(hold_pull(tensions_, k), arm)), 0.0, 0.0);
    const double least = dual_share / std::max(inertia_[held.point], inertia_[held.next]);
    blocks_.make_dual(dual);
    blocks_.add(dual, -least - (1.0 - across.xx), across.xy, -least - (1.0 - across.yy));
    right_side_[at(dual)] = -closing(hold_gap(held, positions_));
  }
}

void Island::update_holds() {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    HeldBody& held = held_[k];
    const Vec2 t = hold_tangent(held);
    Vec2 pull = right_side_[at(hold_dual(k))];
    if (held.slides == 0.0 && std::abs(dot(pull, t)) > held.strength) {
      held.slides = std::copysign(1.0, dot(pull, t));
      slips_ = true;
    }
    if (held.slides != 0.0) pull += (held.slides * held.strength - dot(pull, t)) * t;
    const std::size_t first = next_.size() - 2 * (held_.size() - k);
    next_[first] = pull.x;
    next_[first + 1] = pull.y;
  }
}

/// Along the cord where it is held.
Vec2 Island::hold_tangent(const HeldBody& held) const {
  std::size_t a = held.point;
  std::size_t b = held.next;
  for (const Member& member : members_) {
    const auto rows = at(member.cord->def_.rows);
    if (a != b || a < member.first || a >= member.first + member.count) continue;
    b + rows < member.first + member.count ? b += rows : a -= rows;
  }
  const Vec2 ab = positions_[b] - positions_[a];
  const double size = length(ab);
  return size > 0.0 ? (1.0 / size) * ab : Vec2{1.0, 0.0};
}

/// What a grip that slips has left open along the cord is how far it has slipped.
void Island::slip() {
  for (HeldBody& held : held_) {
    if (held.slides == 0.0) continue;
    const double along = -dot(hold_gap(held, positions_), hold_tangent(held));
    for (const Member& member : members_) {
      if (held.point >= member.first && held.point < member.first + member.count) {
        held.slid = along / member.cord->rest_[0];
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
    if (held_[k].slides == 0.0) {
      sum += most * length(gap);
    } else {
      const Vec2 t = hold_tangent(held_[k]);
      sum += most * std::abs(cross(t, gap)) + held_[k].slides * held_[k].strength * dot(t, gap);
    }
  }
  return sum;
}

}  // namespace ribbon
