#include "ribbon/system/block_system.h"

#include <algorithm>

#include "ribbon/linear/index.h"
#include "ribbon/linear/reserve_more.h"
#include "ribbon/system/grips.h"
#include "ribbon/system/supports.h"
#include "ribbon/system/wheels.h"

namespace ribbon {
namespace {

constexpr std::size_t many_cords = 8;   // from which on the natural order of what touches certainly fills much
constexpr double min_divisor = 1e-6;    // of a response to the friction of a wheel
constexpr std::size_t much_filled = 6;  // blocks a row, above which an order that fills less is looked for

void couple(const Contacts& contacts, BlockLdlt& matrix) { contacts.active.couple(contacts.scene, matrix); }
void couple(const LimitedRows& rows, BlockLdlt& matrix) { rows.couple(matrix); }

/// Calls visit(centre slot of a body, slot of a point) for what contacts couple.
template <typename Visit>
void for_each_body_and_point(const IslandState& /*state*/, const Contacts& contacts, Visit&& visit) {
  contacts.active.for_each_body_and_point(contacts.scene, visit);
}

template <typename Visit>
void for_each_body_and_point(const IslandState& state, const LimitedRows& rows, Visit&& visit) {
  rows.for_each_pair([&](int a, int b) {
    if (at(a) >= state.points && !state.is_scalar(at(a)) && at(b) < state.points) visit(a, b);
  });
}

}  // namespace

void BlockSystem::begin_step() {
  has_pattern_ = false;
  has_fill_order_ = false;
}

void BlockSystem::make_pattern(const IslandState& state, const Contacts& contacts) {
  if (!has_pattern_ || !contacts.active.are_coupled(contacts.scene, matrix_)) make_pattern_with(state, contacts);
}

void BlockSystem::make_pattern(const IslandState& state, const LimitedRows& rows) {
  if (!has_pattern_ || !rows.are_coupled(matrix_)) make_pattern_with(state, rows);
}

/// The order is the one that was found in this step, or the natural one unless that fills much.
template <typename Terms>
void BlockSystem::make_pattern_with(const IslandState& state, const Terms& terms) {
  if (!has_fill_order_) find_natural_order(state, terms);
  leave_out_tied(state);
  matrix_.begin_pattern(order_, state.ties.slots);
  for (const Member& member : state.members) {
    member.cord->elasticity->couple(matrix_, static_cast<int>(member.first_point), state.first_dual(member));
  }
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    matrix_.couple(static_cast<int>(state.center(k)), static_cast<int>(state.angle(k)));
  }
  for (std::size_t grip = 0; grip < state.held.size(); ++grip) {
    for (const int slot : grip_slots(state, state.held[grip])) matrix_.couple(slot, state.grip_dual(grip));
  }
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const std::array<int, 5> slots = wheel_slots(state, state.wheels[k]);
    for (const int slot : slots) {
      matrix_.couple(slot, state.wheel_dual(k));
      if (slot != slots[3]) matrix_.couple(slot, slots[3]);
      if (slot != slots[4] && slot != slots[3]) matrix_.couple(slot, slots[4]);
    }
  }
  couple_supports(state, matrix_);
  couple(terms, matrix_);
  const bool is_heap = !has_fill_order_ && state.members.size() >= many_cords;
  if (!is_heap) matrix_.end_pattern();
  const std::size_t much = has_fill_order_ ? filled_ + filled_ / 2 : much_filled * matrix_.size();
  if (is_heap || matrix_.off_diagonal_blocks() > much) reduce_fill(state);
  has_pattern_ = true;
}

template <typename Terms>
void BlockSystem::find_natural_order(const IslandState& state, const Terms& terms) {
  reserve_more(last_points_, state.bodies.size());
  last_points_.assign(state.bodies.size(), -1);
  const auto couple = [&](int center_slot, int point) {
    int& last = last_points_[(at(center_slot) - state.points) / 2];
    last = std::max(last, point);
  };
  for (const HeldBody& held : state.held)
    couple(static_cast<int>(state.center(held.solved_index)), static_cast<int>(held.next));
  for (const Wheel& wheel : state.wheels) {
    couple(static_cast<int>(state.center(wheel.solved_index)), static_cast<int>(wheel.after));
  }
  for_each_body_and_point(state, terms, couple);
  order_with_bodies(state);
}

