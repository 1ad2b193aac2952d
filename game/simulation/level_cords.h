#pragma once

#include "ribbon/box2d/coupling.h"

namespace game {

/// Returns whether blades and knives can cut a cord: one of the level or a line of a player, for the direct solver.
inline bool is_cuttable(const ribbon::box2d::CordView& cord) {
  return cord.is_enabled() && cord.solver() == ribbon::box2d::Solver::direct;
}

/// Returns whether a cord can burn: it, or the cord that it is a piece of, was built from the map. The lines of players
/// were not.
inline bool is_burnable(const ribbon::box2d::CordView& cord) { return cord.user_data() != 0 && is_cuttable(cord); }

/// Returns the index of the point in the middle row of a column.
inline std::size_t middle_point(const ribbon::box2d::CordShape& shape, int column) {
  const int point = column * shape.rows + shape.rows / 2;
  return static_cast<std::size_t>(point);
}

/// Cuts a cord across at a column, 1 … columns − 2, so that both pieces have a link or more.
inline ribbon::box2d::CutEvent cut_at_column(ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId id, int column) {
  const ribbon::box2d::CordRef cord = coupling.cord(id);
  return cord.cut(cord.arc(column * cord.shape().rows));
}

}  // namespace game
