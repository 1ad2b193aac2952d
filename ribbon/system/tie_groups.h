#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/island_cord.h"
#include "ribbon/linear/disjoint_sets.h"
#include "ribbon/tie.h"

namespace ribbon {

struct CordParts;

/// A point that is tied to others.
struct TiedPoint {
  int group = 0;  ///< number of its group: points that move as one
  int cord = 0;   ///< index of its cord
  int point = 0;  ///< index of the point
};

/// The groups of points that ties make one.
class TieGroups {
 public:
  /// Finds the groups. Throws DefinitionError as check_ties does. O(points) if there is a tie.
  void find(std::span<const Tie> ties, std::span<const int> points);
  /// Returns the tied points, group by group, ascending by cord within a group.
  std::span<TiedPoint> points() { return points_; }

 private:
  void number_points(std::span<const int> points);
  void check_groups() const;

  std::vector<std::size_t> first_points_;  // by cord: number of its first point among those of all cords
  DisjointSets joined_;                    // of these numbers
  std::vector<TiedPoint> points_;
};

/// Gives tied points one velocity before a step, which keeps the momentum, and one position unless they are apart.
/// `cords` are those of an island, and `points` refer to them.
void bring_together(std::span<const IslandCord> cords, std::span<const TiedPoint> points);
/// Returns whether a gap [m] between tied points is more than a step closes at once.
bool are_apart(Vec2 gap);
/// Returns by how much [m] the gap between a cord's point and what it is tied to, which are apart, is closed in a step
/// of dt seconds: points that were tied while apart are drawn together over several steps.
Vec2 closing_in_step(const CordParts& cord, Vec2 gap, double dt);

}  // namespace ribbon
