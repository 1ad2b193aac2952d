#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/cell.h"
#include "ribbon/elastic/term.h"

namespace ribbon {

/// The cells of a ribbon; and, where it declares area stiffness, what keeps their corners from being squashed and turns
/// back those that are inside out.
///
/// A corner triangle of signed area A_c, A₀ = a·b/2 at rest, has the energy ½·k_A·(αA₀ − A_c)₊²/A₀ with α = 0.2, finite
/// and once differentiable through zero and negative area. An unlocked cell has for the step the convex ½A(μ|w|² + (μ +
/// λ)|z − 2d̄|²) + ½·10E·|h|² instead of its own energy, d̄ the mean direction of z around it.
class Cells final : public Term {
 public:
  /// `modulus`: E·depth [N/m]; `row_bending`: EI of each row of cells, N·m².
  Cells(const CordDef& def, double modulus, double row_bending);

  std::size_t tension_count() const override { return columns_ * rows_; }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& at, double sign, std::span<double> tensions) const override;
  void add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void add_constant(BandedMatrix& matrix) const override;
  void load(const NewtonSystem& system, std::span<const double> tensions) override;
  void update(const NewtonSystem& system, std::span<const double> tensions, std::span<const Vec2> direction,
              std::span<double> next) const override;
  double potential(const Shape& shape, std::span<const double> most) const override;
  double energy(const Motion& at, std::span<const double> tensions) const override;
  bool unlock(std::span<const Vec2> x) override;
  std::span<char> unlocked() override { return unlocked_; }

 private:
  std::size_t point(std::size_t column, std::size_t row) const { return column * (rows_ + 1) + row; }
  Corners corners(std::span<const Vec2> x, std::size_t column, std::size_t row) const;
  bool is_unlocked(std::size_t cell) const { return any_unlocked_ && unlocked_[cell] != 0; }
  double turning(const Stage& stage, std::size_t column, std::size_t row, Vec2 d) const;
  double unlock_hourglass(const Cell& cell) const;
  double mean_tension(std::size_t column, std::span<const double> tensions) const;
  void load_corner_areas(const NewtonSystem& system, std::size_t column, std::size_t row);
  double corner_energy(const Cell& cell, const Corners& x) const;

  std::size_t columns_;  // of cells
  std::size_t rows_;
  double height_;   // m, b of a cell
  double modulus_;  // N/m
  double poisson_ratio_;
  double row_bending_;        // N·m²
  double damping_;            // s
  double area_stiffness_;     // N/m
  std::vector<Cell> shapes_;  // of each column

  bool any_unlocked_ = false;
  std::vector<char> unlocked_;  // by cell, where area stiffness is declared
  std::vector<Vec2> toward_;    // d̄ of each column
};

}  // namespace ribbon
