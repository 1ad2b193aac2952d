#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/elasticity.h"
#include "ribbon/elastic/link.h"
#include "ribbon/linear/fetch.h"

namespace ribbon {

/// A rope without bending stiffness: a chain of bars, which may be inextensible. A Newton step costs O(points).
class Chain final : public Elasticity {
 public:
  explicit Chain(const CordDef& def);

  using Elasticity::tension_count;
  std::size_t tension_count() const override { return rest_lengths_.size(); }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& motion, double sign, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void leave_out(std::span<const char> links) override { left_out_.assign(links.begin(), links.end()); }
  void add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  bool newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                   std::span<Vec2> direction, std::span<double> next, std::span<EliminatedLink> eliminated) override;
  std::size_t dual_count() const override { return rest_lengths_.size(); }
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
  void fetch() const override { fetch_list(rest_lengths_); }
  bool become(const CordDef& def) override;

 private:
  /// The row of the next point that is eliminated: A·δ = r.
  struct PointRow {
    Block a;           ///< N/m
    Vec2 r;            ///< N
    double min_sigma;  ///< least σ, m/N
  };

  template <bool in_medium>
  void solve(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, std::span<Vec2> direction,
             std::span<double> next, std::span<EliminatedLink> eliminated) const;
  template <bool in_medium>
  EliminatedLink eliminate_point(const Stage& stage, std::span<const Vec2> x, std::size_t e, double last_tension,
                                 PointRow& row) const;
  bool is_left_out(std::size_t link) const { return !left_out_.empty() && left_out_[link] != 0; }
  void define(const CordDef& def);
  double compliance(std::size_t link) const { return rest_lengths_[link] * inverse_stiffness_; }
  double rotation_rate(const Stage& stage, std::size_t link, Vec2 d) const;
  double geometric(const Stage& stage, std::size_t link, double size, double tension) const;
  /// Returns a link in this stage: `size` [m] is its length, d its direction from point link + 1 to point link.
  MixedBar bar(const Stage& stage, std::span<const Vec2> x, std::size_t link, double size, Vec2 d) const {
    const MixedBar undamped{size - rest_lengths_[link], compliance(link)};
    return damping_ == 0.0 ? undamped : damped_bar(stage, x, link, undamped, d);
  }
  MixedBar damped_bar(const Stage& stage, std::span<const Vec2> x, std::size_t link, const MixedBar& undamped,
                      Vec2 d) const;

  double inverse_stiffness_ = 0.0;  // 1/EA, 1/N
  double damping_ = 0.0;            // s
  bool tension_only_ = false;
  std::vector<double> rest_lengths_;  // m
  std::vector<char> left_out_;        // by link; empty: none
};

}  // namespace ribbon
