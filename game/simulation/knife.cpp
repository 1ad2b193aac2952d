#include "game/simulation/knife.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/simulation/level_cords.h"
#include "game/simulation/nearest_pin.h"

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

std::optional<CordPoint> nearest_other(const Player& player, const Coupling& coupling, const CordPoint* held) {
  std::vector<CordId> except;
  if (held != nullptr) except.push_back(held->cord);
  for (const Line& line : player.lines().all()) {
    if (line.is_held()) except.push_back(*line.cord());
  }
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
  const int below = hangs_from_first(coupling.cord(held->cord), held->point) ? static_cast<int>(std::floor(column)) + 1
                                                                             : static_cast<int>(std::ceil(column)) - 1;
  if (below < 1 || below > shape.columns - 2) return false;
  cut_at_column(coupling, held->cord, below);
  return true;
}

}  // namespace game
