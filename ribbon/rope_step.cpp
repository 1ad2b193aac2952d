#include <algorithm>
#include <cassert>
#include <cmath>

#include "ribbon/rope.h"

namespace ribbon {
namespace {

constexpr int fallback_iterations = 40;
// Least give σ of a link between two constrained points, as a share of what a free point of the cord would give: an
// inextensible link there has none at all.
constexpr double least_give = 1e-10;

}  // namespace

RopeReport Rope::step(double dt, Vec2 gravity) {
  assert(dt > 0.0 && dt <= 1.0 && is_finite(gravity));
  RopeReport report;
  gravity_ = gravity;
  starts_ = positions_;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (is_constrained(p)) velocities_[p] = (1.0 / dt) * (targets_[p] - starts_[p]);
  }
  const double substep_dt = dt / def_.substeps;
  for (int n = 0; n < def_.substeps; ++n) {
    x0_ = positions_;
    v0_ = velocities_;
    tension0_ = tensions_;
    substep(substep_dt, report);
  }
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (is_constrained(p)) positions_[p] = targets_[p];  // to the last bit
  }
  return report;
}

/// The integrator that the state allows; where Newton does not converge, implicit Euler from the start of the substep.
void Rope::substep(double dt, RopeReport& report) {
  const bool converged = restart_ ? sdirk2(dt, report) : tr_bdf2(dt, report);
  restart_ = false;
  if (converged) return;
  ++report.fallbacks;
  positions_ = x0_;
  velocities_ = v0_;
  tensions_ = tension0_;
  if (!implicit_euler(dt, report)) ++report.unconverged;
  restart_ = true;  // its acceleration is one of first order
}

// Every stage has the form x = x̃ + q²·a, v = ṽ + q·a, M·a = forces at x; x̃ is called predicted_ and ṽ velocity_.

/// Trapezoidal rule over γ·dt, then BDF2 over the whole, γ = 2 − √2, which gives both the same q = γ·dt/2 (Hosea &
/// Shampine 1996).
bool Rope::tr_bdf2(double dt, RopeReport& report) {
  const double gamma = 2.0 - std::sqrt(2.0);
  const double q = 0.5 * gamma * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p] + q * accelerations_[p];
    predicted_[p] = x0_[p] + q * (v0_[p] + velocity_[p]);
    positions_[p] = predicted_[p] + (q * q) * accelerations_[p];
  }
  place_constrained(gamma * dt);
  if (!solve_stage(q, def_.max_iterations, report)) return false;
  accept(q, velocity_);
  x1_ = positions_;
  v1_ = velocities_;

  const double c1 = 1.0 / (gamma * (2.0 - gamma));
  const double c0 = (1.0 - gamma) * (1.0 - gamma) * c1;
  const double rest = (1.0 - gamma) * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = c1 * v1_[p] - c0 * v0_[p];
    predicted_[p] = c1 * x1_[p] - c0 * x0_[p] + q * velocity_[p];
    positions_[p] = x1_[p] + rest * v1_[p] + (0.5 * rest * rest) * accelerations_[p];
  }
  place_constrained(dt);
  if (!solve_stage(q, def_.max_iterations, report)) return false;
  accept(q, velocity_);
  return true;
}

/// Two implicit stages at γ·dt and dt, γ = 1 − 1/√2, stiffly accurate (Alexander 1977).
bool Rope::sdirk2(double dt, RopeReport& report) {
  const double gamma = 1.0 - 1.0 / std::sqrt(2.0);
  const double q = gamma * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p];
    predicted_[p] = x0_[p] + q * velocity_[p];
    positions_[p] = predicted_[p];
  }
  place_constrained(q);
  if (!solve_stage(q, def_.max_iterations, report)) return false;
  accept(q, velocity_);
  v1_ = velocities_;

  const double rest = (1.0 - gamma) * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p] + rest * accelerations_[p];
    predicted_[p] = x0_[p] + rest * v1_[p] + q * velocity_[p];
    positions_[p] = predicted_[p];
  }
  place_constrained(dt);
  if (!solve_stage(q, def_.max_iterations, report)) return false;
  accept(q, velocity_);
  return true;
}

bool Rope::implicit_euler(double dt, RopeReport& report) {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p];
    predicted_[p] = x0_[p] + dt * velocity_[p];
    positions_[p] = predicted_[p];
  }
  place_constrained(dt);
  const bool converged = solve_stage(dt, fallback_iterations, report);
  accept(dt, velocity_);
  return converged;
}

/// Constrained points go evenly from where the step found them to their targets; `time` is that since the start of the
/// substep.
void Rope::place_constrained(double time) {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (is_constrained(p)) positions_[p] = x0_[p] + time * v0_[p];
  }
}

