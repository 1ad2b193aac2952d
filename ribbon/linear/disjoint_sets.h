#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ribbon {

/// Sets of the numbers 0 … count − 1 that are joined step by step. The root of a set is its smallest number. It
/// allocates memory only for more numbers than ever before.
class DisjointSets {
 public:
  /// Starts with a set for each number.
  void begin(std::size_t count) {
    parents_.assign(count, 0);
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  /// Returns the root of the set of a number.
  std::size_t root(std::size_t number) {
    while (parents_[number] != number) number = parents_[number] = parents_[parents_[number]];
    return number;
  }
  /// Joins the sets of two numbers.
  void join(std::size_t a, std::size_t b) {
    const std::size_t root_a = root(a);
    const std::size_t root_b = root(b);
    parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

 private:
  std::vector<std::size_t> parents_;  // by number
};

}  // namespace ribbon
