#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/term.h"

namespace ribbon {

/// Bars along the middle line of a ribbon. A bar connects the middles of neighbouring columns:
/// the mean of the two middle points, or the middle point if the number of rows is odd. The cells get their stiffness
/// from EI, or from the definition if there are two rows; the spine adds the missing EA.
class Spine final : public Term {
 public:
  /// Creates the spine of a ribbon. `stiffness` is EA of the spine, N.
  Spine(const CordDef& def, double stiffness);

  std::size_t tension_count() const override { return rest_lengths_.size(); }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& motion, double sign, std::span<double> tensions) const override;
  void add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void load(const NewtonSystem& system, std::span<const double> tensions) override;
  void update(const NewtonSystem& system, std::span<const double> tensions, std::span<const Vec2> direction,
              std::span<double> next) const override;
  double potential(const Shape& shape, std::span<const double> max_tensions) const override;
  double energy(const Motion& motion, std::span<const double> tensions) const override;
  Vec2 force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const override;
  Vec2 section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const override;

 private:
  double rotational_extension(const Stage& stage, std::size_t e, Vec2 d) const;
  double rate(const Motion& motion, std::size_t e) const;
  Vec2 middle(std::span<const Vec2> x, std::size_t column) const;
  Vec2 bar_vector(std::span<const Vec2> x, std::size_t column) const {
    return middle(x, column + 1) - middle(x, column);
  }

  double compliance(std::size_t link) const { return rest_lengths_[link] * inverse_stiffness_; }

  std::size_t rows_;
  std::size_t low_;                   // row of the lower middle point
  std::size_t high_;                  // row of the upper middle point
  double inverse_stiffness_;          // 1/N
  double damping_;                    // s
  std::vector<double> rest_lengths_;  // m
};

}  // namespace ribbon
