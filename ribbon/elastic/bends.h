#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/term.h"

namespace ribbon {

/// Bending of a rope: W = ½·EI/l̄ · |t₊ − t₋|² at each inner point. t₋ and t₊ are the links before and after the point,
/// divided by their rest lengths; l̄ is the mean of these. To lowest order it is the energy of Bergou et al. 2008; with
/// equal links it is ½·EI/l³·|x₋ − 2x + x₊|². It is quadratic: its Hessian is constant.
class Bends final : public Term {
 public:
  explicit Bends(const CordDef& def);

  void set_rest_lengths(std::span<const double> lengths) override;
  void add_constant(BandedMatrix& matrix) const override;
  void load(const NewtonSystem& system, std::span<const double> tensions) override;
  double potential(const Shape& shape, std::span<const double> max_tensions) const override;
  double energy(const Motion& motion, std::span<const double> tensions) const override;
  Vec2 force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const override;

 private:
  /// Around point k + 1: t₊ − t₋ = Σ weights[i]·x[k + i].
  struct Bend {
    double weights[3];  // 1/m
    double stiffness;   // N·m
  };
  double energy_at(std::span<const Vec2> x) const;
  /// Returns t₊ − t₋ at point k + 1.
  Vec2 turn(std::size_t k, std::span<const Vec2> x) const;

  double bending_stiffness_;  // N·m²
  double damping_;            // s
  std::vector<Bend> bends_;
};

}  // namespace ribbon
