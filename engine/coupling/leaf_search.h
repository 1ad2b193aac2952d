#pragma once

#include <box2d/box2d.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ribbon::box2d {

/// Starts to fetch a cache line from memory. It changes nothing but the speed.
inline void prefetch(const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

/// A box that overlaps other boxes exactly if b2TestOverlap says so, in fewer instructions and without branches.
class SearchBox {
 public:
  SearchBox() = default;
  explicit SearchBox(const b2AABB& box)
      : ends_{box.lowerBound.x, box.lowerBound.y, -box.upperBound.x, -box.upperBound.y} {}

  /// Two boxes are apart if one of them begins behind the end of the other: a.low > b.high or −a.high > −b.low, in x or
  /// in y. No comparison with NaN is true.
  bool overlaps(const b2AABB& box) const {
    const Ends others = {box.upperBound.x, box.upperBound.y, -box.lowerBound.x, -box.lowerBound.y};
#if defined(__GNUC__)
    const auto is_apart = std::bit_cast<std::array<std::uint64_t, 2>>(ends_ > others);
    return (is_apart[0] | is_apart[1]) == 0;
#else
    bool is_apart = false;
    for (std::size_t k = 0; k < 4; ++k) is_apart |= ends_[k] > others[k];
    return !is_apart;
#endif
  }

  /// Returns a box that is larger by a margin [m] on each side, rounded.
  SearchBox widened(float margin) const {
    SearchBox larger = *this;
    for (std::size_t k = 0; k < 4; ++k) larger.ends_[k] -= margin;
    return larger;
  }
  /// Returns whether the other box is in this one.
  bool contains(const SearchBox& other) const {
    bool contains = true;
    for (std::size_t k = 0; k < 4; ++k) contains = contains && ends_[k] <= other.ends_[k];
    return contains;
  }

 private:
#if defined(__GNUC__)
  using Ends = float __attribute__((vector_size(4 * sizeof(float))));
#else
  using Ends = std::array<float, 4>;
#endif
  Ends ends_{};  // m: low x, low y, −high x, −high y
};

/// Some of up to 64 boxes: bit k is 1 for box k.
using BoxSet = std::uint64_t;

/// Calls visit(k) for each box of a set, in ascending order.
template <typename Visit>
void for_each_box(BoxSet set, Visit&& visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<std::size_t>(std::countr_zero(set)));
}

/// Returns those boxes of a set that overlap another box.
inline BoxSet overlapped(std::span<const SearchBox> boxes, BoxSet set, const b2AABB& box) {
  BoxSet inside = 0;
  for_each_box(set, [&](std::size_t k) { inside |= static_cast<BoxSet>(boxes[k].overlaps(box)) << k; });
  return inside;
}

/// The tree of a broad phase, for reading.
///
/// Box2D gives no access to its nodes. But they are elements of one array, ordered by index, and
/// b2BroadPhase::GetFatAABB returns a reference to the first member of one of them.
class BroadPhaseTree {
 public:
  explicit BroadPhaseTree(const b2BroadPhase& broad_phase);

  int root() const { return root_; }  ///< index of the root; b2_nullNode if there is no leaf
  const b2TreeNode& operator[](int index) const { return nodes_[index]; }

 private:
  const b2TreeNode* nodes_ = nullptr;
  int root_ = b2_nullNode;
};

// They start to fetch a node, or where its children are, from memory. There need be no node with that index.
inline void prefetch_node(const BroadPhaseTree& tree, int index) { prefetch(&tree[index]); }
inline void prefetch_children(const BroadPhaseTree& tree, int index) {
  prefetch(&tree[index].child1);
  prefetch(&tree[index].child2);
}

/// Returns whether a leaf of a tree may overlap a box. It goes down for as long as only one child of a node overlaps
/// the box. False is certain.
bool may_overlap_leaf(const BroadPhaseTree& tree, const SearchBox& box);

/// Finds the leaves of a tree that overlap boxes. It searches for many boxes at once and so reads a node near several
/// of them once only; most of the time of a query of Box2D goes into reading nodes.
class LeafSearch {
 public:
  static constexpr std::size_t max_boxes = 64;

  /// Reserves memory for so many nodes on one level of the tree.
  void reserve(std::size_t nodes) { visits_.reserve(2 * nodes); }
  /// Calls take(leaf, set), with the index of the leaf, for each leaf that overlaps some of the boxes, 1 …
  /// max_boxes of them. `take` may shrink boxes. O(nodes near the boxes).
  ///
  /// It goes through the tree level by level. So the memory of a node is fetched long before the node is read.
  template <typename Take>
  void find(const BroadPhaseTree& tree, std::span<const SearchBox> boxes, Take&& take) {
    visits_.clear();
    if (tree.root() != b2_nullNode) visits_.push_back({tree.root(), ~BoxSet{0} >> (max_boxes - boxes.size()), 0});
    for (std::size_t next = 0; next < visits_.size(); ++next) {
      const int index = visits_[next].node;
      const b2TreeNode& node = tree[index];
      const BoxSet inside = overlapped(boxes, visits_[next].boxes, node.aabb);
      visits_[next].inside = inside;
      if (inside == 0) continue;
      if (node.IsLeaf()) {
        take(index, inside);
      } else {
        prefetch_node(tree, node.child1);
        prefetch_node(tree, node.child2);
        visits_.push_back({node.child1, inside, 0});
        visits_.push_back({node.child2, inside, 0});
      }
    }
  }
  /// A node that a search has read.
  struct Visit {
    int node;
    BoxSet boxes;   ///< that overlap its parent
    BoxSet inside;  ///< that overlap it
  };
  /// Returns the nodes that the last search has read, in this order.
  std::span<const Visit> visits() const { return visits_; }

 private:
  std::vector<Visit> visits_;  // and, during a search, behind them the nodes that it will read
};

}  // namespace ribbon::box2d
