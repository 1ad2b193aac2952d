#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/linear/block_pattern.h"
#include "ribbon/linear/index.h"
#include "ribbon/linear/pair.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// A sparse symmetric matrix of 2 × 2 blocks, and its direct solver: LDLᵀ without pivoting. For systems whose couplings
/// reach further than a band. A slot holds two unknowns; the slots are eliminated in a given order. Eliminating a slot
/// couples all later slots that it is coupled with; these fill-in blocks are part of the pattern. It allocates memory
/// only for a larger pattern than ever before. A solve costs O(Σ k²), k the number of blocks right of the diagonal in a
/// row.
class BlockLdlt {
 public:
  /// Starts a pattern of diagonal blocks. The slot order[k] is eliminated as number k; each slot occurs once, except
  /// the `tied` ones: each of these is one with a slot of the order, and what is added to either is added to both.
  void begin_pattern(std::span<const int> order, std::span<const TiedSlot> tied = {}) { pattern_.begin(order, tied); }
  /// Adds the blocks (a, b) and (b, a) to the pattern. Repeated couplings count once.
  void couple(int a, int b) { pattern_.couple(a, b); }
  /// Completes the pattern with the fill-in of the elimination.
  void end_pattern();
  /// Changes the order of elimination, with the same tied slots, and completes the pattern again.
  void reorder(std::span<const int> order);
  /// Calls visit(a, b) for each call of couple(), with either slot first.
  template <typename Visit>
  void for_each_coupling(Visit&& visit) const {
    pattern_.for_each_coupling(visit);
  }
  /// Returns whether the pattern has the block (a, b), as a coupling or as fill-in.
  bool is_coupled(int a, int b) const;
  /// Returns the number of slots that are not tied.
  std::size_t size() const { return pattern_.size(); }
  /// Returns the number of blocks right of the diagonal, fill-in included.
  std::size_t off_diagonal_blocks() const { return pattern_.blocks(); }

  /// Sets all blocks to 0; no slot is held and none is dual.
  void set_zero();
  /// Declares that the slot has a negative definite pivot: a Lagrange multiplier such as a tension.
  void make_dual(int slot) { dual_[at(pattern_.row_of(slot))] = 1; }
  /// Declares the same of a slot whose second component is coupled with nothing.
  void make_scalar_dual(int slot) { dual_[at(pattern_.row_of(slot))] = scalar_dual; }
  /// Adds [xx, xy; yx, yy] to the block (a, b), b ≠ a, and its transpose to (b, a).
  void add(int a, int b, double xx, double xy, double yx, double yy);
  /// Adds [xx, xy; xy, yy] to the diagonal block (a, a).
  void add(int a, double xx, double xy, double yy);
  /// Adds factor·g·gᵀ, where the vector g is by[i] at slots[i] and 0 elsewhere.
  void add_outer(double factor, std::span<const int> slots, std::span<const Vec2> by);
  /// Adds a banded matrix: its 2 × 2 block at (2p, 2q) to the block (first + p, first + q), for p ≤ q ≤ p + reach.
  void add_band(int first, const BandedMatrix& band, int reach);
  /// Replaces the rows and columns of the slot by those of the identity, until the next set_zero.
  void hold(int slot) { held_[at(pattern_.row_of(slot))] = 1; }

  /// Overwrites b, by slot, with the solution of A·x = b, where b of slots that are tied is the sum of theirs, and the
  /// matrix with its factors. Returns false if a pivot in double precision is not positive definite, or not negative
  /// definite for a dual slot; b is then undefined.
  bool solve(std::span<Vec2> b);
  /// Solves for another right-hand side with the factors of the last solve. Entries of held slots must be 0.
  void solve_again(std::span<Vec2> b);

 private:
  struct Block {
    double xx, xy, yx, yy;
    void operator+=(Block b);
  };
  struct Diagonal {
    double xx, xy, yy;
  };
  /// A row that is eliminated.
  struct Pivot {
    Diagonal inverse;
    Vec2 right_side;
    Block* block;  ///< the next to be eliminated
  };
  /// Of pivots, in one column.
  template <std::size_t rows>
  struct Factors {
    std::array<std::array<Pair, 2>, rows> l;  ///< rows of the block of L
    std::array<const Block*, rows> later;     ///< the blocks behind it
  };
  static constexpr char scalar_dual = 2;  // a value of dual_

  void load_right_side(std::span<const Vec2> b);
  void resize_blocks();
  bool invert_pivot(std::size_t row);
  template <std::size_t rows>
  bool eliminate_rows(std::size_t first_row);
  template <std::size_t rows, std::size_t scalars>
  bool eliminate(std::size_t first_row);
  template <std::size_t rows>
  Factors<rows> eliminate_column(Pivot* pivots, std::size_t target);
  template <std::size_t rows, std::size_t scalars>
  static void subtract_products(const Factors<rows>& factors, std::size_t j, Block& block);
  template <std::size_t rows, std::size_t scalars>
  void subtract_rows(Pivot* pivots, const int* columns, std::size_t count);
  void substitute(std::span<Vec2> b);

  BlockPattern pattern_;
  std::vector<Block> blocks_;        // by index in the pattern
  std::vector<Diagonal> diagonals_;  // by row
  std::vector<char> held_, dual_;
  std::vector<Vec2> right_side_;
};

}  // namespace ribbon
