#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace ribbon {

/// An axis-aligned box, m.
struct Box {
  Vec2 low;
  Vec2 high;
};

inline bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Around two points, and `margin` further on every side.
inline Box box_around(Vec2 a, Vec2 b, double margin) {
  return {{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin},
          {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin}};
}

inline Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

inline Box widened(const Box& box, double margin) {
  return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
}

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
