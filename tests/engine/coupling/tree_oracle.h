#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "ribbon/box2d/leaf_search.h"

/// What a search of the broad phase's tree has to find: the results of Box2D's own queries.
namespace tree_oracle {

/// Index of a box, and leaf.
using Pairs = std::set<std::pair<std::size_t, int>>;

/// Collects the leaves of a query of Box2D.
struct Collect {
  bool QueryCallback(int32 leaf) {  // NOLINT(readability-identifier-naming): Box2D names it
    leaves.insert(leaf);
    return true;
  }
  std::set<int> leaves;
};

inline b2AABB box(double x, double y, double width, double height) {
  b2AABB aabb;
  aabb.lowerBound.Set(static_cast<float>(x), static_cast<float>(y));
  aabb.upperBound.Set(static_cast<float>(x + width), static_cast<float>(y + height));
  return aabb;
}

inline b2AABB box(double x, double y, double size) { return box(x, y, size, size); }

inline Pairs found_by_box2d(const b2BroadPhase& broad_phase, const std::vector<b2AABB>& boxes) {
  Pairs pairs;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    Collect collect;
    broad_phase.Query(&collect, boxes[k]);
    for (const int leaf : collect.leaves) pairs.insert({k, leaf});
  }
  return pairs;
}

inline std::vector<ribbon::box2d::SearchBox> search_boxes(const std::vector<b2AABB>& boxes) {
  std::vector<ribbon::box2d::SearchBox> list;
  for (const b2AABB& aabb : boxes) list.emplace_back(aabb);
  return list;
}

}  // namespace tree_oracle
