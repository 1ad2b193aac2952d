#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/contact/contacts.h"
#include "ribbon/convex/limited_rows.h"
#include "ribbon/linear/block_ldlt.h"
#include "ribbon/linear/fill_order.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// The linear system of a Newton step of several cords, and of bodies that hold or touch them anywhere: one symmetric
/// matrix of blocks.
class BlockSystem {
 public:
  /// Begins a step. The elimination order of the step before is forgotten.
  void begin_step();
  /// Call it when what is coupled may have changed.
  void discard_pattern() { has_pattern_ = false; }
  /// Makes the pattern of the matrix, unless the last one has the blocks of the contacts, or of the limited rows.
  void make_pattern(const IslandState& state, const Contacts& contacts);
  void make_pattern(const IslandState& state, const LimitedRows& rows);
  /// Returns the number of blocks of the matrix, or 0 if there is no pattern.
  std::size_t blocks() const { return has_pattern_ ? matrix_.size() + matrix_.off_diagonal_blocks() : 0; }

  /// Loads the matrix and the right-hand side of all that is neither a contact nor a limited row.
  void load(const IslandState& state, const Stage& stage);
  /// Solves the system. The right-hand side becomes the solution. Returns false if a pivot has the wrong sign.
  bool solve(const IslandState& state);
  /// Solves the factorised system for another right-hand side.
  void solve_again(const IslandState& state);
  /// Copies the solution's part for points and bodies.
  void copy_direction(std::span<Vec2> direction) const;
  /// Writes the tensions, and the pulls of grips, of the solution to `next`. Returns whether a grip has begun to slip.
  bool update(IslandState& state, const Stage& stage, std::vector<Vec2>& direction, std::vector<double>& next);

  BlockLdlt& matrix() { return matrix_; }
  std::vector<Vec2>& right_side() { return right_side_; }

 private:
  template <typename Terms>
  void make_pattern_with(const IslandState& state, const Terms& terms);
  template <typename Terms>
  void find_natural_order(const IslandState& state, const Terms& terms);
  void order_with_bodies(const IslandState& state);
  void reduce_fill(const IslandState& state);
  void clear_constrained(const IslandState& state);
  void leave_out_tied(const IslandState& state);
  void find_friction_of_wheels(const IslandState& state);
  void add_friction_of_wheels(std::span<Vec2> solution) const;
  void append_duals_last(std::size_t slots, std::size_t duals, std::span<const int> order);

  /// The response of the system to a unit of friction of a wheel where the cord slips.
  struct WheelResponse {
    std::size_t dual = 0;   // slot of the tensions
    std::size_t first = 0;  // index in motions_
    bool before = false;    // the tension before the wheel is the smaller one
    double factor = 0.0;    // s·(e^(μ·α) − 1)
    double divisor = 1.0;

    double tension(std::span<const Vec2> solution) const { return before ? solution[dual].x : solution[dual].y; }
  };

  BlockLdlt matrix_;
  std::vector<Vec2> right_side_;
  bool has_pattern_ = false;
  std::vector<int> order_;
  bool has_fill_order_ = false;  // order_ fills little and was found in this step
  std::size_t filled_ = 0;       // blocks, when it was found
  FillOrder fill_order_;
  std::vector<int> rows_of_;              // row in that order, by slot of points and bodies
  std::vector<std::array<int, 2>> late_;  // tensions and pulls: the row after which it is eliminated, and its slot
  std::vector<WheelResponse> responses_;
  std::vector<Vec2> motions_;  // of the responses, by slot
  std::vector<Vec2> unit_;
  std::vector<int> last_points_;  // by body: the last point that it is coupled with
};

}  // namespace ribbon
