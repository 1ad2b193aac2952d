#include "ribbon/system/tie_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "ribbon/linear/index.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {
namespace {

constexpr double rounding = 1e-9;         // m or m/s, by which tied points may differ at the end of a step
constexpr double closed_distance = 1e-6;  // m, below which points are brought together at once
constexpr double closing_share = 0.2;     // of their distance, that they move in a step,
constexpr double closing_speed = 2.0;     // m/s, at most,
constexpr double max_draw = 0.25;         // of a link, at most

void check_end(const char* field, const char* of_point, int cord, int point, std::span<const int> points) {
  check_range(field, cord, 0, static_cast<double>(points.size()) - 1.0);
  check_range(of_point, point, 0, points[at(cord)] - 1.0);
}

CordParts& parts_of(std::span<const IslandCord> cords, const TiedPoint& tied) {
  return cords[at(tied.cord)].cord->parts();
}

bool is_free(const CordParts& cord, int point) { return cord.state.kinds[at(point)] == PointKind::free; }

/// Where a group is and how it moves: its centre of mass, or the first point that is driven.
struct GroupMotion {
  Vec2 position;
  Vec2 velocity;
};

GroupMotion motion_of(std::span<const IslandCord> cords, std::span<const TiedPoint> group) {
  GroupMotion sum;
  double mass = 0.0;
  for (const TiedPoint& tied : group) {
    const Cord::State& cord = parts_of(cords, tied).state;
    const std::size_t p = at(tied.point);
    if (cord.kinds[p] != PointKind::free) return {cord.positions[p], cord.velocities[p]};
    mass += cord.masses[p];
    sum.position += cord.masses[p] * cord.positions[p];
    sum.velocity += cord.masses[p] * cord.velocities[p];
  }
  return {(1.0 / mass) * sum.position, (1.0 / mass) * sum.velocity};
}

/// Returns by how much the motions of a group's points differ at most, m or m/s. Free ones have equal accelerations too
/// if they were tied in the last step.
double difference(std::span<const IslandCord> cords, std::span<const TiedPoint> group) {
  const CordParts& first = parts_of(cords, group[0]);
  const std::size_t p = at(group[0].point);
  double most = 0.0;
  for (const TiedPoint& tied : group.subspan(1)) {
    const Cord::State& other = parts_of(cords, tied).state;
    const std::size_t q = at(tied.point);
    most = std::max({most, length(other.positions[q] - first.state.positions[p]),
                     length(other.velocities[q] - first.state.velocities[p])});
    if (other.accelerations[q] != first.state.accelerations[p]) most = std::numeric_limits<double>::infinity();
  }
  return most;
}

/// Gives a free point of a group its velocity, and its position unless it is apart.
void join(const GroupMotion& together, CordParts& cord, int point) {
  cord.state.velocities[at(point)] = together.velocity;
  Vec2& position = cord.state.positions[at(point)];
  if (!are_apart(together.position - position)) position = together.position;
}

void bring_group_together(std::span<const IslandCord> cords, std::span<const TiedPoint> group) {
  const double different = difference(cords, group);
  if (different == 0.0) return;
  const GroupMotion together = motion_of(cords, group);
  for (const TiedPoint& tied : group) {
    CordParts& cord = parts_of(cords, tied);
    if (different > rounding) {
      cord.exclude_damping();
      cord.disturb();
    }
    if (is_free(cord, tied.point)) join(together, cord, tied.point);
  }
}

}  // namespace

void TieGroups::find(std::span<const Tie> ties, std::span<const int> points) {
  points_.clear();
  if (ties.empty()) return;
  number_points(points);
  const auto number = [this](int cord, int point) { return first_points_[at(cord)] + at(point); };
  for (const Tie& tie : ties) {
    check_end("tie.cord", "tie.point", tie.cord, tie.point, points);
    check_end("tie.other_cord", "tie.other_point", tie.other_cord, tie.other_point, points);
    joined_.join(number(tie.cord, tie.point), number(tie.other_cord, tie.other_point));
    points_.push_back({0, tie.cord, tie.point});
    points_.push_back({0, tie.other_cord, tie.other_point});
  }
  for (TiedPoint& tied : points_) tied.group = static_cast<int>(joined_.root(number(tied.cord, tied.point)));
  const auto key = [](const TiedPoint& tied) { return std::tuple(tied.group, tied.cord, tied.point); };
  std::sort(points_.begin(), points_.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
  points_.erase(std::unique(points_.begin(), points_.end(), same), points_.end());
  check_groups();
}

void TieGroups::check_groups() const {
  for (std::size_t k = 1; k < points_.size(); ++k) {
    const TiedPoint& a = points_[k - 1];
    const TiedPoint& b = points_[k];
    if (a.group != b.group || a.cord != b.cord) continue;
    throw DefinitionError("ties make points " + std::to_string(a.point) + " and " + std::to_string(b.point) +
                          " of cord " + std::to_string(a.cord) + " one; accepted are ties of different cords");
  }
}

void TieGroups::number_points(std::span<const int> points) {
  first_points_.clear();
  std::size_t count = 0;
  for (const int of_cord : points) {
    first_points_.push_back(count);
    count += at(of_cord);
  }
  joined_.begin(count);
}

bool are_apart(Vec2 gap) { return length(gap) > closed_distance; }

Vec2 closing_in_step(const CordParts& cord, Vec2 gap, double dt) {
  const double distance = length(gap);
  const double most = std::min(closing_speed * dt, max_draw * cord.def.length / (cord.def.points - 1));
  return std::min(closing_share, most / distance) * gap;
}

void bring_together(std::span<const IslandCord> cords, std::span<const TiedPoint> points) {
  for (std::size_t first = 0; first < points.size();) {
    std::size_t end = first + 1;
    while (end < points.size() && points[end].group == points[first].group) ++end;
    bring_group_together(cords, points.subspan(first, end - first));
    first = end;
  }
}

}  // namespace ribbon
