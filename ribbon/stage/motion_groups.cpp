#include "ribbon/stage/motion_groups.h"

#include <algorithm>

#include "ribbon/linear/index.h"

namespace ribbon {

void MotionGroups::resize(std::size_t slots) {
  groups_.resize(slots);
  shares_.resize(slots);
}

void MotionGroups::begin(const IslandState& state) {
  find_groups(state);
  shares_.assign(state.slots(), 1.0);
}

/// A cord is a group. What holds it, and cords that are tied to it, move with it.
void MotionGroups::find_groups(const IslandState& state) {
  groups_.assign(state.slots(), -1);
  const auto root = [&](std::size_t slot) {
    while (groups_[slot] >= 0 && at(groups_[slot]) != slot) slot = at(groups_[slot]);
    return slot;
  };
  for (const Member& member : state.members) {
    const auto points = IslandState::points_of(member, groups_);
    std::fill(points.begin(), points.end(), static_cast<int>(member.first_point));
  }
  for (std::size_t k = 0; k < state.bodies.size(); ++k) groups_[state.center(k)] = static_cast<int>(state.center(k));
  const auto join = [&](std::size_t slot, std::size_t other) {
    const std::size_t a = root(slot);
    const std::size_t b = root(other);
    groups_[std::max(a, b)] = static_cast<int>(std::min(a, b));
  };
  for (const HeldBody& held : state.held) join(held.point, state.center(held.solved_index));
  for (const Wheel& wheel : state.wheels) join(wheel.before, state.center(wheel.solved_index));
  for (const TiedSlot& tied : state.ties.slots) join(at(tied.slot), at(tied.with));
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (groups_[p] >= 0) groups_[p] = static_cast<int>(root(p));
  }
  for (std::size_t k = 0; k < state.bodies.size(); ++k) groups_[state.angle(k)] = groups_[state.center(k)];
  for (std::size_t k = 0; k < state.wheels.size(); ++k) groups_[state.groove(k)] = groups_[state.wheels[k].before];
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] != 0) groups_[p] = -1;
  }
}

bool MotionGroups::keep_apart(const StageContext& context, const MotionBounds& bounds, std::span<const Vec2> from) {
  IslandState& state = context.state;
  begin(state);
  const bool within = bounds.limit(state, from, groups_, shares_);
  if (separate(context.contacts, from, state.positions) && within) return true;
  for (Member& member : state.members) {
    const auto groups = IslandState::points_of(member, groups_);
    member.stopped =
        std::any_of(groups.begin(), groups.end(), [this](int group) { return group >= 0 && shares_[at(group)] < 1.0; });
  }
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] == 0) state.positions[p] = from[p] + share(p) * (state.positions[p] - from[p]);
  }
  return false;
}

bool MotionGroups::separate(Contacts& contacts, std::span<const Vec2> from, std::span<const Vec2> to) {
  return contacts.empty() || contacts.sweep.separate_groups(contacts.scene, from, to, groups_, shares_);
}

}  // namespace ribbon
