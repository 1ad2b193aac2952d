#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/link.h"
#include "ribbon/elastic/term.h"

namespace ribbon {

/// Bars between points: those of a rope, or from each point of a ribbon to its up to eight neighbours, every one with
/// the stiffness EA/rows.
class Links final : public Term {
 public:
  explicit Links(const CordDef& def);

  std::size_t tension_count() const override { return links_.size(); }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& at, double sign, std::span<double> tensions) const override;
  void add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void load(const NewtonSystem& system, std::span<const double> tensions) override;
  void update(const NewtonSystem& system, std::span<const double> tensions, std::span<const Vec2> direction,
              std::span<double> next) const override;
  double misjudged_way(const Shape& shape, std::span<const double> tensions) const override;
  double potential(const Shape& shape, std::span<const double> most) const override;
  double energy(const Motion& at, std::span<const double> tensions) const override;

 private:
  struct Link {
    int a;  // < b
    int b;
    int column;
    bool along;     // to the next column
    double across;  // m
    double rest;    // m
  };
  struct Linearised {
    Vec2 d;
    double force;      // N
    double stiffness;  // N/m
    double across;     // N/m, the geometric stiffness
  };
  MixedBar bar(const Shape& shape, const Link& link, Vec2 d) const;
  double give(const Shape& shape, const Link& link) const {
    return 1.0 / shape.stage.inertia[static_cast<std::size_t>(link.a)];
  }
  Linearised linearise(const Shape& shape, const Link& link, double tension) const;
  void load_rope(const NewtonSystem& system, std::span<const double> tensions);
  double compliance(const Link& link) const { return link.rest * inverse_stiffness_; }

  double inverse_stiffness_;  // 1/N, 0 where inextensible
  double damping_;            // s
  bool tension_only_;
  std::vector<Link> links_;
  std::vector<Linearised> linearised_;  // as loaded last
};

}  // namespace ribbon
