#include "ribbon/elastic/chain.h"

#include <algorithm>
#include <cmath>

#include "ribbon/elastic/link.h"
#include "ribbon/linear/index.h"

namespace ribbon {

Chain::Chain(const CordDef& def) { define(def); }

bool Chain::become(const CordDef& def) {
  define(def);
  return true;
}

void Chain::define(const CordDef& def) {
  inverse_stiffness_ = 1.0 / def.stretch_stiffness;
  damping_ = inverse_stiffness_ > 0.0 ? def.damping : 0.0;
  tension_only_ = def.tension_only;
  rest_lengths_.assign(at(def.points) - 1, 0.0);
}

void Chain::set_rest_lengths(std::span<const double> lengths) {
  std::copy(lengths.begin(), lengths.end(), rest_lengths_.begin());
}

void Chain::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    if (!is_left_out(e))
      tensions[e] = static_tension({length(x[e + 1] - x[e]) - rest_lengths_[e], compliance(e)}, tension_only_);
  }
}

void Chain::add_damping(const Motion& motion, double sign, std::span<double> tensions) const {
  if (damping_ == 0.0) return;
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    if (is_left_out(e) || (tension_only_ && tensions[e] == 0.0)) continue;
    tensions[e] += sign * damping_ * extension_rate(motion, e, e + 1) / compliance(e);
  }
}

void Chain::add_rotational_damping(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  if (damping_ == 0.0) return;
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    const Vec2 ab = x[e] - x[e + 1];
    const double size = length(ab);
    if (size == 0.0 || is_left_out(e) || (tension_only_ && tensions[e] == 0.0)) continue;
    tensions[e] += damping_ * rotation_rate(stage, e, (1.0 / size) * ab) / compliance(e);
  }
}

double Chain::rotation_rate(const Stage& stage, std::size_t link, Vec2 d) const {
  return rotational_extension_rate(stage, stage.start(link) - stage.start(link + 1), d);
}

MixedBar Chain::damped_bar(const Stage& stage, std::span<const Vec2> x, std::size_t link, const MixedBar& undamped,
                           Vec2 d) const {
  const double rate = dot(d, stage.velocity_at(link, x[link]) - stage.velocity_at(link + 1, x[link + 1])) -
                      rotation_rate(stage, link, d);
  return damped(undamped.elongation, rate, undamped.compliance, damping_, stage.q);
}

/// Returns the geometric stiffness g [N/m] of a link that is not slack.
double Chain::geometric(const Stage& stage, std::size_t link, double size, double tension) const {
  if (size == 0.0) return 0.0;
  return std::max(tension / size, stage.min_geometric_ratio * std::min(stage.inertia[link], stage.inertia[link + 1]));
}

/// The tension λ of each link is an unknown. So the stiffness does not appear in the system, and EA → ∞ is no special
/// case. For a link from a to b, with the unit vector d from a to b, u = perp(d), length L, compliance α, elongation c,
/// and g = max(0, λ)/L with the λ of the last iteration:
///
///     A_a·δa − g·u·uᵀ·δb − d·λ = r_a         (A_a and A_b include the link's own g·u·uᵀ)
///     A_b·δb − g·u·uᵀ·δa + d·λ = r_b
///     dᵀ(δb − δa) − α·λ = −c
///
/// Points are eliminated one by one from the last to the first. With S = A_a⁻¹, p = d − g·(uᵀSd)·u and σ = α + dᵀSd:
///
///     λ = (c − dᵀS·r_a + pᵀδb)/σ             δa = S(r_a + d·λ + g·u·uᵀδb)
///     A_b ← A_b − g²·(uᵀSu)·u·uᵀ + p·pᵀ/σ    r_b ← r_b + g·(uᵀS·r_a)·u − p·(c − dᵀS·r_a)/σ
///
/// A constrained point has S = 0, a slack link 1/σ = 0. Substitution in the opposite order gives all δ and λ.
/// This eliminates point a = e + 1, and makes `row` that of point b = e.
template <bool in_medium>
[[gnu::always_inline]] inline EliminatedLink Chain::eliminate_point(const Stage& stage, std::span<const Vec2> x,
                                                                    std::size_t e, double last_tension,
                                                                    PointRow& row) const {
  Block& a = row.a;
  Vec2& r = row.r;
  const Vec2 ab = x[e] - x[e + 1];
  const double size = length(ab);
  const Vec2 d = unit_or(ab, size, {0.0, 1.0});
  const Vec2 u = perp(d);
  const MixedBar mixed = bar(stage, x, e, size, d);
  const bool slack = tension_only_ && is_slack(mixed, last_tension, 1.0 / stage.inertia[e], size);
  const double g = slack ? 0.0 : geometric(stage, e, size, last_tension);
  a.xx += g * u.x * u.x;
  a.xy += g * u.x * u.y;
  a.yy += g * u.y * u.y;
  const double inverse_det = stage.constrained[e + 1] != 0 ? 0.0 : 1.0 / (a.xx * a.yy - a.xy * a.xy);
  const auto s = [&](Vec2 v) { return inverse_det * Vec2{a.yy * v.x - a.xy * v.y, a.xx * v.y - a.xy * v.x}; };
  const Vec2 sd = s(d);
  const Vec2 su = s(u);
  const Vec2 sr = s(r);
  const double inverse_sigma = slack ? 0.0 : 1.0 / std::max(mixed.compliance + dot(d, sd), row.min_sigma);
  const Vec2 p = d - (g * dot(u, sd)) * u;
  const double tension = (mixed.elongation - dot(d, sr)) * inverse_sigma;
  const Vec2 slope = inverse_sigma * p;

  const double across = g * (1.0 - g * dot(u, su));
  a.xx = stage.inertia[e] + across * u.x * u.x + p.x * slope.x;
  a.xy = without_dust(across * u.x * u.y + p.x * slope.y);
  a.yy = stage.inertia[e] + across * u.y * u.y + p.y * slope.y;
  const Vec2 residual = in_medium ? stage.residual(e, x[e]) : stage.residual_without_medium(e, x[e]);
  r = without_dust(residual + (g * dot(u, sr)) * u - tension * p);
  return {tension, slope, sr + tension * sd, (g * su.x) * u + sd.x * slope, (g * su.y) * u + sd.y * slope};
}

