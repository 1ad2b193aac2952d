#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/term.h"

namespace ribbon {

/// Bars along the middle line of a ribbon of three rows and more, between the mean of the two middle points of a column
/// and that of the next (the same point twice where rows are odd). It carries what stretch stiffness the cells, as soft
/// as bending wants them, leave missing.
class Spine final : public Term {
 public:
  /// `stiffness`: EA of the spine, N.
  Spine(const CordDef& def, double stiffness);

  std::size_t tension_count() const override { return rest_.size(); }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& at, double sign, std::span<double> tensions) const override;
  void add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void load(const NewtonSystem& system, std::span<const double> tensions) override;
  void update(const NewtonSystem& system, std::span<const double> tensions, std::span<const Vec2> direction,
              std::span<double> next) const override;
  double potential(const Shape& shape, std::span<const double> most) const override;
  double energy(const Motion& at, std::span<const double> tensions) const override;

 private:
  double turning(const Stage& stage, std::size_t e, Vec2 d) const;
  double rate(const Motion& at, std::size_t e) const;
  Vec2 middle(std::span<const Vec2> x, std::size_t column) const;
  Vec2 link(std::span<const Vec2> x, std::size_t column) const { return middle(x, column + 1) - middle(x, column); }

  double compliance(std::size_t link) const { return rest_[link] * inverse_stiffness_; }

  std::size_t rows_;
  std::size_t low_;  // rows of the two middle points
  std::size_t high_;
  double inverse_stiffness_;  // 1/N
  double damping_;            // s
  std::vector<double> rest_;  // m
};

}  // namespace ribbon
