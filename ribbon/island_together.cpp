#include <algorithm>
#include <cmath>

#include "ribbon/island.h"
#include "ribbon/lattice.h"
#include "ribbon/link.h"

// The linear solve of several cords, and of bodies that hold or touch them anywhere, as one system of blocks.

namespace ribbon {

/// Points in their order, and each body after the last point that it is coupled with: so what is coupled nearby fills
/// little.
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
    }
  };
  append_bodies(-1);
  std::size_t open = static_cast<std::size_t>(
      std::count_if(last_point_.begin(), last_point_.end(), [](int last) { return last >= 0; }));
  for (int p = 0; p < static_cast<int>(count_); ++p) {
    order_.push_back(p);
    if (open > 0) append_bodies(p);
  }
  blocks_.begin_pattern(order_);
  for (const Member& member : members_) {
    const auto reach = static_cast<std::size_t>(member.cord->lattice().reach());
    for (std::size_t i = 0; i < member.count; ++i) {
      for (std::size_t k = 1; k <= reach && i + k < member.count; ++k) {
        blocks_.couple(static_cast<int>(member.first + i), static_cast<int>(member.first + i + k));
      }
    }
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    blocks_.couple(static_cast<int>(center(k)), static_cast<int>(angle(k)));
  }
  for (const HeldBody& held : held_) {
    const std::array<int, 4> slots = hold_slots(held);
    for (const int a : slots) {
      for (const int b : slots) {
        if (a < b) blocks_.couple(a, b);
      }
    }
  }
  contacts_.couple(blocks_);
  blocks_.end_pattern();
}

std::array<int, 4> Island::hold_slots(const HeldBody& held) const {
  return {static_cast<int>(held.point), static_cast<int>(held.next), static_cast<int>(center(held.body)),
          static_cast<int>(angle(held.body))};
}

bool Island::newton_step_together(Stage& stage) {
  if (!has_pattern_ || !contacts_.are_coupled(blocks_)) make_pattern();
  has_pattern_ = true;
  blocks_.set_zero();
  for (const Member& member : members_) {
    Lattice& lattice = member.cord->lattice();
    Stage own = stage_of(stage, member);
    own.carried = {};
    lattice.assemble(own, part(positions_, member.first, member.count),
                     part(tensions_, member.first_tension, member.tensions),
                     part(direction_, member.first, member.count));
    lattice.add_to(blocks_, static_cast<int>(member.first));
  }
  for (std::size_t p = count_; p < positions_.size(); ++p) {
    direction_[p] = stage.residual(p, positions_[p]);
    blocks_.add(static_cast<int>(p), inertia_[p], 0.0, inertia_[p]);
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) direction_[angle(k)].y = 0.0;
  load_holds();
  contacts_.load(positions_, blocks_, direction_);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] == 0) continue;
    direction_[p] = {};
    blocks_.hold(static_cast<int>(p));
  }
  if (!blocks_.solve(direction_)) return false;
  for (const Member& member : members_) {
    Stage own = stage_of(stage, member);
    own.carried = {};
    member.cord->lattice().update(
        own, part(positions_, member.first, member.count), part(tensions_, member.first_tension, member.tensions),
        part(direction_, member.first, member.count), part(next_, member.first_tension, member.tensions));
  }
  update_holds();
  contacts_.update(direction_);
  return true;
}

/// Where the cord is held less where the hand is.
Vec2 Island::hold_gap(const HeldBody& held, std::span<const Vec2> x) const {
  return held.hold(x) - x[center(held.body)] - held.arm_at(x[angle(held.body)].x);
}

/// A hold is a bar of no length in each direction that does not give, its pull λ approached as Links does: with α₀ the
/// least compliance, λ⁺ = λ + (c + J·δ)/α₀, c = x − X − s, ∂c/∂φ = −perp(s), ∂²c/∂φ² = s.
void Island::load_holds() {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const HeldBody& held = held_[k];
    const double stiffness = hold_stiffness(held);
    const Vec2 arm = held.arm_at(positions_[angle(held.body)].x);
    const Vec2 pull = hold_pull(tensions_, k) + stiffness * hold_gap(held, positions_);
    const std::array<int, 4> slots = hold_slots(held);
    const std::array<double, 3> weights = {1.0 - held.along, held.along, -1.0};
    const Vec2 u = -perp(arm);
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 0.0) continue;
      direction_[at(slots[i])] -= weights[i] * pull;
      const double own = stiffness * weights[i] * weights[i];
      blocks_.add(slots[i], own, 0.0, own);
      for (std::size_t j = i + 1; j < 3; ++j) {
        const double shared = stiffness * weights[i] * weights[j];
        if (shared != 0.0) blocks_.add(slots[i], slots[j], shared, 0.0, 0.0, shared);
      }
      const Vec2 turning = (stiffness * weights[i]) * u;
      blocks_.add(slots[i], slots[3], turning.x, 0.0, turning.y, 0.0);
    }
    direction_[at(slots[3])].x -= dot(u, pull);
    blocks_.add(slots[3], stiffness * dot(u, u) + std::max(0.0, dot(hold_pull(tensions_, k), arm)), 0.0, 0.0);
  }
}

void Island::update_holds() {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const HeldBody& held = held_[k];
    const Vec2 u = -perp(held.arm_at(positions_[angle(held.body)].x));
    const Vec2 gap = hold_gap(held, positions_) + held.hold(direction_) - direction_[center(held.body)] +
                     direction_[angle(held.body)].x * u;
    const Vec2 pull = hold_pull(tensions_, k) + hold_stiffness(held) * gap;
    const std::size_t first = next_.size() - 2 * (held_.size() - k);
    next_[first] = pull.x;
    next_[first + 1] = pull.y;
  }
}

Vec2 Island::hold_pull(std::span<const double> tensions, std::size_t hold) const {
  const std::size_t first = tensions.size() - 2 * (held_.size() - hold);
  return {tensions[first], tensions[first + 1]};
}

double Island::hold_stiffness(const HeldBody& held) const {
  return std::max(inertia_[held.point], inertia_[center(held.body)]) / proximal_share;
}

double Island::hold_potential(std::span<const Vec2> x) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    sum += length(hold_pull(most_tensions_, k)) * length(hold_gap(held_[k], x));
  }
  return sum;
}

}  // namespace ribbon
