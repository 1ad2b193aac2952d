#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/collision/motion_bounds.h"
#include "ribbon/linear/index.h"
#include "ribbon/stage/newton_solver.h"

namespace ribbon {

/// Shares of a motion, by group: all slots of a group make the same share of their displacements. A cord and what holds
/// it are a group. Slots that are constrained belong to none.
class MotionGroups {
 public:
  void resize(std::size_t slots);
  /// Finds the groups. Each makes all of its motion.
  void begin(const IslandState& state);
  /// Returns the share of a slot's group, 0 … 1; 1 without a group.
  double share(std::size_t slot) const { return groups_[slot] < 0 ? 1.0 : shares_[at(groups_[slot])]; }
  /// Multiplies the share of a slot's group.
  void reduce(std::size_t slot, double factor) {
    if (groups_[slot] >= 0) shares_[at(groups_[slot])] *= factor;
  }
  /// Reduces the shares until no pair passes through each other on the way between these positions, m. Returns false if
  /// it reduced any.
  bool separate(Contacts& contacts, std::span<const Vec2> from, std::span<const Vec2> to);
  /// Shortens the displacements of groups that would take them through each other, or out of their motion bounds.
  /// Returns false if one was shortened.
  bool keep_apart(const StageContext& context, const MotionBounds& bounds, std::span<const Vec2> from);

 private:
  void find_groups(const IslandState& state);

  std::vector<int> groups_;  // by slot; −1: none
  std::vector<double> shares_;
};

}  // namespace ribbon
