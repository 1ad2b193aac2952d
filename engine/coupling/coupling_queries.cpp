// Queries of a Coupling: the nearest point or place.

#include <algorithm>
#include <utility>

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_parts.h"
#include "ribbon/box2d/slot.h"

namespace ribbon::box2d {
namespace {

/// Returns the place on the link from a point to the next column that is nearest to `position`, or nothing if that is
/// the end of the link, or if the point is on a wheel. Of a link that runs onto a wheel it is the point before that.
std::optional<CordPoint> nearest_on_link(const CoupledCord& cord, int point, Vec2 position) {
  const auto x = cord.positions();
  CordPoint place{cord.id, point};
  if (cord.wheel_at(point) != nullptr) return std::nullopt;
  const std::size_t next = slot(point + cord.shape().rows);
  const bool is_link = next < x.size() && cord.is_direct() && cord.wheel_at(point + 0.5) == nullptr;
  if (is_link) {
    const Vec2 link = x[next] - x[slot(point)];
    const double share = dot(position - x[slot(point)], link) / dot(link, link);
    if (share >= 1.0) return std::nullopt;
    place.along = std::max(0.0, share);
  }
  place.distance = length(cord.position(place.point, place.along) - position);
  return place;
}

}  // namespace

std::optional<CordPoint> Coupling::nearest_point(Vec2 position, double reach) const {
  std::optional<CordPoint> nearest;
  for (const CoupledCord& cord : std::as_const(parts_->cords)) {
    if (!cord.may_be_within(position, nearest ? nearest->distance : reach)) continue;
    const auto positions = cord.positions();
    for (std::size_t p = 0; p < positions.size(); ++p) {
      const double distance = length(positions[p] - position);
      if (cord.wheel_at(static_cast<double>(p)) != nullptr) continue;
      if (!(distance <= reach) || (nearest && distance >= nearest->distance)) continue;
      nearest = CordPoint{cord.id, static_cast<int>(p), distance};
    }
  }
  return nearest;
}

std::optional<CordPoint> Coupling::nearest_place(Vec2 position, double reach, std::span<const CordId> except) const {
  std::optional<CordPoint> nearest;
  for (const CoupledCord& cord : std::as_const(parts_->cords)) {
    if (std::find(except.begin(), except.end(), cord.id) != except.end()) continue;
    if (!cord.may_be_within(position, nearest ? nearest->distance : reach)) continue;
    const int points = static_cast<int>(cord.positions().size());
    for (int p = 0; p < points; ++p) {
      const std::optional<CordPoint> place = nearest_on_link(cord, p, position);
      if (!place || !(place->distance <= reach) || (nearest && place->distance >= nearest->distance)) continue;
      nearest = place;
    }
  }
  return nearest;
}

}  // namespace ribbon::box2d