void Rope::accept(double q, std::span<const Vec2> velocity_guess) {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (is_constrained(p)) {
      accelerations_[p] = {};
      velocities_[p] = v0_[p];
      continue;
    }
    accelerations_[p] = (1.0 / (q * q)) * (positions_[p] - predicted_[p]);
    velocities_[p] = velocity_guess[p] + q * accelerations_[p];
  }
}

bool Rope::solve_stage(double q, int max_iterations, RopeReport& report) {
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    ++report.iterations;
    const double moved = newton_step(q);
    if (moved <= def_.tolerance) return true;
  }
  return false;
}

/// One step of mixed Newton: the tension λ of each link is an unknown of its own, so that stiffness does not enter, and
/// EA → ∞ is no special case. For a link from a to b, d the unit vector from a to b, u = perp(d), L its length, α =
/// l/EA, g = max(0, λ)/L with the λ of the iteration before:
///
///     A_a·δa − g·u·uᵀ·δb − d·λ = r_a         (A_a and A_b hold the link's own g·u·uᵀ)
///     A_b·δb − g·u·uᵀ·δa + d·λ = r_b
///     dᵀ(δb − δa) − α·λ = −c                 c = L − l
///
/// Points are eliminated one by one from the cord's last to its first. With S = A_a⁻¹, p = d − g·(uᵀSd)·u and
/// σ = α + dᵀSd:
///
///     λ = (c − dᵀS·r_a + pᵀδb)/σ             δa = S(r_a + d·λ + g·u·uᵀδb)
///     A_b ← A_b − g²·(uᵀSu)·u·uᵀ + p·pᵀ/σ    r_b ← r_b + g·(uᵀS·r_a)·u − p·(c − dᵀS·r_a)/σ
///
/// A constrained point has S = 0. Returns how far the point that moved most went, m.
double Rope::newton_step(double q) {
  const double inverse_q2 = 1.0 / (q * q);
  const double least_sigma = least_give * q * q / masses_[0];
  const std::size_t n = positions_.size();
  const auto residual = [&](std::size_t p) {
    return masses_[p] * (gravity_ - inverse_q2 * (positions_[p] - predicted_[p]));
  };
  double xx = masses_[n - 1] * inverse_q2;  // A of the point that is eliminated next
  double xy = 0.0;
  double yy = xx;
  Vec2 r = residual(n - 1);

  for (std::size_t e = n - 1; e-- > 0;) {  // from point a = e + 1 to b = e
    const Vec2 ab = positions_[e] - positions_[e + 1];
    const double size = length(ab);
    const Vec2 d = size > 0.0 ? (1.0 / size) * ab : Vec2{0.0, 1.0};
    const Vec2 u = perp(d);
    const double g = size > 0.0 ? std::max(0.0, tensions_[e]) / size : 0.0;
    xx += g * u.x * u.x;
    xy += g * u.x * u.y;
    yy += g * u.y * u.y;
    const double inverse_det = is_constrained(e + 1) ? 0.0 : 1.0 / (xx * yy - xy * xy);
    const auto s = [&](Vec2 v) { return inverse_det * Vec2{yy * v.x - xy * v.y, xx * v.y - xy * v.x}; };
    const Vec2 sd = s(d);
    const Vec2 su = s(u);
    const Vec2 sr = s(r);
    const double inverse_sigma = 1.0 / std::max(compliance_ + dot(d, sd), least_sigma);
    const Vec2 p = d - (g * dot(u, sd)) * u;
    const double tension = (size - link_length_ - dot(d, sr)) * inverse_sigma;
    const Vec2 slope = inverse_sigma * p;
    links_[e] = {tension, slope, sr + tension * sd, (g * su.x) * u + sd.x * slope, (g * su.y) * u + sd.y * slope};

    const double inertia = masses_[e] * inverse_q2;
    const double across = g * (1.0 - g * dot(u, su));
    xx = inertia + across * u.x * u.x + p.x * slope.x;
    xy = across * u.x * u.y + p.x * slope.y;
    yy = inertia + across * u.y * u.y + p.y * slope.y;
    r = residual(e) + (g * dot(u, sr)) * u - tension * p;
  }

  Vec2 moved{};
  if (!is_constrained(0)) {
    moved = (1.0 / (xx * yy - xy * xy)) * Vec2{yy * r.x - xy * r.y, xx * r.y - xy * r.x};
    positions_[0] += moved;
  }
  double furthest2 = dot(moved, moved);
  for (std::size_t e = 0; e + 1 < n; ++e) {
    const Link& link = links_[e];
    tensions_[e] = link.tension + dot(link.slope, moved);
    moved = link.shift + Vec2{dot(link.turn_x, moved), dot(link.turn_y, moved)};
    positions_[e + 1] += moved;
    furthest2 = std::max(furthest2, dot(moved, moved));
  }
  return std::sqrt(furthest2);
}

}  // namespace ribbon