/// Points in their order, each body after the last point that it is coupled with, and then its grips: what is coupled
/// nearby fills little.
void BlockSystem::order_with_bodies(const IslandState& state) {
  order_.clear();
  const auto append_bodies = [&](int after) {
    for (std::size_t k = 0; k < state.bodies.size(); ++k) {
      if (last_points_[k] != after) continue;
      order_.push_back(static_cast<int>(state.center(k)));
      order_.push_back(static_cast<int>(state.angle(k)));
      for (std::size_t grip = 0; grip < state.held.size(); ++grip) {
        if (state.held[grip].solved_index == k) order_.push_back(state.grip_dual(grip));
      }
      for (std::size_t wheel = 0; wheel < state.wheels.size(); ++wheel) {
        if (state.wheels[wheel].solved_index != k) continue;
        order_.push_back(static_cast<int>(state.groove(wheel)));
        order_.push_back(state.wheel_dual(wheel));
      }
    }
  };
  append_bodies(-1);
  for (const Member& member : state.members) {
    member.cord->elasticity->order(static_cast<int>(member.first_point), state.first_dual(member), order_,
                                   append_bodies);
  }
}

/// Tied slots follow the first one of their group, which has the lowest index: so no tension is eliminated before it.
void BlockSystem::leave_out_tied(const IslandState& state) {
  if (state.ties.slots.empty()) return;
  std::erase_if(order_, [&](int slot) { return state.ties.is_tied(slot); });
}

/// Points and bodies in an order that fills little. Tensions and pulls have no stiffness of their own before all that
/// they are coupled with is eliminated, so they come after it.
void BlockSystem::reduce_fill(const IslandState& state) {
  const std::size_t slots = state.slots();
  fill_order_.begin(slots);
  const auto is_dual = [slots](int slot) { return at(slot) >= slots; };
  matrix_.for_each_coupling([&](int a, int b) {
    if (!is_dual(a) && !is_dual(b)) fill_order_.couple(a, b);
  });
  append_duals_last(slots, state.all_duals(), fill_order_.find());
  leave_out_tied(state);
  matrix_.reorder(order_);
  filled_ = matrix_.off_diagonal_blocks();
  has_fill_order_ = true;
}

void BlockSystem::append_duals_last(std::size_t slots, std::size_t duals, std::span<const int> order) {
  rows_of_.resize(order.size());
  for (std::size_t row = 0; row < order.size(); ++row) rows_of_[at(order[row])] = static_cast<int>(row);
  late_.resize(duals);
  for (std::size_t k = 0; k < late_.size(); ++k) late_[k] = {0, static_cast<int>(slots + k)};
  matrix_.for_each_coupling([&](int a, int b) {
    if (at(a) >= slots) std::swap(a, b);
    if (at(b) < slots) return;
    auto& late = late_[at(b) - slots];
    late = {std::max(late[0], rows_of_[at(a)]), b};
  });
  std::sort(late_.begin(), late_.end());
  order_.clear();
  std::size_t next = 0;
  for (std::size_t row = 0; row < order.size(); ++row) {
    order_.push_back(order[row]);
    for (; next < late_.size() && at(late_[next][0]) == row; ++next) order_.push_back(late_[next][1]);
  }
}

