#include "engine/draw/canvas_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "tests/engine/draw/mesh_cover.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"

namespace engine {
namespace {

using constants::infinity;
using constants::nan;
using test_support::distance_to_path;
constexpr double pi = std::numbers::pi;

/// Checks the cover of a line of this width everywhere: by the distance from its middle line, with one pixel of
/// tolerance at the edge.
void expect_line(const std::vector<Vec2>& line, double width) {
  Mesh mesh;
  add_polyline(mesh, line, width);
  expect_sound(mesh);
  for (int row = 0; row < 140; ++row)
    for (int column = 0; column < 140; ++column) {
      const Vec2 p{0.71 * column, 0.71 * row};
      const double expected = std::clamp(width / 2.0 + 0.5 - distance_to_path(p, line), 0.0, 1.0);
      ASSERT_NEAR(cover_at(mesh, p), expected, 0.06) << "at " << p.x << ", " << p.y;
    }
}

TEST(CanvasMesh, StraightLineCoversItsRectangle) { expect_line({{10.0, 20.0}, {50.0, 35.0}, {90.0, 50.0}}, 7.0); }

TEST(CanvasMesh, BendsHaveNeitherGapsNorBumps) {
  expect_line({{10.0, 10.0}, {50.0, 15.0}, {60.0, 60.0}, {30.0, 50.0}, {32.0, 90.0}}, 8.0);
}

TEST(CanvasMesh, HairpinsAndReversalsHaveNoGaps) {
  expect_line({{20.0, 50.0}, {80.0, 50.0}, {20.0, 50.0}}, 6.0);
  expect_line({{20.0, 50.0}, {80.0, 50.0}, {21.0, 53.0}, {79.0, 57.0}}, 6.0);
}

TEST(CanvasMesh, BendsTighterThanTheLineIsWideHaveNoGaps) {
  std::vector<Vec2> curl;
  for (int i = 0; i <= 40; ++i) curl.push_back({50.0 + 3.0 * std::cos(0.2 * i), 50.0 + 3.0 * std::sin(0.2 * i)});
  expect_line(curl, 14.0);
}

TEST(CanvasMesh, RepeatedPointsChangeNothing) {
  expect_line({{10.0, 50.0}, {10.0, 50.0}, {50.0, 50.0}, {50.0, 50.0}, {50.0, 50.0}, {50.0, 80.0}, {50.0, 80.0}}, 5.0);
}

TEST(CanvasMesh, ThinLineKeepsItsTotalCover) {
  for (const double width : {0.1, 0.4, 1.0, 2.5}) {
    Mesh mesh;
    add_polyline(mesh, std::vector<Vec2>{{-50.0, 13.3}, {150.0, 60.9}}, width);
    const double across = length(Vec2{200.0, 47.6}) / 2.0;  // the part of the line within the 100 pixels
    EXPECT_NEAR(covered_pixels(mesh, 100, 100), width * across, 0.02 * width * across) << width;
  }
}

TEST(CanvasMesh, DiscCoversItsAreaAndNothingBeyondItsBorder) {
  for (const double radius : {2.0, 3.3, 5.5, 20.0, 45.0}) {
    Mesh mesh;
    add_disc(mesh, {50.3, 49.6}, radius);
    expect_sound(mesh);
    EXPECT_NEAR(covered_pixels(mesh, 100, 100), pi * radius * radius, 0.01 * pi * radius * radius) << radius;
    EXPECT_EQ(cover_at(mesh, {50.3 + radius + 1.0, 49.6}), 0.0) << radius;
  }
}

TEST(CanvasMesh, RingIsHollow) {
  Mesh mesh;
  add_ring(mesh, {50.0, 50.0}, 30.0, 4.0);
  expect_sound(mesh);
  EXPECT_EQ(cover_at(mesh, {50.0, 50.0}), 0.0);
  EXPECT_EQ(cover_at(mesh, {80.0, 50.0}), 1.0);
  EXPECT_EQ(cover_at(mesh, {50.0, 83.0}), 0.0);
  EXPECT_NEAR(covered_pixels(mesh, 100, 100), 2.0 * pi * 30.0 * 4.0, 8.0);
}

TEST(CanvasMesh, RingWiderThanItsRadiusIsADisc) {
  Mesh mesh;
  add_ring(mesh, {50.0, 50.0}, 10.0, 30.0);
  EXPECT_EQ(cover_at(mesh, {50.0, 50.0}), 1.0);
  EXPECT_NEAR(covered_pixels(mesh, 100, 100), pi * 25.0 * 25.0, 0.01 * pi * 25.0 * 25.0);
}

TEST(CanvasMesh, PolygonIsTheSameInEitherOrder) {
  const std::vector<Vec2> corners{{20.0, 20.0}, {70.0, 25.0}, {80.0, 60.0}, {40.0, 70.0}};
  const std::vector<Vec2> turned(corners.rbegin(), corners.rend());
  for (const auto& order : {corners, turned}) {
    Mesh mesh;
    add_convex(mesh, order);
    expect_sound(mesh);
    EXPECT_NEAR(cover_at(mesh, {50.0, 45.0}), 1.0, 1e-9);
    EXPECT_NEAR(cover_at(mesh, {45.0, 22.5}), 0.5, 1e-9);  // the middle of an edge
    EXPECT_EQ(cover_at(mesh, {45.0, 21.4}), 0.0);
    EXPECT_NEAR(covered_pixels(mesh, 100, 100), 1950.0, 2.0);
  }
}

TEST(CanvasMesh, SliverOfAPolygonKeepsItsTotalCover) {
  Mesh mesh;
  add_convex(mesh, std::vector<Vec2>{{10.0, 50.0}, {90.0, 50.0}, {90.0, 50.3}, {10.0, 50.3}});
  expect_sound(mesh);
  EXPECT_NEAR(covered_pixels(mesh, 100, 100), 24.0, 0.8);
}

TEST(CanvasMesh, TrianglesHaveARimOnTheirCommonBoundaryOnly) {
  Mesh mesh;
  const std::vector<Vec2> square{{20.0, 20.0}, {60.0, 20.0}, {60.0, 60.0}, {20.0, 60.0}, {40.0, 40.0}};
  add_triangles(mesh, square, std::vector<int>{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4});
  expect_sound(mesh);
  EXPECT_EQ(cover_at(mesh, {40.0, 40.0}), 1.0);
  EXPECT_NEAR(cover_at(mesh, {40.0, 19.5}), 0.5, 1e-9);
  EXPECT_NEAR(cover_at(mesh, {20.0, 61.0}), 0.0, 1e-9);
  EXPECT_EQ(mesh.bars.size(), 4U) << "a rim around the middle";
  for (const MeshRing& ring : mesh.rings) EXPECT_GT(length(ring.center - Vec2{40.0, 40.0}), 15.0);
}

TEST(CanvasMesh, RoundedRectangle) {
  Mesh mesh;
  add_rounded_rectangle(mesh, {10.0, 20.0}, {60.0, 40.0}, 12.0);
  expect_sound(mesh);
  EXPECT_EQ(cover_at(mesh, {40.0, 40.0}), 1.0);
  EXPECT_EQ(cover_at(mesh, {11.0, 40.0}), 1.0);
  EXPECT_EQ(cover_at(mesh, {11.0, 21.0}), 0.0);  // cut off by the round corner
  EXPECT_NEAR(covered_pixels(mesh, 100, 100), 60.0 * 40.0 - (4.0 - pi) * 144.0, 3.0);
}

/// Counted work: a shape of its own for each piece and joint, instead of dozens of triangles.
TEST(CanvasMesh, LinesAndDiscsNeedNoTriangles) {
  Mesh mesh;
  add_polyline(mesh, std::vector<Vec2>{{10.0, 50.0}, {90.0, 50.0}, {50.0, 10.0}}, 9.0);
  EXPECT_EQ(mesh.bars.size(), 2U);
  EXPECT_EQ(mesh.rings.size(), 3U);
  add_disc(mesh, {50.0, 50.0}, 40.0);
  add_ring(mesh, {50.0, 50.0}, 40.0, 3.0);
  EXPECT_EQ(mesh.rings.size(), 5U);
  EXPECT_TRUE(mesh.indices.empty());
}

TEST(CanvasMesh, RecognisesInvalidBarsAndRings) {
  const Profile good{1.0, 2.0, 1.0};
  const auto bar = [](Vec2 from, Vec2 to, Profile profile) {
    Mesh mesh;
    mesh.bars.push_back({from, to, profile});
    return is_paintable(mesh);
  };
  const auto ring = [](Vec2 center, double radius, Profile profile) {
    Mesh mesh;
    mesh.rings.push_back({center, radius, profile});
    return is_paintable(mesh);
  };
  EXPECT_TRUE(bar({1.0, 2.0}, {3.0, 4.0}, good));
  EXPECT_FALSE(bar({1.0, 2.0}, {1.0, 2.0}, good));
  EXPECT_FALSE(bar({nan, 2.0}, {1.0, 2.0}, good));
  EXPECT_TRUE(ring({1.0, 2.0}, 0.0, good));
  EXPECT_FALSE(ring({1.0, 2.0}, -1.0, good));
  EXPECT_FALSE(ring({infinity, 2.0}, 1.0, good));
  for (const Profile& bad :
       {Profile{2.0, 2.0, 1.0}, Profile{-1.0, 2.0, 1.0}, Profile{1.0, infinity, 1.0}, Profile{1.0, 2.0, 1.5}}) {
    EXPECT_FALSE(bar({1.0, 2.0}, {3.0, 4.0}, bad));
    EXPECT_FALSE(ring({1.0, 2.0}, 0.0, bad));
  }
}

TEST(CanvasMesh, OverlapIsBlendedOnce) {
  Mesh mesh;
  add_polyline(mesh, std::vector<Vec2>{{10.0, 50.0}, {90.0, 50.0}, {50.0, 50.0}, {50.0, 10.0}, {70.0, 90.0}}, 9.0);
  Raster raster(100, 100);
  raster.fill(mesh, 0xff, 100);
  const auto most = *std::max_element(raster.pixels().begin(), raster.pixels().end());
  EXPECT_NEAR(most, 100.0, 1.0);
}

}  // namespace
}  // namespace engine
