#include "ribbon/thesis/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "ribbon/geometry/quadtree.h"
#include "ribbon/thesis/broad_phase.h"

namespace ribbon {
namespace {

constexpr std::array<Vec2, 3> corner_triangle = {Vec2{0.0, 0.0}, Vec2{1.0, 0.0}, Vec2{0.0, 1.0}};

TEST(NearestPoint, FindsEdgesAndCorners) {
  const NearestPoint below = nearest_on_triangle_edges({0.25, -2.0}, corner_triangle);
  EXPECT_EQ(below.point, (Vec2{0.25, 0.0}));
  EXPECT_EQ(below.weight, (std::array<double, 3>{0.75, 0.25, 0.0}));
  EXPECT_EQ(nearest_on_triangle_edges({-1.0, -3.0}, corner_triangle).point, (Vec2{0.0, 0.0}));
  const NearestPoint slanted = nearest_on_triangle_edges({1.0, 1.0}, corner_triangle);
  EXPECT_NEAR(slanted.weight[1], 0.5, 1e-15);
  EXPECT_NEAR(slanted.weight[2], 0.5, 1e-15);
}

TEST(NearestPoint, SurvivesATriangleWithoutArea) {
  const std::array<Vec2, 3> flat = {Vec2{0.0, 0.0}, Vec2{1.0, 0.0}, Vec2{0.5, 0.0}};
  EXPECT_NEAR(length(nearest_on_triangle_edges({0.7, 2.0}, flat).point - Vec2{0.7, 0.0}), 0.0, 1e-15);
  const std::array<Vec2, 3> point = {Vec2{1.0, 1.0}, Vec2{1.0, 1.0}, Vec2{1.0, 1.0}};
  EXPECT_EQ(nearest_on_triangle_edges({5.0, 1.0}, point).point, (Vec2{1.0, 1.0}));
  EXPECT_FALSE(is_inside({0.5, 0.0}, flat));
}

TEST(Inside, HoldsForEitherWindingAndTheEdge) {
  const std::array<Vec2, 3> turned = {corner_triangle[0], corner_triangle[2], corner_triangle[1]};
  for (const auto& triangle : {corner_triangle, turned}) {
    EXPECT_TRUE(is_inside({0.2, 0.2}, triangle));
    EXPECT_TRUE(is_inside({0.5, 0.0}, triangle));
    EXPECT_FALSE(is_inside({0.6, 0.6}, triangle));
  }
}

/// A straight cord of 10 × 2 points along +x, spacing 1: the strip 0 ≤ y ≤ 1.
struct Strip {
  Mesh mesh = make_mesh(10, 2, 1.0);
  std::vector<Vec2> x = lay_along(std::array{Vec2{0.0, 0.5}, Vec2{9.0, 0.5}}, 10, 2, 1.0);
  std::vector<double> w = std::vector<double>(20, 1.0);

  std::optional<Contact> deepest(const Circle& circle) const {
    std::optional<Contact> found;
    for (const Triangle& triangle : mesh.triangles) {
      const auto contact = find_contact(mesh, triangle, x, circle);
      if (contact && (!found || contact->depth > found->depth)) found = contact;
    }
    return found;
  }
};

TEST(FindContact, DepthIsRadiusMinusDistance) {
  const Strip strip;
  const auto contact = strip.deepest({{4.3, 1.3}, {4.3, 1.3}, 0.5});
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->depth, 0.2, 1e-15);
  EXPECT_NEAR(contact->direction.y, 1.0, 1e-15);
  EXPECT_FALSE(strip.deepest({{4.3, 1.5}, {4.3, 1.5}, 0.5}));  // touching is not overlapping
}

TEST(FindContact, ACentreInsideLeavesThroughTheNearestBoundary) {
  const Strip strip;
  const auto up = strip.deepest({{4.3, 0.8}, {4.3, 2.0}, 0.5});
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->direction.y, 1.0, 1e-12);
  EXPECT_NEAR(up->depth, 0.7, 1e-12);
  const auto down = strip.deepest({{4.3, 0.1}, {4.3, 2.0}, 0.5});
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->direction.y, -1.0, 1e-12);
  EXPECT_NEAR(down->depth, 0.6, 1e-12);
}

TEST(FindContact, OnTheBoundaryTheDirectionIsTheOutwardNormal) {
  const Strip strip;
  const auto contact = strip.deepest({{4.3, 1.0}, {4.3, 1.0}, 0.5});
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->direction.y, 1.0, 1e-15);
  EXPECT_NEAR(contact->depth, 0.5, 1e-15);
}

TEST(FindContact, ATieGoesToTheSideItCameFrom) {
  const Strip strip;
  EXPECT_GT(strip.deepest({{4.3, 0.5}, {4.3, 0.6}, 0.2})->direction.y, 0.99);
  EXPECT_LT(strip.deepest({{4.3, 0.5}, {4.3, 0.4}, 0.2})->direction.y, -0.99);
}

TEST(FindContact, AnOwnPointDoesNotLeaveThroughItsOwnNeighbourhood) {
  Strip strip;
  const int point = strip.mesh.index(0, 0);
  strip.x[static_cast<std::size_t>(point)] = {6.5, 0.4};  // the end is inside another part of the cord
  const auto contact = strip.deepest({{6.5, 0.4}, {6.5, -1.0}, 0.4, point});
  ASSERT_TRUE(contact);
  for (const int p : contact->point) EXPECT_GT(strip.mesh.column(p), 2);
}

