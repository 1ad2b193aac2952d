#include "game/simulation/knife.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "game/simulation/level_cords.h"

namespace game {
namespace {

using ribbon::box2d::CordId;
using ribbon::box2d::CordPoint;
using ribbon::box2d::Coupling;

/// Returns the place of a cord in columns.
double column_of(const CordPoint& place, int rows) {
  const int column = place.point / rows;
  return column + place.along;
}

/// Returns whether the part of the cord before a place carries it: there is the nearest constrained point, or, without
/// one, that end is the higher one.
bool hangs_from_first(const ribbon::box2d::CordView& cord, const CordPoint& held) {
  const auto x = cord.positions();
  const int size = static_cast<int>(x.size());
  for (int away = 0; away < size; ++away) {
    for (const int p : {held.point - away, held.point + away}) {
      if (p >= 0 && p < size && cord.kind(p) == ribbon::PointKind::constrained) return p <= held.point;
    }
  }
  return x.front().y >= x.back().y;
}

std::optional<CordPoint> nearest_other(const Player& player, const Coupling& coupling, const CordPoint* held) {
  std::vector<CordId> except;
  if (held != nullptr) except.push_back(held->cord);
  for (;;) {
    const auto nearest = coupling.nearest_place(player.hand(), knife_reach, except);
    if (!nearest) return std::nullopt;
    const ribbon::box2d::CordView cord = coupling.cord(nearest->cord);
    if (is_cuttable(cord) && cord.shape().columns > 2) return nearest;
    except.push_back(nearest->cord);
  }
}

}  // namespace

bool cut_by_hand(const Player& player, Coupling& coupling) {
  const auto held = player.held_place(coupling);
  if (const auto other = nearest_other(player, coupling, held ? &*held : nullptr)) {
    const ribbon::box2d::CordShape shape = coupling.cord(other->cord).shape();
    const int nearest = static_cast<int>(std::floor(column_of(*other, shape.rows) + 0.5));
    cut_at_column(coupling, other->cord, std::clamp(nearest, 1, shape.columns - 2));
    return true;
  }
  if (!held || !is_cuttable(coupling.cord(held->cord))) return false;
  const ribbon::box2d::CordShape shape = coupling.cord(held->cord).shape();
  const double column = column_of(*held, shape.rows);
  const int below = hangs_from_first(coupling.cord(held->cord), *held) ? static_cast<int>(std::floor(column)) + 1
                                                                       : static_cast<int>(std::ceil(column)) - 1;
  if (below < 1 || below > shape.columns - 2) return false;
  cut_at_column(coupling, held->cord, below);
  return true;
}

}  // namespace game
