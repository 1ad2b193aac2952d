#include "ribbon/elastic/chain.h"

#include <algorithm>
#include <cmath>

#include "ribbon/elastic/link.h"

namespace ribbon {

Chain::Chain(const CordDef& def)
    : inverse_stiffness_(1.0 / def.stretch_stiffness),
      damping_(inverse_stiffness_ > 0.0 ? def.damping : 0.0),
      tension_only_(def.tension_only),
      rest_(static_cast<std::size_t>(def.points) - 1),
      eliminated_(rest_.size()) {}

void Chain::set_rest_lengths(std::span<const double> lengths) {
  std::copy(lengths.begin(), lengths.end(), rest_.begin());
}

void Chain::find_tensions(std::span<const Vec2> x, std::span<double> tensions) const {
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    tensions[e] = static_tension({length(x[e + 1] - x[e]) - rest_[e], compliance(e)}, tension_only_);
  }
}

void Chain::add_damping(const Motion& at, double sign, std::span<double> tensions) const {
  if (damping_ == 0.0) return;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    if (tension_only_ && tensions[e] == 0.0) continue;
    tensions[e] += sign * damping_ * extension_rate(at, e, e + 1) / compliance(e);
  }
}

void Chain::add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const {
  if (damping_ == 0.0) return;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const Vec2 ab = x[e] - x[e + 1];
    const double size = length(ab);
    if (size == 0.0 || (tension_only_ && tensions[e] == 0.0)) continue;
    tensions[e] +=
        damping_ * turning_rate(stage, stage.start(e) - stage.start(e + 1), (1.0 / size) * ab) / compliance(e);
  }
}

MixedBar Chain::bar(const Stage& stage, std::span<const Vec2> x, std::size_t link, double size, Vec2 d) const {
  const MixedBar undamped{size - rest_[link], compliance(link)};
  if (damping_ == 0.0) return undamped;
  const double rate = dot(d, stage.velocity_at(link, x[link]) - stage.velocity_at(link + 1, x[link + 1])) -
                      turning_rate(stage, stage.start(link) - stage.start(link + 1), d);
  return damped(undamped.elongation, rate, undamped.compliance, damping_, stage.q);
}

/// g of a link that is not slack.
double Chain::geometric(const Stage& stage, std::size_t link, double size, double tension) const {
  if (size == 0.0) return 0.0;
  return std::max(tension / size, stage.least_geometric * std::min(stage.inertia[link], stage.inertia[link + 1]));
}

/// The tension λ of each link is an unknown of its own, so that stiffness does not enter, and EA → ∞ is no special
/// case. For a link from a to b, d the unit vector from a to b, u = perp(d), L its length, α its compliance, c its
/// elongation, g = max(0, λ)/L with the λ of the iteration before:
///
///     A_a·δa − g·u·uᵀ·δb − d·λ = r_a         (A_a and A_b hold the link's own g·u·uᵀ)
///     A_b·δb − g·u·uᵀ·δa + d·λ = r_b
///     dᵀ(δb − δa) − α·λ = −c
///
/// Points are eliminated one by one from the cord's last to its first. With S = A_a⁻¹, p = d − g·(uᵀSd)·u and
/// σ = α + dᵀSd:
///
///     λ = (c − dᵀS·r_a + pᵀδb)/σ             δa = S(r_a + d·λ + g·u·uᵀδb)
///     A_b ← A_b − g²·(uᵀSu)·u·uᵀ + p·pᵀ/σ    r_b ← r_b + g·(uᵀS·r_a)·u − p·(c − dᵀS·r_a)/σ
///
/// A constrained point has S = 0, a slack link 1/σ = 0.
bool Chain::newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                        std::span<Vec2> direction, std::span<double> next) {
  const double least_sigma = singular_share / stage.inertia[0];
  const std::size_t n = x.size();
  Block a{stage.inertia[n - 1], 0.0, stage.inertia[n - 1]};  // A and r of the point that is eliminated next
  Vec2 r = stage.residual(n - 1, x[n - 1]);
  std::size_t carried = stage.carried.size();
  const auto carry = [&](std::size_t point) {
    while (carried > 0 && stage.carried[carried - 1].point == point) {
      --carried;
      a = a + stage.carried[carried].stiffness;
      r += stage.carried[carried].residual;
    }
  };
  carry(n - 1);

  for (std::size_t e = n - 1; e-- > 0;) {  // from point a = e + 1 to b = e
    const Vec2 ab = x[e] - x[e + 1];
    const double size = length(ab);
    const Vec2 d = size > 0.0 ? (1.0 / size) * ab : Vec2{0.0, 1.0};
    const Vec2 u = perp(d);
    const MixedBar mixed = bar(stage, x, e, size, d);
    const bool slack = tension_only_ && is_slack(mixed, tensions[e], 1.0 / stage.inertia[e], size);
    const double g = slack ? 0.0 : geometric(stage, e, size, tensions[e]);
    a.xx += g * u.x * u.x;
    a.xy += g * u.x * u.y;
    a.yy += g * u.y * u.y;
    const double inverse_det = stage.constrained[e + 1] != 0 ? 0.0 : 1.0 / (a.xx * a.yy - a.xy * a.xy);
    const auto s = [&](Vec2 v) { return inverse_det * Vec2{a.yy * v.x - a.xy * v.y, a.xx * v.y - a.xy * v.x}; };
    const Vec2 sd = s(d);
    const Vec2 su = s(u);
    const Vec2 sr = s(r);
    const double inverse_sigma = slack ? 0.0 : 1.0 / std::max(mixed.compliance + dot(d, sd), least_sigma);
    const Vec2 p = d - (g * dot(u, sd)) * u;
    const double tension = (mixed.elongation - dot(d, sr)) * inverse_sigma;
    const Vec2 slope = inverse_sigma * p;
    eliminated_[e] = {tension, slope, sr + tension * sd, (g * su.x) * u + sd.x * slope, (g * su.y) * u + sd.y * slope};

    const double across = g * (1.0 - g * dot(u, su));
    a.xx = stage.inertia[e] + across * u.x * u.x + p.x * slope.x;
    a.xy = without_dust(across * u.x * u.y + p.x * slope.y);
    a.yy = stage.inertia[e] + across * u.y * u.y + p.y * slope.y;
    r = without_dust(stage.residual(e, x[e]) + (g * dot(u, sr)) * u - tension * p);
    carry(e);
  }

  direction[0] = {};
  if (stage.constrained[0] == 0) {
    direction[0] = (1.0 / (a.xx * a.yy - a.xy * a.xy)) * Vec2{a.yy * r.x - a.xy * r.y, a.xx * r.y - a.xy * r.x};
  }
  for (std::size_t e = 0; e + 1 < n; ++e) {
    const Eliminated& link = eliminated_[e];
    const Vec2 before = direction[e];
    next[e] = link.tension + dot(link.slope, before);
    direction[e + 1] = link.shift + Vec2{dot(link.turn_x, before), dot(link.turn_y, before)};
  }
  return true;
}