TEST(PushApart, MovesByInverseMassAndKeepsTheCentreOfMass) {
  Strip strip;
  const double w_circle = 0.25;  // 4 kg against points of 1 kg
  Circle circle{{4.3, 1.2}, {4.3, 1.2}, 0.5};
  const auto contact = strip.deepest(circle);
  ASSERT_TRUE(contact);
  const auto before = strip.x;
  const double lambda = push_apart(*contact, w_circle, 1.0, strip.w, strip.x);
  circle.center += (lambda * w_circle) * contact->direction;
  Vec2 moved = 4.0 * Vec2{0.0, circle.center.y - 1.2};
  for (std::size_t p = 0; p < before.size(); ++p) moved += strip.x[p] - before[p];
  EXPECT_NEAR(moved.x, 0.0, 1e-15);
  EXPECT_NEAR(moved.y, 0.0, 1e-15);
  const auto left = strip.deepest(circle);  // of second order: the edge turns a little
  EXPECT_LT(left ? left->depth : 0.0, 0.05 * contact->depth);
  EXPECT_LT(circle.center.y - 1.2, before[9].y - strip.x[9].y);  // the lighter side moves more
}

TEST(PushApart, ResolvesAtMostMaxPushAndNothingBetweenDrivenSides) {
  Strip strip;
  const Circle circle{{4.3, 1.2}, {4.3, 1.2}, 0.5};
  const auto contact = strip.deepest(circle);
  ASSERT_TRUE(contact);
  const double lambda = push_apart(*contact, 1.0, 0.1, std::vector<double>(20, 0.0), strip.x);
  EXPECT_NEAR(lambda, 0.1, 1e-15);
  EXPECT_EQ(push_apart(*contact, 0.0, 0.1, std::vector<double>(20, 0.0), strip.x), 0.0);
}

TEST(Quadtree, FindsWhatABruteForceSearchFinds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  std::exponential_distribution<double> size(3.0);
  Quadtree tree(300);
  for (int round = 0; round < 50; ++round) {
    std::vector<Box> boxes;
    for (int k = 0; k < 300; ++k) {
      const Vec2 c{place(random), round % 2 == 0 ? place(random) : 0.0};  // every other round: along a line
      const Vec2 half{size(random), size(random)};
      boxes.push_back({c - half, c + half});
    }
    tree.build(boxes);
    const Vec2 c{place(random), place(random)};
    const Box box{c - Vec2{0.7, 0.3}, c + Vec2{0.7, 0.3}};
    std::vector<int> found;
    tree.query(box, [&](int item) { found.push_back(item); });
    std::sort(found.begin(), found.end());
    std::vector<int> expected;
    for (int k = 0; k < 300; ++k) {
      if (overlap(boxes[static_cast<std::size_t>(k)], box)) expected.push_back(k);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(Quadtree, SurvivesManyEqualBoxesAndNone) {
  Quadtree tree(100);
  tree.build({});
  int found = 0;
  tree.query({{-1.0, -1.0}, {1.0, 1.0}}, [&](int) { ++found; });
  EXPECT_EQ(found, 0);
  tree.build(std::vector<Box>(100, Box{{0.0, 0.0}, {0.0, 0.0}}));
  tree.query({{-1.0, -1.0}, {1.0, 1.0}}, [&](int) { ++found; });
  EXPECT_EQ(found, 100);
}

TEST(BroadPhase, FindsAllPairsOfMovingPointsAndRebuildsOnlyAfterMotion) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(-0.03, 0.03);
  const Mesh mesh = make_mesh(30, 2, 0.1);
  std::vector<Vec2> x = lay_along(std::array{Vec2{0.0, 0.0}, Vec2{1.0, 0.0}}, 30, 2, 0.1);
  for (Vec2& p : x) p = {0.2 * p.x, p.y + 5.0 * step(random)};  // crumpled: much to find
  const std::vector<double> radii(x.size(), 0.04);
  BroadPhase phase(mesh, true);
  phase.reserve(x.size());
  phase.update(x, x, radii);
  phase.update(x, x, radii);
  EXPECT_EQ(phase.builds(), 1);
  for (int round = 0; round < 60; ++round) {
    for (Vec2& p : x) p += {step(random), step(random)};
    phase.update(x, x, radii);
    for (int p = 0; p < mesh.size(); ++p) {
      const auto near = phase.near(static_cast<std::size_t>(p));
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const Circle circle{x[static_cast<std::size_t>(p)], x[static_cast<std::size_t>(p)], 0.04, p};
        if (phase.is_own(static_cast<std::size_t>(p), t)) continue;
        if (!find_contact(mesh, mesh.triangles[static_cast<std::size_t>(t)], x, circle)) continue;
        EXPECT_TRUE(std::binary_search(near.begin(), near.end(), t)) << "point " << p << ", triangle " << t;
      }
    }
  }
  EXPECT_GT(phase.builds(), 5);
}

TEST(BroadPhase, LeavesOutTheCellsAroundAPoint) {
  const Mesh mesh = make_mesh(5, 4, 1.0);
  const BroadPhase phase(mesh, true);
  for (int p = 0; p < mesh.size(); ++p) {
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      // A cell is around p if one of its two triangles has p as a corner.
      const auto has = [&](int triangle) {
        const Triangle& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
        return corners.a == p || corners.b == p || corners.c == p;
      };
      EXPECT_EQ(phase.is_own(static_cast<std::size_t>(p), t), has(t) || has(t ^ 1));
    }
  }
}

TEST(BroadPhase, ReturnsAllTrianglesWhenItsMemoryIsFull) {
  const Mesh mesh = make_mesh(200, 2, 0.1);
  const std::vector<Vec2> heap(400, Vec2{0.5, 0.5});  // every triangle touches every point
  const std::vector<double> radii(400, 0.04);
  BroadPhase phase(mesh, true);
  phase.reserve(400);
  phase.update(heap, heap, radii);
  EXPECT_EQ(phase.near(399).size(), mesh.triangles.size());
}

}  // namespace
}  // namespace ribbon
