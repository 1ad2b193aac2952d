#pragma once

#include <array>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// A loose quadtree (the space division of Goto 2017, section 3.6). An item is stored in the smallest node that is not
/// smaller than the item and contains its centre. Queries test a box of twice the node's size. So an item across a
/// dividing line costs no more than another, and a straight cord costs as little as a heap. Only the constructor
/// allocates memory.
class Quadtree {
 public:
  /// Allocates memory for up to `max_items` items.
  explicit Quadtree(int max_items);

  /// Replaces all items: item k is boxes[k].
  void build(std::span<const Box> boxes);

  /// Calls visit(item) for each item whose box overlaps `box`. The order depends only on the boxes.
  template <typename Visit>
  void query(const Box& box, Visit&& visit) const {
    std::array<int, 4 * max_depth> open;
    int open_count = 0;
    if (!nodes_.empty()) open[static_cast<std::size_t>(open_count++)] = 0;
    while (open_count > 0) {
      const Node& top = node(open[static_cast<std::size_t>(--open_count)]);
      if (!overlap(loose_box(top), box)) continue;
      for (int item = top.first_item; item >= 0; item = next_item_[static_cast<std::size_t>(item)]) {
        if (overlap(boxes_[static_cast<std::size_t>(item)], box)) visit(item);
      }
      if (top.first_child < 0) continue;
      for (int child = 0; child < 4; ++child) open[static_cast<std::size_t>(open_count++)] = top.first_child + child;
    }
  }

 private:
  static constexpr int max_depth = 16;

  struct Node {
    Vec2 center;
    double half_size;
    int first_child = -1;  // the first of four consecutive nodes; −1: none
    int first_item = -1;   // head of the list in next_item_; −1: none
  };

  static Box loose_box(const Node& node) {
    const double half = 2.0 * node.half_size;
    return {{node.center.x - half, node.center.y - half}, {node.center.x + half, node.center.y + half}};
  }
  Node& node(int index) { return nodes_[static_cast<std::size_t>(index)]; }
  const Node& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
  void insert(int item);
  /// Creates the children of a node. Returns false if there is no memory for them.
  bool divide(int index);

  std::vector<Node> nodes_;
  std::vector<Box> boxes_;
  std::vector<int> next_item_;
};

}  // namespace ribbon
