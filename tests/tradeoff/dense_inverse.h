#pragma once

#include <Eigen/Dense>

#include "ribbon/linear/banded_ldlt.h"

namespace tradeoff {

/// The baseline that the thesis measured: M2⁻¹ as a dense matrix, times F2 (Goto 2017, Eq. 3.18). O(n³) a substep.
/// For a fair comparison Eigen may vectorise, and memory is reused from call to call.
class DenseInverse final : public ribbon::LinearSolver {
 public:
  bool solve(ribbon::BandedMatrix& a, std::span<double> b) override;

 private:
  Eigen::MatrixXd dense_;
  Eigen::MatrixXd inverse_;
  Eigen::VectorXd x_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace tradeoff
