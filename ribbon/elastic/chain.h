#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/elasticity.h"
#include "ribbon/elastic/link.h"

namespace ribbon {

/// A rope of bars alone. They may be inextensible.
class Chain final : public Elasticity {
 public:
  explicit Chain(const CordDef& def);

  std::size_t tension_count() const override { return rest_.size(); }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& at, double sign, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  bool newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                   std::span<Vec2> direction, std::span<double> next) override;
  std::size_t dual_count() const override { return rest_.size(); }
  void order(int first, int first_dual, std::vector<int>& slots, const PointDone& point_done) const override;
  void couple(BlockLdlt& blocks, int first, int first_dual) const override;
  void load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks, int first,
            int first_dual, std::span<Vec2> right_side) override;
  void update(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
              std::span<const Vec2> direction, std::span<const Vec2> duals, std::span<double> next) override;
  double misjudged_way(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) override;
  double potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> most) override;
  double energy(const Motion& at, std::span<const double> tensions) const override;

 private:
  /// What the elimination keeps of a link for the substitution: how its tension and its further end follow from the
  /// step δb of the end before it, λ = tension + slope·δb, δa = shift + turn·δb.
  struct Eliminated {
    double tension;
    Vec2 slope;
    Vec2 shift;
    Vec2 turn_x;  // the first row of the matrix, and
    Vec2 turn_y;  // the second
  };

  double compliance(std::size_t link) const { return rest_[link] * inverse_stiffness_; }
  double geometric(const Stage& stage, std::size_t link, double size, double tension) const;
  MixedBar bar(const Stage& stage, std::span<const Vec2> x, std::size_t link, double size, Vec2 d) const;

  double inverse_stiffness_;  // 1/EA, 1/N
  double damping_;            // s
  bool tension_only_;
  std::vector<double> rest_;  // m
  std::vector<Eliminated> eliminated_;
};

}  // namespace ribbon
