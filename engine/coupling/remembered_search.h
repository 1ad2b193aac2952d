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
/// The box of a node contains those of its children. So what overlaps a leaf, or the top of a part of the tree that the
/// search did not enter, overlaps all nodes above. Therefore only the boxes of these ends have to be compared, and only
/// the children of the nodes that the search entered. That reads less memory, which takes most of the time.
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
  /// A node with children that the search entered.
  struct Entered {
    int index;
    int child1;
    int child2;
  };
  /// A node where the search ended: one that overlaps no box, or a leaf.
  struct End {
    b2AABB aabb;
    int index;
  };

  bool enters_the_same(const BroadPhaseTree& tree) const;
  bool ends_the_same(const BroadPhaseTree& tree, std::span<End> ends, std::span<const Leaf> leaves);

  std::vector<SearchBox> boxes_;
  int root_ = b2_nullNode;
  std::vector<Entered> entered_;  // in the order of the search: a node follows its parent
  std::vector<End> outside_;      // that overlap no box
  std::vector<End> inside_;       // leaves_
  std::vector<Leaf> leaves_;
};

}  // namespace ribbon::box2d
