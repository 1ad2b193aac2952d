#pragma once

#include "engine/math/double_pair.h"

namespace engine {

/// An angle as a number of quarter turns, 0 … 3, and the rest, −π/4 … π/4.
struct QuarterTurns {
  unsigned quarters;
  DoublePair rest;  ///< rad
};

/// `x`: finite, at least 2⁻¹² in size. The rest is accurate to a relative 2⁻¹⁰⁰ (Payne and Hanek: only those bits of
/// 2/π are multiplied that matter for this exponent).
QuarterTurns quarter_turns(float x);

inline constexpr DoublePair half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

}  // namespace engine
