#pragma once

#include "ribbon/banded_ldlt.h"

namespace tradeoff {

/// The baseline that the thesis measured: M2⁻¹ as a dense matrix, times F2 (Goto 2017, Eq. 3.18). O(n³) a substep.
/// Eigen is left to vectorise as it likes: a baseline deserves its best.
class DenseInverse final : public ribbon::LinearSolver {
 public:
  bool solve(ribbon::BandedMatrix& a, std::span<double> b) override;
};

}  // namespace tradeoff
