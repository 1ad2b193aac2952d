#include "tests/tradeoff/dense_inverse.h"

#include <Eigen/Dense>

namespace tradeoff {

bool DenseInverse::solve(ribbon::BandedMatrix& a, std::span<double> b) {
  const int n = a.size();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (int r = 0; r < n; ++r) {
    for (int c = r; c < n && c - r <= a.half_bandwidth(); ++c) dense(r, c) = dense(c, r) = a.at(r, c);
  }
  Eigen::Map<Eigen::VectorXd> x(b.data(), n);
  const Eigen::MatrixXd inverse = dense.inverse();
  x = (inverse * x).eval();
  return x.allFinite();
}

}  // namespace tradeoff
