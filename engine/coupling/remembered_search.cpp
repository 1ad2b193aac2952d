#include "ribbon/box2d/remembered_search.h"

#include <algorithm>

namespace ribbon::box2d {
namespace {

constexpr std::size_t fetched_nodes = 16;  // that are fetched from memory before they are compared

}  // namespace

void RememberedSearch::reserve(std::size_t nodes) {
  boxes_.reserve(LeafSearch::max_boxes);
  nodes_.reserve(nodes);
  tests_.reserve(nodes);
  leaves_.reserve(nodes);
}

bool RememberedSearch::is_current(const BroadPhaseTree& tree, std::span<const SearchBox> boxes) {
  if (nodes_.empty() || nodes_.front().index != tree.root() || boxes.size() != boxes_.size()) return false;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!boxes_[k].contains(boxes[k])) return false;
  }
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (k + fetched_nodes < nodes_.size()) prefetch_node(tree, nodes_[k + fetched_nodes].index);
    const b2TreeNode& node = tree[nodes_[k].index];
    if (!is_same(node, nodes_[k]) && !has_same_result(node, k)) return false;
  }
  return true;
}

/// A box with NaN is never the same.
bool RememberedSearch::is_same(const b2TreeNode& node, const Node& before) {
  return node.aabb.lowerBound == before.aabb.lowerBound && node.aabb.upperBound == before.aabb.upperBound &&
         node.child1 == before.child1 && node.child2 == before.child2;
}

/// Returns whether the search goes on below a changed node as it did. What is below a node that overlaps no box does
/// not matter.
bool RememberedSearch::has_same_result(const b2TreeNode& node, std::size_t k) {
  const auto& [boxes, inside] = tests_[k];
  if (overlapped(boxes_, boxes, node.aabb) != inside) return false;
  if (inside != 0 && (node.child1 != nodes_[k].child1 || node.child2 != nodes_[k].child2)) return false;
  nodes_[k] = {node.aabb, nodes_[k].index, node.child1, node.child2};
  return true;
}

void RememberedSearch::search(LeafSearch& search, const BroadPhaseTree& tree, std::span<const SearchBox> boxes) {
  boxes_.assign(boxes.begin(), boxes.end());
  leaves_.clear();
  search.find(tree, boxes_, [this](int leaf, BoxSet set) { leaves_.push_back({leaf, set}); });
  nodes_.clear();
  tests_.clear();
  for (const LeafSearch::Visit& visit : search.visits()) {
    const b2TreeNode& node = tree[visit.node];
    nodes_.push_back({node.aabb, visit.node, node.child1, node.child2});
    tests_.push_back({visit.boxes, visit.inside});
  }
}

}  // namespace ribbon::box2d
