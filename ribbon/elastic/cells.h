#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/cell.h"
#include "ribbon/elastic/term.h"

namespace ribbon {

/// The cells of a ribbon. With area stiffness, their corners resist compression, and inverted cells are turned back.
///
/// A corner triangle of signed area A_c, at rest A₀ = a·b/2, has the energy ½·k_A·(αA₀ − A_c)₊²/A₀ with α = 0.2. It is
/// finite and continuously differentiable through zero and negative area. An unlocked cell is an inverted one that is
/// turned back: during the step it has the convex energy ½A(μ|w|² + (μ + λ)|z − 2d̄|²) + ½·10E·|h|² instead of its own,
/// d̄ the mean direction of z around it.
class Cells final : public Term {
 public:
  /// Creates the cells of a ribbon. `modulus` is E·depth [N/m], `row_bending` EI of each row of cells [N·m²].
  Cells(const CordDef& def, double modulus, double row_bending);

  std::size_t tension_count() const override { return columns_ * rows_; }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& motion, double sign, std::span<double> tensions) const override;
  void add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void add_constant(BandedMatrix& matrix) const override;
  void load(const NewtonSystem& system, std::span<const double> tensions) override;
  void update(const NewtonSystem& system, std::span<const double> tensions, std::span<const Vec2> direction,
              std::span<double> next) const override;
  double potential(const Shape& shape, std::span<const double> max_tensions) const override;
  double energy(const Motion& motion, std::span<const double> tensions) const override;
  Vec2 force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const override;
  Vec2 section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const override;
  bool unlock(std::span<const Vec2> x) override;
  std::span<char> unlocked() override { return unlocked_; }
  void lock() override;
  bool has_deep_inversion(std::span<const Vec2> x) const override;

 private:
  std::size_t point(std::size_t column, std::size_t row) const { return column * (rows_ + 1) + row; }
  Corners corners(std::span<const Vec2> x, std::size_t column, std::size_t row) const;
  bool is_unlocked(std::size_t cell) const { return any_unlocked_ && unlocked_[cell] != 0; }
  double rotational_spread(const Stage& stage, std::size_t column, std::size_t row, Vec2 d) const;
  double unlock_hourglass(const Cell& cell) const;
  double mean_tension(std::size_t column, std::span<const double> tensions) const;
  Corners load_locked(const NewtonSystem& system, std::size_t column, std::size_t row, Vec2 d, double across,
                      CellAssembler& assembler) const;
  Corners load_unlocked(const NewtonSystem& system, std::size_t column, std::size_t row, Vec2 d,
                        CellAssembler& assembler) const;
  void load_corner_areas(const NewtonSystem& system, std::size_t column, std::size_t row);
  bool find_unlocked(std::span<const Vec2> x);
  void find_target_directions(std::span<const Vec2> x);
  Corners cell_forces(std::size_t column, std::size_t row, const Motion& motion,
                      std::span<const double> tensions) const;
  double corner_energy(const Cell& cell, const Corners& x) const;

  std::size_t columns_;  // of cells
  std::size_t rows_;
  double height_;   // m, b
  double modulus_;  // N/m
  double poisson_ratio_;
  double row_bending_;        // N·m²
  double damping_;            // s
  double area_stiffness_;     // N/m
  std::vector<Cell> shapes_;  // of each column

  bool any_unlocked_ = false;
  std::vector<char> unlocked_;           // by cell, where area stiffness is declared
  std::vector<Vec2> target_directions_;  // d̄ of each column
};

}  // namespace ribbon
