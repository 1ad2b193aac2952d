#include "ribbon/box2d/remembered_search.h"

#include <algorithm>

namespace ribbon::box2d {
namespace {

constexpr std::size_t fetched_nodes = 16;  // that are fetched from memory before they are compared

bool is_same(const b2AABB& a, const b2AABB& b) {  // false for NaN
  return a.lowerBound == b.lowerBound && a.upperBound == b.upperBound;
}

}  // namespace

void RememberedSearch::reserve(std::size_t nodes) {
  boxes_.reserve(LeafSearch::max_boxes);
  entered_.reserve(nodes);
  outside_.reserve(nodes);
  inside_.reserve(nodes);
  leaves_.reserve(nodes);
}

bool RememberedSearch::is_current(const BroadPhaseTree& tree, std::span<const SearchBox> boxes) {
  if (boxes_.empty() || root_ != tree.root() || boxes.size() != boxes_.size()) return false;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!boxes_[k].contains(boxes[k])) return false;
  }
  return enters_the_same(tree) && ends_the_same(tree, inside_, leaves_) && ends_the_same(tree, outside_, {});
}

/// Returns whether the children of all nodes that the search entered are the same.
bool RememberedSearch::enters_the_same(const BroadPhaseTree& tree) const {
  for (std::size_t k = 0; k < entered_.size(); ++k) {
    if (k + fetched_nodes < entered_.size()) prefetch_children(tree, entered_[k + fetched_nodes].index);
    const b2TreeNode& node = tree[entered_[k].index];
    if (node.child1 != entered_[k].child1 || node.child2 != entered_[k].child2) return false;
  }
  return true;
}

/// Returns whether these ends overlap the same boxes: those of `leaves`, or none. What is below a node that overlaps no
/// box does not matter.
bool RememberedSearch::ends_the_same(const BroadPhaseTree& tree, std::span<End> ends, std::span<const Leaf> leaves) {
  const BoxSet all = ~BoxSet{0} >> (LeafSearch::max_boxes - boxes_.size());
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (k + fetched_nodes < ends.size()) prefetch(&tree[ends[k + fetched_nodes].index].aabb);
    const b2TreeNode& node = tree[ends[k].index];
    if (!leaves.empty() && !node.IsLeaf()) return false;
    if (is_same(node.aabb, ends[k].aabb)) continue;
    if (overlapped(boxes_, all, node.aabb) != (leaves.empty() ? BoxSet{0} : leaves[k].boxes)) return false;
    ends[k].aabb = node.aabb;
  }
  return true;
}

void RememberedSearch::search(LeafSearch& search, const BroadPhaseTree& tree, std::span<const SearchBox> boxes) {
  boxes_.assign(boxes.begin(), boxes.end());
  root_ = tree.root();
  entered_.clear();
  outside_.clear();
  inside_.clear();
  leaves_.clear();
  search.find(tree, boxes_, [this](int leaf, BoxSet set) { leaves_.push_back({leaf, set}); });
  for (const LeafSearch::Visit& visit : search.visits()) {
    const b2TreeNode& node = tree[visit.node];
    if (visit.inside == 0) {
      outside_.push_back({node.aabb, visit.node});
    } else if (node.IsLeaf()) {
      inside_.push_back({node.aabb, visit.node});
    } else {
      entered_.push_back({visit.node, node.child1, node.child2});
    }
  }
}

}  // namespace ribbon::box2d
