#pragma once

#include <algorithm>
#include <cmath>

namespace ribbon {

// Least compliance of a bar, as a share of a point's own give q²/m, that an inextensible one is given
constexpr double singular_share = 1e-10;  // where the system would be singular: between two constrained points
constexpr double dual_share = 1e-12;      // where a tension stays an unknown of a system that others are coupled with
constexpr double proximal_share = 1e-7;   // where tensions are eliminated first, and approached by iteration

constexpr double nearly_taut = 1e-12;  // of its length, that a bar may be short and is not slack for

/// A bar as mixed Newton sees it: W = ½·c²/α for an elongation c, its tension λ an unknown that obeys
///
///     α·λ = c + β·ċ,     ċ the rate of c, β the damping time.
///
/// In a stage v = ṽ + (x − x̃)/q, so a step δ changes c by J·δ and ċ by J·δ/q. Divided by 1 + β/q the condition has the
/// undamped form again, compliance·λ = elongation + J·δ.
struct MixedBar {
  double elongation;  ///< m
  double compliance;  ///< m/N
};

/// At rest; 0 where inextensible, and where slack if it cannot push.
inline double static_tension(const MixedBar& bar, bool tension_only) {
  return bar.compliance == 0.0 || (tension_only && bar.elongation < 0.0) ? 0.0 : bar.elongation / bar.compliance;
}

inline MixedBar damped(double elongation, double rate, double compliance, double damping, double q) {
  const double scale = 1.0 / (1.0 + damping / q);
  return {scale * (elongation + damping * rate), scale * compliance};
}

/// ½·c²/α of a bar whose tension is λ, c = α·λ − β·ċ: what of it is elastic.
inline double elastic_energy(double tension, double compliance, double damping, double rate) {
  const double c = compliance * tension - damping * rate;
  return compliance > 0.0 ? 0.5 * c * c / compliance : 0.0;
}

/// ½·c²/α up to a tension `most`, from where on it grows with that slope only: so that a line can be searched with any
/// stiffness. With `most` above |λ⁺| the mixed Newton step is one of descent for it, for then with J·δ = α·λ⁺ − c each
/// bar's part (φ′ − λ⁺)·J·δ ≤ 0: −(c − α·λ⁺)²/α below, −(most − |λ⁺|)(|c| − α·|λ⁺|) at the least above (Nocedal &
/// Wright 2006, 18.3).
inline double exact_penalty(const MixedBar& bar, double most) {
  const double c = std::abs(bar.elongation);
  return c < most * bar.compliance ? 0.5 * c * c / bar.compliance : most * (c - 0.5 * most * bar.compliance);
}

/// Whether a bar that cannot push is slack, by the sign of λ + (c − α·λ)/k (the primal-dual active set of Hintermüller,
/// Ito & Kunisch 2003) with the greater of α and `give` for k: what is stiff by its tension, what is soft by its
/// elongation alone. In doubt it is taut: if it should be slack it pushes in the next step, whoever else does, while of
/// a row of slack bars only the first would be found taut at a time. `size` [m] is what its elongation is rounded by.
inline bool is_slack(const MixedBar& bar, double tension, double give, double size) {
  return tension * std::max(0.0, give - bar.compliance) + bar.elongation < -nearly_taut * size;
}

/// m, how wrong it was, in the step that led here, to take such a bar for slack, and then it is too long, or for taut,
/// and then it pushes: by how far that moves a point of this `give`.
inline double misjudged_way(const MixedBar& bar, double tension, double give) {
  if (tension != 0.0) return std::max(0.0, -tension) * give;
  return std::max(0.0, bar.elongation) * give / (give + bar.compliance);
}

}  // namespace ribbon
