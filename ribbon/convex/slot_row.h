#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "ribbon/linear/block_ldlt.h"
#include "ribbon/linear/index.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// The derivatives of a length by up to four slots of points and bodies.
struct SlotRow {
  std::array<int, 4> slot{};
  std::array<Vec2, 4> by{};
  int size = 0;

  /// Adds to the derivative by a slot. There must not be more than four slots.
  void add(int s, Vec2 d) {
    for (int i = 0; i < size; ++i) {
      if (slot[at(i)] != s) continue;
      by[at(i)] += d;
      return;
    }
    slot[at(size)] = s;
    by[at(size++)] = d;
  }
  /// Returns the change of the length in a step.
  double along(std::span<const Vec2> step) const {
    double sum = 0.0;
    for (int i = 0; i < size; ++i) sum += dot(by[at(i)], step[at(slot[at(i)])]);
    return sum;
  }
  /// Adds a force [N] along the length to the forces [N] and torques [N·m] by slot.
  void push(double force, std::span<Vec2> forces) const {
    for (int i = 0; i < size; ++i) forces[at(slot[at(i)])] += force * by[at(i)];
  }
  /// Adds the blocks that the slots couple to the pattern of a matrix.
  void couple(BlockLdlt& matrix) const {
    for (int i = 0; i < size; ++i) {
      for (int j = i + 1; j < size; ++j) matrix.couple(slot[at(i)], slot[at(j)]);
    }
  }
  /// Returns whether the matrix has these blocks.
  bool is_coupled(const BlockLdlt& matrix) const {
    for (int i = 0; i < size; ++i) {
      for (int j = i + 1; j < size; ++j) {
        if (!matrix.is_coupled(slot[at(i)], slot[at(j)])) return false;
      }
    }
    return true;
  }
  std::span<const int> slots() const { return std::span(slot).first(at(size)); }
  std::span<const Vec2> derivatives() const { return std::span(by).first(at(size)); }
};

}  // namespace ribbon
