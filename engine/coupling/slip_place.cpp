#include "ribbon/box2d/slip_place.h"

#include <algorithm>

#include "ribbon/box2d/grip_table.h"
#include "ribbon/cord_line.h"

namespace ribbon::box2d {
namespace {

constexpr double beside_share = 1e-3;   // of a link, from the cord, above which a hand is beside it
constexpr double sharp_bend = 0.9;      // cosine of the angle between two links, below which a hand can be caught
constexpr double sliding = 1.0 - 1e-6;  // of its strength, at which a grip slides

CordLine line_of(const GripMemory& grip, const CoupledCord& cord) {
  const int rows = cord.shape().rows;
  return {cord.positions(), rows, grip.point % rows};
}

/// Returns how a hand is held that has not left a point, by the force with which its body pulled there in the last
/// tick. It slides along a link along which it was pulled with its strength.
SlipPlace place_at_point(const GripMemory& grip, const CordLine& line, int column, bool stops) {
  const Vec2 back = column > 0 ? -line.tangent(column - 1) : Vec2{};
  const Vec2 on = column < line.links() ? line.tangent(column) : Vec2{};
  const bool slides_back = column > 0 && -dot(grip.pull, back) >= sliding * grip.strength;
  const bool slides_on = column < line.links() && -dot(grip.pull, on) >= sliding * grip.strength;
  SlipPlace place{grip.point, grip.along};
  if (slides_back && !slides_on) {
    place.point -= line.rows();
    place.along = 1.0;
  }
  const bool is_bend = column > 0 && column < line.links() && -dot(back, on) < sharp_bend;
  const bool stays = !slides_on && !slides_back;
  place.stops = stays && stops;
  place.is_caught = stays && is_bend;
  return place;
}

}  // namespace

void move_to_nearest(GripMemory& grip, const CoupledCord& cord, Vec2 hand) {
  const CordShape shape = cord.shape();
  const CordLine line = line_of(grip, cord);
  const int link = std::min(grip.point / shape.rows, line.links() - 1);
  if (length(hand - cord.position(grip.point, grip.along)) <= beside_share * line.length_of(link)) return;
  set_column(grip, line.nearest_column(link, hand), shape.columns, shape.rows);
}

SlipPlace slip_place(const GripMemory& grip, const CoupledCord& cord, Vec2 hand, bool stops) {
  SlipPlace place{grip.point, grip.along};
  if (grip.along > 0.0) return place;
  const CordLine line = line_of(grip, cord);
  const int column = grip.point / line.rows();
  const Vec2 off = hand - line.at(column);
  const double link = line.length_of(std::min(column, line.links() - 1));
  if (length(off) <= beside_share * link) return place_at_point(grip, line, column, stops);
  place.stops = stops;
  if (column > 0 && column < line.links()) place.across = (1.0 / length(off)) * off;
  return place;
}

}  // namespace ribbon::box2d
