#pragma once

#include <array>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// A loose quadtree (space division of Goto 2017, section 3.6): an item lies in the node of its size that its centre
/// falls into, and a node answers for twice its own square. So an item that straddles a dividing line is no dearer
/// than another, and a straight cord costs as little as a heap. All memory is taken when it is made.
class Quadtree {
 public:
  explicit Quadtree(int max_items);

  /// Forgets what it held and sorts in boxes[k] as item k.
  void build(std::span<const Box> boxes);

  /// Calls visit(item) for each item whose box overlaps `box`, in an order that depends on the boxes alone.
  template <typename Visit>
  void query(const Box& box, Visit&& visit) const {
    std::array<int, 4 * max_depth> open;
    int open_count = 0;
    if (!nodes_.empty()) open[static_cast<std::size_t>(open_count++)] = 0;
    while (open_count > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(open[static_cast<std::size_t>(--open_count)])];
      if (!overlap(loose_box(node), box)) continue;
      for (int item = node.first_item; item >= 0; item = next_item_[static_cast<std::size_t>(item)]) {
        if (overlap(boxes_[static_cast<std::size_t>(item)], box)) visit(item);
      }
      if (node.first_child < 0) continue;
      for (int child = 0; child < 4; ++child) open[static_cast<std::size_t>(open_count++)] = node.first_child + child;
    }
  }

 private:
  static constexpr int max_depth = 16;

  struct Node {
    Vec2 center;
    double half_size;
    int first_child = -1;  // of four in a row
    int first_item = -1;
  };

  static Box loose_box(const Node& node) {
    const double reach = 2.0 * node.half_size;
    return {{node.center.x - reach, node.center.y - reach}, {node.center.x + reach, node.center.y + reach}};
  }
  void insert(int item);
  bool divide(int node);

  std::vector<Node> nodes_;
  std::vector<Box> boxes_;
  std::vector<int> next_item_;
};

}  // namespace ribbon
