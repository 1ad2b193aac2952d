#include "ribbon/box2d/slip_place.h"

#include <algorithm>

#include "ribbon/box2d/grip_table.h"

namespace ribbon::box2d {
namespace {

constexpr double beside_share = 1e-3;   // of a link, from the cord, above which a hand is beside it
constexpr double sharp_bend = 0.9;      // cosine of the angle between two links, below which a hand can be caught
constexpr double sliding = 1.0 - 1e-6;  // of its strength, at which a grip slides

/// One row of a cord as a polyline.
class Polyline {
 public:
  Polyline(const CoupledCord& cord, int row)
      : x_(cord.positions()), rows_(cord.shape().rows), row_(row), columns_(cord.shape().columns) {}

  int rows() const { return rows_; }
  int links() const { return columns_ - 1; }
  Vec2 at(int column) const {
    const int point = column * rows_ + row_;
    return x_[static_cast<std::size_t>(point)];
  }
  /// Returns the place on a link, 0 … 1, that is nearest to a position.
  double nearest(int link, Vec2 position) const {
    const Vec2 edge = at(link + 1) - at(link);
    const double size2 = dot(edge, edge);
    return size2 > 0.0 ? std::clamp(dot(position - at(link), edge) / size2, 0.0, 1.0) : 0.0;
  }
  Vec2 place(int link, double along) const { return at(link) + along * (at(link + 1) - at(link)); }
  double length_of(int link) const { return length(at(link + 1) - at(link)); }
  Vec2 tangent(int link) const {
    const Vec2 edge = at(link + 1) - at(link);
    const double size = length(edge);
    return size > 0.0 ? (1.0 / size) * edge : Vec2{};
  }

 private:
  std::span<const Vec2> x_;
  int rows_;
  int row_;
  int columns_;
};

/// Returns the column that is nearest to `hand`, downhill from a link.
double nearest_column(const Polyline& line, int link, Vec2 hand) {
  double along = line.nearest(link, hand);
  double distance = length(hand - line.place(link, along));
  for (;;) {
    const int next = link + (along >= 1.0 ? 1 : along <= 0.0 ? -1 : 0);
    if (next == link || next < 0 || next >= line.links()) return link + along;
    const double next_along = line.nearest(next, hand);
    const double next_distance = length(hand - line.place(next, next_along));
    if (!(next_distance < distance)) return link + along;
    link = next;
    along = next_along;
    distance = next_distance;
  }
}

/// Returns how a hand is held that has not left a point, by the force with which its body pulled there in the last
/// tick. It slides along a link along which it was pulled with its strength.
SlipPlace place_at_point(const GripMemory& grip, const Polyline& line, int column, bool stops) {
  const Vec2 back = column > 0 ? -line.tangent(column - 1) : Vec2{};
  const Vec2 on = column < line.links() ? line.tangent(column) : Vec2{};
  const bool slides_back = column > 0 && -dot(grip.pull, back) >= sliding * grip.strength;
  const bool slides_on = column < line.links() && -dot(grip.pull, on) >= sliding * grip.strength;
  SlipPlace place{grip.point, grip.along};
  if (slides_back && !slides_on) {
    place.point -= line.rows();
    place.along = 1.0;
  }
  const bool is_caught = column > 0 && column < line.links() && -dot(back, on) < sharp_bend;
  place.sticks = !slides_on && !slides_back && (stops || is_caught);
  return place;
}

}  // namespace

void move_to_nearest(GripMemory& grip, const CoupledCord& cord, Vec2 hand) {
  const CordShape shape = cord.shape();
  const Polyline line(cord, grip.point % shape.rows);
  const int link = std::min(grip.point / shape.rows, line.links() - 1);
  if (length(hand - cord.position(grip.point, grip.along)) <= beside_share * line.length_of(link)) return;
  set_column(grip, nearest_column(line, link, hand), shape.columns, shape.rows);
}

SlipPlace slip_place(const GripMemory& grip, const CoupledCord& cord, Vec2 hand, bool stops) {
  SlipPlace place{grip.point, grip.along};
  if (grip.along > 0.0) return place;
  const int rows = cord.shape().rows;
  const Polyline line(cord, grip.point % rows);
  const int column = grip.point / rows;
  const Vec2 off = hand - line.at(column);
  const double link = line.length_of(std::min(column, line.links() - 1));
  if (length(off) <= beside_share * link) return place_at_point(grip, line, column, stops);
  place.sticks = stops;
  if (column > 0 && column < line.links()) place.across = (1.0 / length(off)) * off;
  return place;
}

}  // namespace ribbon::box2d