bool Chain::newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                        std::span<Vec2> direction, std::span<double> next, std::span<EliminatedLink> eliminated) {
  if (stage.resistance.empty()) {
    solve<false>(stage, x, tensions, direction, next, eliminated);
  } else {
    solve<true>(stage, x, tensions, direction, next, eliminated);
  }
  return true;
}

/// Without a medium the elimination, of which each point waits for the one before, does not even ask for it.
template <bool in_medium>
void Chain::solve(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                  std::span<Vec2> direction, std::span<double> next, std::span<EliminatedLink> eliminated) const {
  const std::size_t n = x.size();
  PointRow row{{stage.inertia[n - 1], 0.0, stage.inertia[n - 1]},
               stage.residual(n - 1, x[n - 1]),
               min_singular_compliance / stage.inertia[0]};
  std::size_t bodies = stage.condensed_bodies.size();
  const auto add_others = [&](std::size_t point) {
    if (in_medium) row.a = row.a + stage.resistance[point];
    while (bodies > 0 && stage.condensed_bodies[bodies - 1].point == point) {
      --bodies;
      row.a = row.a + stage.condensed_bodies[bodies].stiffness;
      row.r += stage.condensed_bodies[bodies].residual;
    }
  };
  add_others(n - 1);
  for (std::size_t e = n - 1; e-- > 0;) {
    eliminated[e] = eliminate_point<in_medium>(stage, x, e, tensions[e], row);
    add_others(e);
  }

  direction[0] = {};
  if (stage.constrained[0] == 0) {
    const auto& [a, r, min_sigma] = row;
    direction[0] = (1.0 / (a.xx * a.yy - a.xy * a.xy)) * Vec2{a.yy * r.x - a.xy * r.y, a.xx * r.y - a.xy * r.x};
  }
  for (std::size_t e = 0; e + 1 < n; ++e) {
    const EliminatedLink& link = eliminated[e];
    const Vec2 near = direction[e];
    next[e] = link.tension + dot(link.slope, near);
    direction[e + 1] = link.shift + Vec2{dot(link.matrix_x, near), dot(link.matrix_y, near)};
  }
}

/// A tension follows both of its points: so its pivot is not 0 if one of them is constrained.
void Chain::order(int first, int first_dual, std::vector<int>& slots, const PointCallback& on_point) const {
  slots.push_back(first);
  on_point(first);
  for (int e = 0; e < static_cast<int>(rest_lengths_.size()); ++e) {
    slots.push_back(first + e + 1);
    on_point(first + e + 1);
    slots.push_back(first_dual + e);
  }
}

void Chain::couple(BlockLdlt& blocks, int first, int first_dual) const {
  for (int e = 0; e < static_cast<int>(rest_lengths_.size()); ++e) {
    blocks.couple(first + e, first + e + 1);
    blocks.couple(first + e, first_dual + e);
    blocks.couple(first + e + 1, first_dual + e);
  }
}

