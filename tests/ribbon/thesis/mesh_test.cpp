#include "ribbon/thesis/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "ribbon/thesis/corrections.h"

namespace ribbon {
namespace {

TEST(Mesh, ThreeByThreeIsFigure32OfTheThesis) {
  const Mesh mesh = make_mesh(3, 3, 0.1);
  std::array<int, 9> neighbours{};
  for (const Connection& c : mesh.connections) {
    ++neighbours[static_cast<std::size_t>(c.a)];
    ++neighbours[static_cast<std::size_t>(c.b)];
  }
  EXPECT_EQ(neighbours, (std::array<int, 9>{3, 5, 3, 5, 8, 5, 3, 5, 3}));
  EXPECT_EQ(mesh.connections.size(), 20U);
  EXPECT_EQ(mesh.triangles.size(), 8U);
}

TEST(Mesh, ConnectionsAreUniqueAndWithinTheBand) {
  for (const int h : {2, 3, 5}) {
    const Mesh mesh = make_mesh(7, h, 0.1);
    std::set<std::pair<int, int>> pairs;
    for (const Connection& c : mesh.connections) {
      EXPECT_LT(c.a, c.b);
      EXPECT_LE(c.b - c.a, h + 1);
      EXPECT_TRUE(pairs.insert({c.a, c.b}).second);
    }
  }
}

TEST(Mesh, RestLengthsAndAreasAreThoseOfTheInitialGrid) {
  const Mesh mesh = make_mesh(6, 4, 0.25);
  const std::array<Vec2, 2> path = {Vec2{1.0, 2.0}, Vec2{1.0 + 0.6, 2.0 + 0.8}};
  const std::vector<Vec2> x = lay_along(path, 6, 4, 0.25);
  for (const Connection& c : mesh.connections) {
    EXPECT_NEAR(length(x[static_cast<std::size_t>(c.b)] - x[static_cast<std::size_t>(c.a)]), c.rest_length, 1e-14);
  }
  double total = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const double area = signed_area(x[static_cast<std::size_t>(t.a)], x[static_cast<std::size_t>(t.b)],
                                    x[static_cast<std::size_t>(t.c)]);
    EXPECT_NEAR(area, t.rest_area, 1e-14);  // positive: counter-clockwise
    total += area;
  }
  EXPECT_NEAR(total, 5 * 0.25 * 3 * 0.25, 1e-13);
}

TEST(Mesh, BoundaryIsTheCounterClockwiseOutline) {
  for (const auto& [w, h] : {std::pair{5, 2}, std::pair{4, 4}, std::pair{2, 2}}) {
    const Mesh mesh = make_mesh(w, h, 1.0);
    ASSERT_EQ(mesh.boundary.size(), static_cast<std::size_t>(2 * (w + h) - 4));
    double twice_area = 0.0;
    int last = mesh.boundary.back();
    for (const int p : mesh.boundary) {
      const Vec2 a{static_cast<double>(mesh.column(last)), static_cast<double>(mesh.row(last))};
      const Vec2 b{static_cast<double>(mesh.column(p)), static_cast<double>(mesh.row(p))};
      EXPECT_DOUBLE_EQ(length(b - a), 1.0);
      twice_area += cross(a, b);
      last = p;
    }
    EXPECT_DOUBLE_EQ(twice_area, 2.0 * (w - 1) * (h - 1));
  }
}

TEST(Mesh, LayAlongFollowsCornersByArcLength) {
  const std::array<Vec2, 3> path = {Vec2{0.0, 0.0}, Vec2{1.0, 0.0}, Vec2{1.0, 1.0}};
  const std::vector<Vec2> x = lay_along(path, 6, 2, 0.4);  // 2 m of points on a path of 2 m
  const auto middle = [&](std::size_t i) { return 0.5 * (x[2 * i] + x[2 * i + 1]); };
  EXPECT_NEAR(length(middle(2) - Vec2{0.8, 0.0}), 0.0, 1e-15);
  EXPECT_NEAR(length(middle(3) - Vec2{1.0, 0.2}), 0.0, 1e-15);
  EXPECT_NEAR(length(middle(5) - Vec2{1.0, 1.0}), 0.0, 1e-15);
}

}  // namespace
}  // namespace ribbon
