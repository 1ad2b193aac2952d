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

/// Returns the index of a leaf. The broad phase must have one.
int any_leaf(const b2BroadPhase& broad_phase) {
  FirstLeaf first;
  b2AABB everything;
  everything.lowerBound.Set(-b2_maxFloat, -b2_maxFloat);
  everything.upperBound.Set(b2_maxFloat, b2_maxFloat);
  broad_phase.Query(&first, everything);
  return first.leaf;
}

}  // namespace

/// Node 0 is mostly in use: it belongs to the first fixture of the world, unless that was destroyed.
BroadPhaseTree::BroadPhaseTree(const b2BroadPhase& broad_phase) {
  static_assert(std::is_standard_layout_v<b2TreeNode> && offsetof(b2TreeNode, aabb) == 0);
  if (broad_phase.GetProxyCount() == 0) return;
  nodes_ = reinterpret_cast<const b2TreeNode*>(&broad_phase.GetFatAABB(0));
  const bool is_free = nodes_[0].height < 0;
  root_ = is_free ? any_leaf(broad_phase) : 0;
  while (nodes_[root_].parent != b2_nullNode) root_ = nodes_[root_].parent;
}

bool may_overlap_leaf(const BroadPhaseTree& tree, const SearchBox& box) {
  if (tree.root() == b2_nullNode || !box.overlaps(tree[tree.root()].aabb)) return false;
  for (const b2TreeNode* node = &tree[tree.root()]; !node->IsLeaf();) {
    const b2TreeNode& first = tree[node->child1];
    const b2TreeNode& second = tree[node->child2];
    const bool in_first = box.overlaps(first.aabb);
    const bool in_second = box.overlaps(second.aabb);
    if (in_first == in_second) return in_first;
    node = in_first ? &first : &second;
  }
  return true;
}

}  // namespace ribbon::box2d
