#include "ribbon/thesis/corrections.h"

#include <gtest/gtest.h>

#include <vector>

namespace ribbon {
namespace {

TEST(Springs, AreStableInOneStepAtAnyStiffness) {
  // One spring, both masses m: the implicit step moves by κ/(1 + κ) of the stretch, κ = (w_a + w_b)·k·dt².
  const std::vector<Connection> bar = {{0, 1, 1.0}};
  for (const double k : {1.0, 100.0, 1e12}) {
    std::vector<Vec2> x = {{0.0, 0.0}, {1.5, 0.0}};
    const std::vector<double> w = {2.0, 2.0};
    correct_springs(bar, k, 0.1, w, x);
    const double kappa = 4.0 * k * 0.01;
    EXPECT_NEAR(x[1].x - x[0].x, 1.5 - 0.5 * kappa / (1.0 + kappa), 1e-12);
  }
}

TEST(Springs, MovePointsByInverseMassAndKeepTheCentreOfMass) {
  const std::vector<Connection> bar = {{0, 1, 1.0}};
  std::vector<Vec2> x = {{0.0, 0.0}, {0.0, 3.0}};
  const std::vector<double> w = {1.0, 0.001};  // 1 kg and 1 t
  correct_springs(bar, 1e9, 0.1, w, x);
  EXPECT_NEAR(x[0].y * 1.0 + (x[1].y - 3.0) * 1000.0, 0.0, 1e-12);
  EXPECT_GT(x[0].y, 1.9);  // the light one moves
}

TEST(Springs, DoNotMoveDrivenAndCoincidentPoints) {
  const std::vector<Connection> bars = {{0, 1, 1.0}, {1, 2, 1.0}};
  std::vector<Vec2> x = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.0}};
  const std::vector<double> w = {0.0, 0.0, 1.0};
  correct_springs(bars, 1e3, 0.1, w, x);
  EXPECT_EQ(x, (std::vector<Vec2>{{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.0}}));
}

TEST(Areas, RestoreTheRequiredShareOfTheArea) {
  const std::vector<Triangle> triangle = {{0, 1, 2, 0.5}};
  std::vector<Vec2> x = {{0.0, 0.0}, {1.0, 0.0}, {0.3, 0.001}};
  const std::vector<double> w = {1.0, 1.0, 1.0};
  correct_areas(triangle, 0.3, 1.0, w, x);
  EXPECT_NEAR(signed_area(x[0], x[1], x[2]), 0.15, 0.02);  // linearised: nearly complete
  const Vec2 sum = x[0] + x[1] + x[2];
  EXPECT_NEAR(sum.x, 1.3, 1e-15);
  EXPECT_NEAR(sum.y, 0.001, 1e-15);
}

TEST(Areas, TurnAnInvertedTriangleBack) {
  const std::vector<Triangle> triangle = {{0, 1, 2, 0.5}};
  std::vector<Vec2> x = {{0.0, 0.0}, {1.0, 0.0}, {0.5, -0.4}};
  const std::vector<double> w = {1.0, 1.0, 1.0};
  for (int k = 0; k < 20; ++k) correct_areas(triangle, 0.3, 0.5, w, x);
  EXPECT_GT(signed_area(x[0], x[1], x[2]), 0.14);
}

TEST(Areas, DoNotMoveAHealthyOrDrivenTriangle) {
  const std::vector<Triangle> triangle = {{0, 1, 2, 0.5}};
  const std::vector<Vec2> healthy = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.4}};
  std::vector<Vec2> x = healthy;
  correct_areas(triangle, 0.3, 1.0, std::vector<double>{1.0, 1.0, 1.0}, x);
  EXPECT_EQ(x, healthy);
  const std::vector<Vec2> flat = {{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.0}};
  x = flat;
  correct_areas(triangle, 0.3, 1.0, std::vector<double>{0.0, 0.0, 0.0}, x);
  EXPECT_EQ(x, flat);
}

}  // namespace
}  // namespace ribbon
