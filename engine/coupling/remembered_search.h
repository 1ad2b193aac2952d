#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/box2d/leaf_search.h"

namespace ribbon::box2d {

/// The search of a tree for a group of boxes, which is repeated tick after tick. It remembers which nodes the last
/// search read. As long as these are as they were, another search would find the same leaves, so it is left out. To
/// compare a node with its copy takes a fraction of the time of testing it for the boxes.
///
/// The tree may change in any way between ticks, and may be another one: each node is reached from the root, through
/// nodes that were found to be the same.
class RememberedSearch {
 public:
  /// A leaf of the tree, and the boxes that it overlaps.
  struct Leaf {
    int node;
    BoxSet boxes;
  };

  /// Reserves memory for so many nodes that a search reads.
  void reserve(std::size_t nodes);
  /// Returns whether the last search for as many boxes, each of which contained the one given here, would find the same
  /// leaves in the tree now.
  bool is_current(const BroadPhaseTree& tree, std::span<const SearchBox> boxes);
  /// Returns the leaves that overlap the boxes of the last search.
  std::span<const Leaf> leaves() const { return leaves_; }
  /// Searches for boxes and remembers the search.
  void search(LeafSearch& search, const BroadPhaseTree& tree, std::span<const SearchBox> boxes);

 private:
  /// A node as it was when it was read.
  struct Node {
    b2AABB aabb;
    int index;
    int child1;
    int child2;
  };
  /// The boxes for which a node was tested, and those of them that it overlaps.
  struct Test {
    BoxSet boxes;
    BoxSet inside;
  };

  static bool is_same(const b2TreeNode& node, const Node& before);
  bool has_same_result(const b2TreeNode& node, std::size_t k);

  std::vector<SearchBox> boxes_;
  // By read node, in the order of the search: a node follows its parent.
  std::vector<Node> nodes_;
  std::vector<Test> tests_;
  std::vector<Leaf> leaves_;
};

}  // namespace ribbon::box2d
