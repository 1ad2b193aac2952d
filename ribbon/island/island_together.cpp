#include <algorithm>
#include <cmath>

#include "ribbon/elastic/link.h"
#include "ribbon/island/island.h"

// The linear solve of several cords, and of bodies that hold or touch them anywhere, as one system of blocks.

namespace ribbon {
namespace {

constexpr std::size_t much_filled = 6;  // blocks a row, above which an order that fills less is looked for

}  // namespace

/// In the order that a step has found to fill little, or in the natural one unless that fills much.
void Island::make_pattern() {
  if (!has_fill_order_) find_natural_order();
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
  if (posing_) {
    limited_.couple(blocks_);
  } else {
    contacts_.couple(blocks_);
  }
  blocks_.end_pattern();
  const std::size_t much = has_fill_order_ ? filled_ + filled_ / 2 : much_filled * blocks_.size();
  if (blocks_.off_diagonal_blocks() > much) lessen_fill();
}

/// Points in their order, each body after the last point that it is coupled with, and then its holds: so what is
/// coupled nearby fills little.
void Island::find_natural_order() {
  last_point_.assign(bodies_.size(), -1);
  const auto take = [this](int center_slot, int point) {
    int& last = last_point_[(at(center_slot) - count_) / 2];
    last = std::max(last, point);
  };
  for (const HeldBody& held : held_) take(static_cast<int>(center(held.body)), static_cast<int>(held.next));
  if (posing_) {
    limited_.for_each_pair([&](int a, int b) {
      if (at(a) >= count_ && !is_angle(at(a)) && at(b) < count_) take(a, b);
    });
  } else {
    contacts_.for_each_touched(take);
  }
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
}

/// Points and bodies in an order that fills little; tensions and pulls, which have no stiffness of their own before
/// that, after all that they are coupled with.
void Island::lessen_fill() {
  const std::size_t slots = positions_.size();
  fill_order_.begin(slots);
  const auto is_late = [slots](int slot) { return at(slot) >= slots; };
  blocks_.for_each_coupling([&](int a, int b) {
    if (!is_late(a) && !is_late(b)) fill_order_.couple(a, b);
  });
  const std::span<const int> order = fill_order_.find();
  places_.resize(order.size());
  for (std::size_t row = 0; row < order.size(); ++row) places_[at(order[row])] = static_cast<int>(row);
  late_.resize(blocks_.size() - slots);
  for (std::size_t k = 0; k < late_.size(); ++k) late_[k] = {0, static_cast<int>(slots + k)};
  blocks_.for_each_coupling([&](int a, int b) {
    if (is_late(a)) std::swap(a, b);
    if (!is_late(b)) return;
    auto& late = late_[at(b) - slots];
    late = {std::max(late[0], places_[at(a)]), b};
  });
  std::sort(late_.begin(), late_.end());
  order_.clear();
  std::size_t next = 0;
  for (std::size_t row = 0; row < order.size(); ++row) {
    order_.push_back(order[row]);
    for (; next < late_.size() && at(late_[next][0]) == row; ++next) order_.push_back(late_[next][1]);
  }
  blocks_.reorder(order_);
  filled_ = blocks_.off_diagonal_blocks();
  has_fill_order_ = true;
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
  load_together(stage);
  contacts_.load(positions_, blocks_, right_side_);
  if (!solve_together()) return false;
  take_direction();
  update_together(stage);
  contacts_.update(direction_);
  return true;
}

/// All but what contacts add.
void Island::load_together(Stage& stage) {
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
}

/// Leaves the solution in right_side_.
bool Island::solve_together() {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] == 0) continue;
    right_side_[p] = {};
    blocks_.hold(static_cast<int>(p));
  }
  return blocks_.solve(right_side_);
}

void Island::take_direction() {
  std::copy(right_side_.begin(), right_side_.begin() + static_cast<std::ptrdiff_t>(positions_.size()),
            direction_.begin());
}

/// The tensions and pulls of the solution.
void Island::update_together(const Stage& stage) {
  for (const Member& member : members_) {
    member.cord->elasticity_->update(stage_of(stage, member), part(positions_, member.first, member.count),
                                     part(tensions_, member.first_tension, member.tensions),
                                     part(direction_, member.first, member.count),
                                     part(right_side_, at(first_dual(member)), member.cord->elasticity_->dual_count()),
                                     part(next_, member.first_tension, member.tensions));
  }
  update_holds();
}

}  // namespace ribbon
