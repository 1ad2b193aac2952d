#include "ribbon/geometry/quadtree.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace ribbon {
namespace {

Vec2 middle(const Box& box) { return 0.5 * (box.low + box.high); }

/// Returns a square around the centres of all boxes, not smaller than the largest box: its centre and half its side
/// [m].
std::pair<Vec2, double> bounding_square(std::span<const Box> boxes) {
  constexpr double far = std::numeric_limits<double>::max();
  Vec2 low{far, far};
  Vec2 high{-far, -far};
  double extent = 0.0;
  for (const Box& box : boxes) {
    const Vec2 c = middle(box);
    low = {std::min(low.x, c.x), std::min(low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    extent = std::max({extent, box.high.x - box.low.x, box.high.y - box.low.y});
  }
  return {middle({low, high}), 0.5 * std::max({high.x - low.x, high.y - low.y, extent})};
}

}  // namespace

Quadtree::Quadtree(int max_items) {
  const auto n = static_cast<std::size_t>(max_items);
  // A straight line of equal items needs about 8 nodes per item. Without free nodes an item stays in a larger node,
  // where queries still find it.
  nodes_.reserve(8 * n + 64);
  boxes_.reserve(n);
  next_item_.reserve(n);
}

void Quadtree::build(std::span<const Box> boxes) {
  assert(boxes.size() <= boxes_.capacity());
  nodes_.clear();
  boxes_.assign(boxes.begin(), boxes.end());
  next_item_.assign(boxes.size(), -1);
  if (boxes.empty()) return;
  const auto [center, half_size] = bounding_square(boxes);
  nodes_.push_back({center, half_size});
  // A list puts the newest item first. From the last item to the first, each node lists its items in rising order.
  for (int item = static_cast<int>(boxes.size()) - 1; item >= 0; --item) insert(item);
}

void Quadtree::insert(int item) {
  const Box& box = boxes_[static_cast<std::size_t>(item)];
  const Vec2 c = middle(box);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  int index = 0;
  for (int depth = 1; depth < max_depth; ++depth) {
    // The loose box of a child contains every item that has its centre in the child's square and is not wider than it.
    if (!(extent <= node(index).half_size) || !divide(index)) break;
    const Node& parent = node(index);
    index = parent.first_child + (c.x >= parent.center.x ? 1 : 0) + (c.y >= parent.center.y ? 2 : 0);
  }
  Node& owner = node(index);
  next_item_[static_cast<std::size_t>(item)] = owner.first_item;
  owner.first_item = item;
}

bool Quadtree::divide(int index) {
  const Node parent = node(index);
  if (parent.first_child >= 0) return true;
  if (nodes_.size() + 4 > nodes_.capacity()) return false;
  node(index).first_child = static_cast<int>(nodes_.size());
  const double half_size = 0.5 * parent.half_size;
  for (int child = 0; child < 4; ++child) {
    const double dx = (child & 1) != 0 ? half_size : -half_size;
    const double dy = (child & 2) != 0 ? half_size : -half_size;
    nodes_.push_back({{parent.center.x + dx, parent.center.y + dy}, half_size});
  }
  return true;
}

}  // namespace ribbon
