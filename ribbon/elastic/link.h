#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ribbon/vec2.h"

namespace ribbon {

// The least compliance of a bar, as a share of the compliance q²/m of a point. Without it, an inextensible bar would
// make the system singular between two constrained points.
constexpr double min_singular_compliance = 1e-10;  // of a chain that is solved alone
constexpr double min_dual_compliance = 1e-12;      // of tensions that stay unknowns of a coupled solve
constexpr double min_proximal_compliance = 1e-7;   // in proximal(); iterations remove its error

// Elongation below which a bar that cannot push is slack, as a share of its length: rounding of the length.
constexpr double slack_tolerance = 1e-12;

/// Returns ab/size, `size` being the length of ab, or `fallback` if it is 0.
inline Vec2 unit_or(Vec2 ab, double size, Vec2 fallback) { return size > 0.0 ? (1.0 / size) * ab : fallback; }

/// A bar in mixed Newton: W = ½·c²/α for an elongation c, its tension λ an unknown that satisfies
///
///     α·λ = c + β·ċ,     ċ the rate of c, β the damping time.
///
/// In a stage v = ṽ + (x − x̃)/q, so a step δ changes c by J·δ and ċ by J·δ/q. Division by 1 + β/q gives the undamped
/// form: compliance·λ = elongation + J·δ.
struct MixedBar {
  double elongation;  ///< m
  double compliance;  ///< m/N
};

/// Returns the bar for a system that is never stiffer than 1/α₀, if its compliance α is below a minimum α₀: instead of
/// α·λ⁺ = c + J·δ, the tension λ becomes the solution λ⁺ of
///
///     α·λ⁺ + (α₀ − α)(λ⁺ − λ) = c + J·δ,
///
/// the proximal point method (Rockafellar 1976). The solution is the same when λ has converged.
inline MixedBar proximal(const MixedBar& bar, double min_compliance, double tension) {
  if (bar.compliance >= min_compliance) return bar;
  return {bar.elongation + (min_compliance - bar.compliance) * tension, min_compliance};
}

/// Returns the tension at rest [N]; 0 for an inextensible bar, and for a slack one that cannot push.
inline double static_tension(const MixedBar& bar, bool tension_only) {
  return bar.compliance == 0.0 || (tension_only && bar.elongation < 0.0) ? 0.0 : bar.elongation / bar.compliance;
}

/// Returns the undamped form of a damped bar: `elongation` [m], `rate` [m/s], `compliance` [m/N], damping time [s].
inline MixedBar damped(double elongation, double rate, double compliance, double damping, double q) {
  const double scale = 1.0 / (1.0 + damping / q);
  return {scale * (elongation + damping * rate), scale * compliance};
}

/// Returns the elastic energy ½·c²/α [J] of a bar of tension λ: c = α·λ − β·ċ. One that cannot push has none while it
/// is shorter than at rest: its damping alone resists then.
inline double elastic_energy(double tension, double compliance, double damping, double rate,
                             bool tension_only = false) {
  const double c = compliance * tension - damping * rate;
  if (compliance == 0.0 || (tension_only && c < 0.0)) return 0.0;
  return 0.5 * c * c / compliance;
}

/// Returns the elastic energy [J] of a link of a cord. rate() [m/s] and elongation() [m] are only called if it is
/// damped: one that cannot push and shortens too fast to pull has a tension of zero, and the energy of its length.
template <typename Rate, typename Elongation>
double damped_elastic_energy(double tension, double compliance, double damping, bool tension_only, Rate&& rate,
                             Elongation&& elongation) {
  if (damping <= 0.0) return elastic_energy(tension, compliance, damping, 0.0, tension_only);
  if (tension != 0.0) return elastic_energy(tension, compliance, damping, rate(), tension_only);
  const double at_rest = tension_only ? static_tension({elongation(), compliance}, true) : 0.0;
  return elastic_energy(at_rest, compliance, damping, 0.0, tension_only);
}

/// Returns the exact penalty φ(c) [J]: ½·c²/α up to the tension Λ = `max_tension`, and beyond it linear in |c| with the
/// slope Λ. So a line search works for any stiffness.
///
/// If Λ ≥ |λ⁺|, the mixed Newton step is a descent direction: with J·δ = α·λ⁺ − c, each bar's part (φ′ − λ⁺)·J·δ is
/// −(c − α·λ⁺)²/α in the quadratic range and at most −(Λ − |λ⁺|)(|c| − α·|λ⁺|) in the linear range, so it is ≤ 0
/// (Nocedal & Wright 2006, 18.3).
inline double exact_penalty(const MixedBar& bar, double max_tension) {
  const double c = std::abs(bar.elongation);
  return c < max_tension * bar.compliance ? 0.5 * c * c / bar.compliance
                                          : max_tension * (c - 0.5 * max_tension * bar.compliance);
}

/// Returns whether a bar that cannot push is slack, by the sign of λ + (c − α·λ)/k: the primal-dual active set method
/// (Hintermüller, Ito & Kunisch 2003). k is the larger of α and `point_compliance` [m/N], so the tension decides for a
/// stiff bar and the elongation for a soft one. `size` is the length of the bar, m.
///
/// A bar near the limit counts as taut. If it should be slack, the next step finds it under compression, and finds all
/// such bars at once. Of a row of wrongly slack bars, each step would find only the first taut.
inline bool is_slack(const MixedBar& bar, double tension, double point_compliance, double size) {
  return tension * std::max(0.0, point_compliance - bar.compliance) + bar.elongation < -slack_tolerance * size;
}

/// A bar that cannot push, between points `link` and `link` + 1 of a rope, as a row of a convex problem: in a step δ
/// its tension is
///
///     λ = max(0, (elongation + dᵀ(δb − δa))/compliance).
struct OneSidedBar {
  std::size_t link;
  Vec2 d;                   ///< unit vector from a to b
  MixedBar bar;             ///< proximal, so with a compliance above 0
  bool slack;               ///< whether it is likely to be slack after the step
  double point_compliance;  ///< m/N, q²/m
};

/// Returns the row of a bar of this length `size` [m] and tension.
inline OneSidedBar one_sided(std::size_t link, Vec2 d, const MixedBar& bar, double tension, double point_compliance,
                             double size) {
  return {link, d, proximal(bar, min_proximal_compliance * point_compliance, tension),
          is_slack(bar, tension, point_compliance, size), point_compliance};
}

/// Returns how far [m] the last step moved a point of this compliance [m/N] wrongly. It took the bar for slack, and the
/// bar is too long; or it took the bar for taut, and the bar pushes.
inline double active_set_error(const MixedBar& bar, double tension, double point_compliance) {
  if (tension != 0.0) return std::max(0.0, -tension) * point_compliance;
  return std::max(0.0, bar.elongation) * point_compliance / (point_compliance + bar.compliance);
}

}  // namespace ribbon
