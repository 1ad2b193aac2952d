#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// A symmetric matrix of 2 × 2 blocks in any pattern, and the solve of a system with it by LDLᵀ without pivoting, for
/// what couples further than a band reaches. Slots of the unknowns are eliminated in a given order; eliminating one
/// couples all later ones that it is coupled with, and the blocks that this fills are part of the pattern. Once it has
/// been as large as it gets, nothing takes memory.
class BlockLdlt {
 public:
  /// Begins a pattern of diagonal blocks. order[k] is the slot that is eliminated as the k-th; each occurs once.
  void begin_pattern(std::span<const int> order);
  /// Adds the blocks of two slots with each other; either way round, and as often as one likes.
  void couple(int a, int b);
  /// Completes the pattern by what elimination fills.
  void end_pattern();
  /// Eliminates the slots in another order, and completes the pattern anew.
  void reorder(std::span<const int> order);
  /// Tells visit(slot, slot) what was coupled.
  template <typename Visit>
  void for_each_coupling(Visit&& visit) const {
    for (const auto& [a, b] : couplings_) visit(order_[at(a)], order_[at(b)]);
  }
  bool is_coupled(int a, int b) const;
  /// How many rows of blocks there are.
  std::size_t size() const { return order_.size(); }
  /// How many blocks right of the diagonal there are.
  std::size_t blocks() const { return columns_.size(); }

  /// Sets the matrix to zero, with nothing held and nothing dual.
  void set_zero();
  void make_dual(int slot) { dual_[at(row_of_[at(slot)])] = 1; }
  /// Adds [xx, xy; yx, yy] to the block of slots a and b ≠ a, its transpose to that of b and a.
  void add(int a, int b, double xx, double xy, double yx, double yy);
  /// Adds a symmetric block to the diagonal.
  void add(int a, double xx, double xy, double yy);
  /// Adds factor·g·gᵀ, g having the part by[i] at slots[i].
  void add_outer(double factor, std::span<const int> slots, std::span<const Vec2> by);
  /// Adds a band's blocks, the 2 × 2 entries from (2p, 2q) on to that of slots first + p and first + q for p ≤ q ≤
  /// p + reach.
  void add_band(int first, const BandedMatrix& band, int reach);
  /// Makes the slot's rows and columns those of the identity, until the next set_zero.
  void hold(int slot) { held_[at(row_of_[at(slot)])] = 1; }

  /// Overwrites the right-hand side, by slot, with the solution, and the matrix with its factors. False if in
  /// double precision it is not as definite as it should be; the right-hand side is then undefined.
  bool solve(std::span<Vec2> b);
  /// The same of another right-hand side, by the factors of the last solve; what was held has to be 0.
  void solve_again(std::span<Vec2> b);

 private:
  struct Block {
    double xx, xy, yx, yy;
    void operator+=(Block b);
  };
  struct Diagonal {
    double xx, xy, yy;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::size_t find(int row, int column) const;
  bool eliminate(std::size_t row);
  void substitute(std::span<Vec2> b);

  std::vector<int> order_;                     // slot by row
  std::vector<int> row_of_;                    // row by slot
  std::vector<std::array<int, 2>> couplings_;  // rows a < b, in any order, some more than once
  std::vector<std::size_t> coupling_first_;    // by row, while the pattern is made
  std::vector<int> coupled_;
  std::vector<int> first_child_, next_child_;
  std::vector<int> mark_;
  std::vector<std::size_t> first_;  // of each row in columns_, and the end of the last
  std::vector<int> columns_;        // rising within a row
  std::vector<Block> blocks_;
  std::vector<Diagonal> diagonals_;
  std::vector<char> held_, dual_;
  std::vector<Vec2> right_side_;
};

}  // namespace ribbon
