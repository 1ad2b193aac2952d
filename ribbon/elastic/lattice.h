#pragma once

#include <memory>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/elasticity.h"
#include "ribbon/elastic/term.h"
#include "ribbon/linear/banded_ldlt.h"

namespace ribbon {

/// The terms that a cord declares, where a chain of bars is not all: a rope that bends, a ribbon. Tensions are
/// eliminated first, and the points' system is a band, half 5 wide for a rope and 2·rows + 3 for a ribbon.
class Lattice final : public Elasticity {
 public:
  explicit Lattice(const CordDef& def);

  std::size_t tension_count() const override { return tension_count_; }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& at, double sign, std::span<double> tensions) const override;
  void add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  bool newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                   std::span<Vec2> direction, std::span<double> next) override;
  void order(int first, int first_dual, std::vector<int>& slots, const PointDone& point_done) const override;
  void couple(BlockLdlt& blocks, int first, int first_dual) const override;
  void load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks, int first,
            int first_dual, std::span<Vec2> right_side) override;
  void update(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
              std::span<const Vec2> direction, std::span<const Vec2> duals, std::span<double> next) override;
  double misjudged_way(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) override;
  double potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> most) override;
  double energy(const Motion& at, std::span<const double> tensions) const override;
  bool unlock(std::span<const Vec2> x) override;
  std::span<char> unlocked() override;

 private:
  void assemble(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, std::span<Vec2> force);
  Shape shape(const Stage& stage, std::span<const Vec2> x);
  /// The same where it was evaluated last.
  Shape last_shape(const Stage& stage, std::span<const Vec2> x) const;
  void hold_constrained(const Stage& stage, std::span<Vec2> force);
  bool solve(std::span<Vec2> residual);

  double damping_;  // s
  bool tension_only_;
  int reach_;  // how many points further than a point are coupled with it
  std::vector<std::unique_ptr<Term>> terms_;
  std::size_t tension_count_ = 0;
  BandedMatrix constant_;   // the Hessian's part that only rest lengths change
  BandedMatrix stiffened_;  // the same times stiffening_, if that is not 0
  double stiffening_ = 0.0;
  BandedMatrix matrix_;
  BandedLdlt solver_;
  std::vector<Vec2> damped_;  // x + β·v, if damping is declared
  std::vector<double> right_side_;
};

}  // namespace ribbon
