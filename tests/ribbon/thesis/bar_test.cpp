#include "ribbon/thesis/bar.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "tests/support/dense.h"

namespace ribbon {
namespace {

/// The bar's 4 × 4 matrix as assembled into an empty global one.
Eigen::Matrix4d element(Vec2 direction, double k, bool free_a = true, bool free_b = true) {
  BandedMatrix band(4, 3);
  add_bar_stiffness(band, 0, 1, direction, k, free_a, free_b);
  Eigen::Matrix4d m;
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) m(r, c) = band.at(r, c);
  }
  return m;
}

TEST(Bar, IsEquation39) {
  const double c = 0.6;
  const double s = 0.8;
  Eigen::Matrix4d printed;
  printed << c * c, c * s, -c * c, -c * s,  //
      c * s, s * s, -c * s, -s * s,         //
      -c * c, -c * s, c * c, c * s,         //
      -c * s, -s * s, c * s, s * s;
  EXPECT_LT((element({c, s}, 7.0) - 7.0 * printed).norm(), 1e-14);
}

TEST(Bar, HasThreeRigidModesAndOneStiffOne) {
  const Eigen::Vector4d values = test_support::eigenvalues(element({0.28, 0.96}, 3.0));
  EXPECT_NEAR(values(0), 0.0, 1e-14);
  EXPECT_NEAR(values(2), 0.0, 1e-14);
  EXPECT_NEAR(values(3), 6.0, 1e-14);
}

/// The bar's energy ½k(d·(u_b − u_a))²: its gradient is minus the force, its Hessian the matrix.
TEST(Bar, ForceAndMatrixAreDerivativesOfTheEnergy) {
  const Vec2 d{0.28, -0.96};
  const double k = 4.0;
  const auto energy = [&](const Eigen::Vector4d& u) {
    const double stretch = dot(d, Vec2{u(2) - u(0), u(3) - u(1)});
    return 0.5 * k * stretch * stretch;
  };
  const Eigen::Vector4d u(0.1, -0.2, 0.4, 0.3);
  const Vec2 on_a = bar_force(d, k, {u(0), u(1)}, {u(2), u(3)});
  const Eigen::Vector4d force(on_a.x, on_a.y, -on_a.x, -on_a.y);
  for (int i = 0; i < 4; ++i) {
    const double step = 1e-4;
    const Eigen::Vector4d e = step * Eigen::Vector4d::Unit(i);
    EXPECT_NEAR((energy(u + e) - energy(u - e)) / (2.0 * step), -force(i), 1e-9);
  }
  EXPECT_LT((element(d, k) * u + force).norm(), 1e-14);
}

TEST(Bar, LeavesOutTheRowsAndColumnsOfADrivenEnd) {
  const Eigen::Matrix4d whole = element({0.6, 0.8}, 2.0);
  const Eigen::Matrix4d a_driven = element({0.6, 0.8}, 2.0, false, true);
  EXPECT_EQ((a_driven.topRows<2>().norm()), 0.0);
  EXPECT_EQ((a_driven.leftCols<2>().norm()), 0.0);
  EXPECT_EQ((a_driven.bottomRightCorner<2, 2>()), (whole.bottomRightCorner<2, 2>()));
  EXPECT_EQ(element({0.6, 0.8}, 2.0, false, false).norm(), 0.0);
}

}  // namespace
}  // namespace ribbon
