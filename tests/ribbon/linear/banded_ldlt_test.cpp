#include "ribbon/linear/banded_ldlt.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>
#include <random>
#include <vector>

#include "tests/support/dense.h"

namespace ribbon {
namespace {

/// A random symmetric positive definite band matrix: diagonally dominant.
BandedMatrix random_band(int n, int width, std::mt19937& random) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  BandedMatrix a(n, width);
  for (int r = 0; r < n; ++r) {
    a.row(r)[0] = 2.0 * width + 1.0;
    for (int k = 1; k <= width && r + k < n; ++k) a.row(r)[k] = entry(random);
  }
  return a;
}

Eigen::MatrixXd dense(const BandedMatrix& a) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(a.size(), a.size());
  for (int r = 0; r < a.size(); ++r) {
    for (int c = 0; c < a.size(); ++c) {
      if (std::abs(r - c) <= a.half_bandwidth()) m(r, c) = a.at(r, c);
    }
  }
  return m;
}

TEST(BandedLdlt, AgreesWithEigenAtEveryWidth) {
  std::mt19937 random(7);
  for (const int width : {1, 3, 7, 8, 9, 11, 13, 15, 35, 131}) {
    for (const int n : {2, 20, 133}) {
      BandedMatrix a = random_band(n, width, random);
      std::vector<double> b(static_cast<std::size_t>(n));
      for (double& value : b) value = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
      const Eigen::VectorXd expected =
          test_support::solve_dense(dense(a), Eigen::Map<const Eigen::VectorXd>(b.data(), n));
      ASSERT_TRUE(BandedLdlt().solve(a, b));
      for (int k = 0; k < n; ++k) EXPECT_NEAR(b[static_cast<std::size_t>(k)], expected(k), 1e-12);
    }
  }
}

TEST(BandedLdlt, RefusesMatricesThatAreNotPositiveDefinite) {
  const auto solves = [](double a00, double a01, double a11) {
    BandedMatrix a(2, 7);
    a.row(0)[0] = a00;
    a.row(0)[1] = a01;
    a.row(1)[0] = a11;
    std::vector<double> b = {1.0, 1.0};
    return BandedLdlt().solve(a, b);
  };
  EXPECT_TRUE(solves(2.0, 1.0, 2.0));
  EXPECT_FALSE(solves(1.0, 2.0, 1.0));  // indefinite
  EXPECT_FALSE(solves(1.0, 1.0, 1.0));  // singular
  EXPECT_FALSE(solves(-1.0, 0.0, 1.0));
  EXPECT_FALSE(solves(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0));
  EXPECT_FALSE(solves(std::numeric_limits<double>::infinity(), 0.0, 1.0));
  EXPECT_FALSE(solves(std::numeric_limits<double>::denorm_min(), 0.0, 1.0));
}

TEST(BandedMatrix, AtReadsBothTriangles) {
  BandedMatrix a(4, 2);
  a.row(1)[2] = 5.0;
  EXPECT_EQ(a.at(1, 3), 5.0);
  EXPECT_EQ(a.at(3, 1), 5.0);
  a.set_zero();
  EXPECT_EQ(a.at(1, 3), 0.0);
}

}  // namespace
}  // namespace ribbon