void BlockSystem::load(const IslandState& state, const Stage& stage) {
  matrix_.set_zero();
  right_side_.resize(state.slots() + state.all_duals());
  for (const Member& member : state.members) {
    member.cord->elasticity->load(IslandState::stage_of(stage, member), IslandState::points_of(member, state.positions),
                                  IslandState::tensions_of(member, state.tensions), matrix_,
                                  static_cast<int>(member.first_point), state.first_dual(member), right_side_);
  }
  for (std::size_t p = state.points; p < state.slots(); ++p) {
    right_side_[p] = stage.residual(p, state.positions[p]);
    matrix_.add(static_cast<int>(p), stage.inertia[p], 0.0, stage.inertia[p]);
  }
  for (std::size_t k = 0; k < state.bodies.size(); ++k) right_side_[state.angle(k)].y = 0.0;
  load_grips(state, stage.inertia, matrix_, right_side_);
  load_wheel_rows(state, stage, matrix_, right_side_);
  load_supports(state, matrix_, right_side_);
}

void BlockSystem::clear_constrained(const IslandState& state) {
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] != 0) right_side_[p] = {};
  }
}

bool BlockSystem::solve(const IslandState& state) {
  clear_constrained(state);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] != 0) matrix_.hold(static_cast<int>(p));
  }
  if (!matrix_.solve(right_side_)) return false;
  find_friction_of_wheels(state);
  add_friction_of_wheels(right_side_);
  return true;
}

void BlockSystem::solve_again(const IslandState& state) {
  clear_constrained(state);
  matrix_.solve_again(right_side_);
  add_friction_of_wheels(right_side_);
}

/// The friction of a cord that slips in a groove is F = s·(e^(μ·α) − 1)·λ, along it, with its sign s and the smaller of
/// the tensions, λ. Without it the system is A·z = b. With w = A⁻¹·e, the response to a unit force along the groove,
///
///     z ← z + F·w,     F = s·(e^(μ·α) − 1)·λ(z)/(1 − s·(e^(μ·α) − 1)·λ(w)).
///
/// The response to the friction of a second wheel includes that of the first.
void BlockSystem::find_friction_of_wheels(const IslandState& state) {
  responses_.clear();
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Wheel& wheel = state.wheels[k];
    if (wheel.slip_sign == 0.0 || state.constrained[state.groove(k)] != 0) continue;
    const std::size_t n = right_side_.size();
    unit_.assign(n, Vec2{});
    unit_[state.groove(k)] = {1.0, 0.0};
    matrix_.solve_again(unit_);
    add_friction_of_wheels(unit_);
    WheelResponse response;
    response.dual = at(state.wheel_dual(k));
    response.before = wheel.slip_sign < 0.0;
    response.factor = wheel.slip_sign * (wheel.ratio - 1.0);
    response.first = responses_.size() * n;
    response.divisor = 1.0 - response.factor * response.tension(unit_);
    if (response.divisor < min_divisor) continue;  // no slip at any speed could end what would jam
    motions_.resize(response.first + n);
    std::copy(unit_.begin(), unit_.end(), motions_.begin() + static_cast<std::ptrdiff_t>(response.first));
    responses_.push_back(response);
  }
}

void BlockSystem::add_friction_of_wheels(std::span<Vec2> solution) const {
  for (const WheelResponse& response : responses_) {
    const double friction = response.factor * response.tension(solution) / response.divisor;
    // A slack cord does not rub.
    if (!(friction * response.factor > 0.0)) continue;
    for (std::size_t p = 0; p < solution.size(); ++p) solution[p] += friction * motions_[response.first + p];
  }
}

void BlockSystem::copy_direction(std::span<Vec2> direction) const {
  std::copy(right_side_.begin(), right_side_.begin() + static_cast<std::ptrdiff_t>(direction.size()),
            direction.begin());
}

bool BlockSystem::update(IslandState& state, const Stage& stage, std::vector<Vec2>& direction,
                         std::vector<double>& next) {
  for (const Member& member : state.members) {
    const auto duals =
        std::span<const Vec2>(right_side_).subspan(at(state.first_dual(member)), member.cord->elasticity->dual_count());
    member.cord->elasticity->update(
        IslandState::stage_of(stage, member), IslandState::points_of(member, state.positions),
        IslandState::tensions_of(member, state.tensions), IslandState::points_of(member, direction), duals,
        IslandState::tensions_of(member, next));
  }
  update_wheels(state, right_side_, next);
  return update_grips(state, right_side_, next);
}

}  // namespace ribbon
