#pragma once

#include <Eigen/Core>

namespace test_support {

/// Returns A⁻¹b, by LU with partial pivoting; A is n × n and regular. Eigen's decompositions are instantiated here
/// once, because each takes seconds to compile.
Eigen::VectorXd solve_dense(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the eigenvalues of a symmetric matrix in ascending order.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a);

}  // namespace test_support
