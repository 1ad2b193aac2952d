#pragma once

#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/link.h"
#include "ribbon/elastic/term.h"
#include "ribbon/linear/index.h"

namespace ribbon {

/// Bars between points: the links of a rope, or bars from each point of a ribbon to each of its up to eight neighbours.
/// Each has the stiffness EA/rows.
class Links final : public Term {
 public:
  explicit Links(const CordDef& def);

  std::size_t tension_count() const override { return links_.size(); }
  void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const override;
  void add_damping(const Motion& motion, double sign, std::span<double> tensions) const override;
  void add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const override;
  void set_rest_lengths(std::span<const double> lengths) override;
  void load(const NewtonSystem& system, std::span<const double> tensions) override;
  void update(const NewtonSystem& system, std::span<const double> tensions, std::span<const Vec2> direction,
              std::span<double> next) const override;
  void append_bars(const Shape& shape, std::span<const double> tensions, std::vector<OneSidedBar>& bars) const override;
  double active_set_error(const Shape& shape, std::span<const double> tensions) const override;
  double potential(const Shape& shape, std::span<const double> max_tensions) const override;
  double energy(const Motion& motion, std::span<const double> tensions) const override;
  Vec2 force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const override;
  Vec2 section_force(std::size_t link, const Motion& motion, std::span<const double> tensions) const override;

 private:
  struct Link {
    int a;  // index of a point, below b
    int b;
    int column;          // of a
    bool along;          // b is in the next column
    double across;       // m, distance across the cord at rest
    double rest_length;  // m
  };
  struct Linearised {
    Vec2 d;
    double force;      // N
    double stiffness;  // N/m
    double across;     // N/m, geometric stiffness
  };
  static Vec2 vector(std::span<const Vec2> x, const Link& link) { return x[at(link.b)] - x[at(link.a)]; }
  double rotation_rate(const Stage& stage, const Link& link, Vec2 d) const;
  MixedBar bar(const Shape& shape, const Link& link, Vec2 d) const;
  double point_compliance(const Shape& shape, const Link& link) const { return 1.0 / shape.stage.inertia[at(link.a)]; }
  Linearised linearise(const Shape& shape, const Link& link, double tension) const;
  void load_rope(const NewtonSystem& system, std::span<const double> tensions);
  double compliance(const Link& link) const { return link.rest_length * inverse_stiffness_; }

  double inverse_stiffness_;  // 1/N, 0 if inextensible
  double damping_;            // s
  bool tension_only_;
  std::size_t column_links_;  // across a column and from it to the next one; as many for each column but the last
  std::vector<Link> links_;
  std::vector<Linearised> linearised_;  // of the last load
};

}  // namespace ribbon
