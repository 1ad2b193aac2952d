#pragma once

#include <memory>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/elasticity.h"
#include "ribbon/elastic/term.h"
#include "ribbon/linear/banded_ldlt.h"

namespace ribbon {

/// The elastic terms of a cord with more than a chain of bars: a rope with bending stiffness, or a ribbon. Tensions are
/// eliminated first. The system of the points is banded, with a half bandwidth of 5 for a rope and 2·rows + 3 for a
/// ribbon; a Newton step costs O(points · rows²).
class Lattice final : public Elasticity {
 public:
  explicit Lattice(const CordDef& def);

  std::size_t tension_count() const override { return tension_count_; }
  std::size_t terms() const override { return terms_.size(); }
  std::size_t tension_count(std::size_t term) const override { return terms_[term]->tension_count(); }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& motion, double sign, std::span<double> tensions) const override;
  void add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  bool newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                   std::span<Vec2> direction, std::span<double> next, std::span<EliminatedLink> eliminated) override;
  void order(int first, int first_dual, std::vector<int>& slots, const PointCallback& on_point) const override;
  void couple(BlockLdlt& blocks, int first, int first_dual) const override;
  void load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks, int first,
            int first_dual, std::span<Vec2> right_side) override;
  void update(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
              std::span<const Vec2> direction, std::span<const Vec2> duals, std::span<double> next) override;
  void append_bars(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                   std::vector<OneSidedBar>& bars) override;
  double active_set_error(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) override;
  double potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> max_tensions) override;
  double energy(const Motion& motion, std::span<const double> tensions) const override;
  Vec2 force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const override;
  Vec2 section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const override;
  bool unlock(std::span<const Vec2> x) override;
  std::span<char> unlocked() override;
  void lock() override;
  bool has_deep_inversion(std::span<const Vec2> x) const override;

 private:
  /// Calls visit(term, first, count) for each term, which has the tensions first … first + count − 1.
  template <typename Visit>
  void for_each_term(Visit&& visit) const {
    std::size_t first = 0;
    for (const auto& term : terms_) {
      const std::size_t count = term->tension_count();
      visit(*term, first, count);
      first += count;
    }
  }
  void assemble(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, std::span<Vec2> force);
  Shape shape(const Stage& stage, std::span<const Vec2> x);
  /// Returns the shape that was evaluated last.
  Shape last_shape(const Stage& stage, std::span<const Vec2> x) const;
  void hold_constrained(const Stage& stage, std::span<Vec2> force);
  bool solve(std::span<Vec2> residual);

  double damping_;  // s
  bool tension_only_;
  int reach_;  // a point is coupled with this many points after it
  std::vector<std::unique_ptr<Term>> terms_;
  std::size_t tension_count_ = 0;
  BandedMatrix constant_;   // part of the Hessian that depends on rest lengths only
  BandedMatrix stiffened_;  // stiffening_ · constant_, unless stiffening_ is 0
  double stiffening_ = 0.0;
  BandedMatrix matrix_;
  BandedLdlt solver_;
  std::vector<Vec2> damped_;  // m, x + β·v; empty without damping
  std::vector<double> right_side_;
};

}  // namespace ribbon
