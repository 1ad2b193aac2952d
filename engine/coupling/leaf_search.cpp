#include "ribbon/box2d/leaf_search.h"

#include <cstddef>
#include <type_traits>

namespace ribbon::box2d {
namespace {

/// Stores the first leaf that a query of Box2D finds, and ends the query.
struct FirstLeaf {
  bool QueryCallback(int32 found) {  // NOLINT(readability-identifier-naming): Box2D names it
    leaf = found;
    return false;
  }
  int leaf = b2_nullNode;
};

}  // namespace

BroadPhaseTree::BroadPhaseTree(const b2BroadPhase& broad_phase) {
  static_assert(std::is_standard_layout_v<b2TreeNode> && offsetof(b2TreeNode, aabb) == 0);
  if (broad_phase.GetProxyCount() == 0) return;
  FirstLeaf first;
  b2AABB everything;
  everything.lowerBound.Set(-b2_maxFloat, -b2_maxFloat);
  everything.upperBound.Set(b2_maxFloat, b2_maxFloat);
  broad_phase.Query(&first, everything);
  nodes_ = reinterpret_cast<const b2TreeNode*>(&broad_phase.GetFatAABB(first.leaf)) - first.leaf;
  root_ = first.leaf;
  while (nodes_[root_].parent != b2_nullNode) root_ = nodes_[root_].parent;
}

}  // namespace ribbon::box2d