/// Adds the equations of newton_step.
void Chain::load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks,
                 int first, int first_dual, std::span<Vec2> right_side) {
  const double min_compliance = min_dual_compliance / stage.inertia[0];
  const double proximal_compliance = stage.is_proximal ? min_proximal_compliance / stage.inertia[0] : 0.0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    right_side[at(first) + p] = stage.residual(p, x[p]);
    blocks.add(first + static_cast<int>(p), stage.inertia[p], 0.0, stage.inertia[p]);
    if (stage.resistance.empty()) continue;
    const Block& resistance = stage.resistance[p];
    blocks.add(first + static_cast<int>(p), resistance.xx, resistance.xy, resistance.yy);
  }
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    const int a = first + static_cast<int>(e);
    const int b = a + 1;
    const int dual = first_dual + static_cast<int>(e);
    const Vec2 ab = x[e + 1] - x[e];
    const double size = length(ab);
    const Vec2 d = unit_or(ab, size, {0.0, -1.0});
    const Vec2 u = perp(d);
    const MixedBar mixed = bar(stage, x, e, size, -d);
    blocks.make_scalar_dual(dual);
    right_side[at(dual)] = {};
    const bool is_row = tension_only_ && stage.bars_are_rows;
    const bool slack = tension_only_ && !is_row && is_slack(mixed, tensions[e], 1.0 / stage.inertia[e], size);
    if (is_left_out(e) || slack) {
      blocks.add(dual, -1.0, 0.0, -1.0);
      continue;
    }
    const double g = geometric(stage, e, size, tensions[e]);
    blocks.add(a, g * u.x * u.x, g * u.x * u.y, g * u.y * u.y);
    blocks.add(b, g * u.x * u.x, g * u.x * u.y, g * u.y * u.y);
    blocks.add(a, b, -g * u.x * u.x, -g * u.x * u.y, -g * u.x * u.y, -g * u.y * u.y);
    if (is_row) {
      blocks.add(dual, -1.0, 0.0, -1.0);
      continue;
    }
    blocks.add(a, dual, -d.x, 0.0, -d.y, 0.0);
    blocks.add(b, dual, d.x, 0.0, d.y, 0.0);
    const MixedBar solved = proximal(mixed, proximal_compliance, tensions[e]);
    blocks.add(dual, -std::max(solved.compliance, min_compliance), 0.0, -1.0);
    right_side[at(dual)] = {-solved.elongation, 0.0};
  }
}

void Chain::update(const Stage& /*stage*/, std::span<const Vec2> /*x*/, std::span<const double> tensions,
                   std::span<const Vec2> /*direction*/, std::span<const Vec2> duals, std::span<double> next) {
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) next[e] = is_left_out(e) ? tensions[e] : duals[e].x;
}

void Chain::append_bars(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                        std::vector<OneSidedBar>& bars) {
  for (std::size_t e = 0; tension_only_ && e < rest_lengths_.size(); ++e) {
    if (is_left_out(e)) continue;
    const Vec2 ab = x[e + 1] - x[e];
    const double size = length(ab);
    const Vec2 d = unit_or(ab, size, {0.0, -1.0});
    bars.push_back(one_sided(e, d, bar(stage, x, e, size, -d), tensions[e], 1.0 / stage.inertia[e], size));
  }
}

double Chain::active_set_error(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) {
  double largest = 0.0;
  for (std::size_t e = 0; tension_only_ && e < rest_lengths_.size(); ++e) {
    if (is_left_out(e) || tensions[e] > 0.0) continue;  // under tension, as assumed
    const Vec2 ab = x[e] - x[e + 1];
    const double size = length(ab);
    const MixedBar mixed = bar(stage, x, e, size, unit_or(ab, size, {}));
    largest = std::max(largest, ribbon::active_set_error(mixed, tensions[e], 1.0 / stage.inertia[e]));
  }
  return largest;
}

double Chain::potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> max_tensions) {
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    const Vec2 ab = x[e] - x[e + 1];
    const double size = length(ab);
    const MixedBar mixed = bar(stage, x, e, size, unit_or(ab, size, {}));
    if (!is_left_out(e) && !(tension_only_ && mixed.elongation <= 0.0)) sum += exact_penalty(mixed, max_tensions[e]);
  }
  return sum;
}

double Chain::energy(const Motion& motion, std::span<const double> tensions) const {
  if (inverse_stiffness_ == 0.0) return 0.0;
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_lengths_.size(); ++e) {
    if (is_left_out(e)) continue;
    const auto rate = [&] { return extension_rate(motion, e, e + 1); };
    const auto elongation = [&] { return length(motion.x[e + 1] - motion.x[e]) - rest_lengths_[e]; };
    sum += damped_elastic_energy(tensions[e], compliance(e), damping_, tension_only_, rate, elongation);
  }
  return sum;
}

Vec2 Chain::force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const {
  const auto pull_towards = [&](std::size_t other, double tension) {
    const Vec2 to_other = motion.x[other] - motion.x[point];
    return tension * unit_or(to_other, length(to_other), {});
  };
  Vec2 force{};
  if (point > 0) force += pull_towards(point - 1, tensions[point - 1]);
  if (point < tensions.size()) force += pull_towards(point + 1, tensions[point]);
  return force;
}

}  // namespace ribbon
