#include "tests/support/dense.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace test_support {

Eigen::VectorXd solve_dense(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) { return a.partialPivLu().solve(b); }

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace test_support