/// A tension after both its points, so that one of them that is constrained leaves it something to act on.
void Chain::order(int first, int first_dual, std::vector<int>& slots, const PointDone& point_done) const {
  slots.push_back(first);
  point_done(first);
  for (int e = 0; e < static_cast<int>(rest_.size()); ++e) {
    slots.push_back(first + e + 1);
    point_done(first + e + 1);
    slots.push_back(first_dual + e);
  }
}

void Chain::couple(BlockLdlt& blocks, int first, int first_dual) const {
  for (int e = 0; e < static_cast<int>(rest_.size()); ++e) {
    blocks.couple(first + e, first + e + 1);
    blocks.couple(first + e, first_dual + e);
    blocks.couple(first + e + 1, first_dual + e);
  }
}

/// The same equations as in newton_step.
void Chain::load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks,
                 int first, int first_dual, std::span<Vec2> right_side) {
  const double least = dual_share / stage.inertia[0];
  for (std::size_t p = 0; p < x.size(); ++p) {
    right_side[static_cast<std::size_t>(first) + p] = stage.residual(p, x[p]);
    blocks.add(first + static_cast<int>(p), stage.inertia[p], 0.0, stage.inertia[p]);
  }
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const int a = first + static_cast<int>(e);
    const int b = a + 1;
    const int dual = first_dual + static_cast<int>(e);
    const Vec2 ab = x[e + 1] - x[e];
    const double size = length(ab);
    const Vec2 d = size > 0.0 ? (1.0 / size) * ab : Vec2{0.0, -1.0};
    const Vec2 u = perp(d);
    const MixedBar mixed = bar(stage, x, e, size, -d);
    blocks.make_dual(dual);
    right_side[static_cast<std::size_t>(dual)] = {};
    if (tension_only_ && is_slack(mixed, tensions[e], 1.0 / stage.inertia[e], size)) {
      blocks.add(dual, -1.0, 0.0, -1.0);
      continue;
    }
    const double g = geometric(stage, e, size, tensions[e]);
    blocks.add(a, g * u.x * u.x, g * u.x * u.y, g * u.y * u.y);
    blocks.add(b, g * u.x * u.x, g * u.x * u.y, g * u.y * u.y);
    blocks.add(a, b, -g * u.x * u.x, -g * u.x * u.y, -g * u.x * u.y, -g * u.y * u.y);
    blocks.add(a, dual, -d.x, 0.0, -d.y, 0.0);
    blocks.add(b, dual, d.x, 0.0, d.y, 0.0);
    blocks.add(dual, -std::max(mixed.compliance, least), 0.0, -1.0);
    right_side[static_cast<std::size_t>(dual)] = {-mixed.elongation, 0.0};
  }
}

void Chain::update(const Stage& /*stage*/, std::span<const Vec2> /*x*/, std::span<const double> /*tensions*/,
                   std::span<const Vec2> /*direction*/, std::span<const Vec2> duals, std::span<double> next) {
  for (std::size_t e = 0; e < rest_.size(); ++e) next[e] = duals[e].x;
}

double Chain::misjudged_way(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) {
  double most = 0.0;
  for (std::size_t e = 0; tension_only_ && e < rest_.size(); ++e) {
    if (tensions[e] > 0.0) continue;  // taut, and pulls
    const Vec2 ab = x[e] - x[e + 1];
    const double size = length(ab);
    const MixedBar mixed = bar(stage, x, e, size, size > 0.0 ? (1.0 / size) * ab : Vec2{});
    most = std::max(most, ribbon::misjudged_way(mixed, tensions[e], 1.0 / stage.inertia[e]));
  }
  return most;
}

double Chain::potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> most) {
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    const Vec2 ab = x[e] - x[e + 1];
    const double size = length(ab);
    const MixedBar mixed = bar(stage, x, e, size, size > 0.0 ? (1.0 / size) * ab : Vec2{});
    if (!(tension_only_ && mixed.elongation <= 0.0)) sum += exact_penalty(mixed, most[e]);
  }
  return sum;
}

double Chain::energy(const Motion& at, std::span<const double> tensions) const {
  if (inverse_stiffness_ == 0.0) return 0.0;
  double sum = 0.0;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    double rate = 0.0;
    if (damping_ > 0.0 && tensions[e] != 0.0) rate = extension_rate(at, e, e + 1);
    sum += elastic_energy(tensions[e], compliance(e), damping_, rate);
  }
  return sum;
}

}  // namespace ribbon
