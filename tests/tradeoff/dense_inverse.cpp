#include "tests/tradeoff/dense_inverse.h"

namespace tradeoff {

bool DenseInverse::solve(ribbon::BandedMatrix& a, std::span<double> b) {
  const int n = a.size();
  dense_.setZero(n, n);
  for (int r = 0; r < n; ++r) {
    for (int c = r; c < n && c - r <= a.half_bandwidth(); ++c) dense_(r, c) = dense_(c, r) = a.at(r, c);
  }
  lu_.compute(dense_);
  inverse_ = lu_.inverse();
  Eigen::Map<Eigen::VectorXd> rhs(b.data(), n);
  x_.noalias() = inverse_ * rhs;
  rhs = x_;
  return x_.allFinite();
}

}  // namespace tradeoff
