#include "engine/draw/canvas_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/engine/draw/mesh_cover.h"

namespace engine {
namespace {

/// Expects each pixel of a picture to have the cover of the mesh at its middle.
void expect_cover(const Mesh& mesh, int width, int height) {
  Raster raster(width, height);
  raster.fill(mesh, 0xff, 255);
  std::size_t k = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double expected = 255.0 * cover_at(mesh, {x + 0.5, y + 0.5});
      ASSERT_NEAR(raster.pixels()[k++], expected, 1.0) << x << ", " << y;
    }
  }
}

TEST(Raster, TheLargestCoverCountsInAnyOrder) {
  Mesh mesh;
  mesh.vertices = {{{0.0, 0.0}, 1.0}, {{40.0, 0.0}, 1.0}, {{0.0, 40.0}, 1.0},
                   {{0.0, 0.0}, 0.2}, {{40.0, 0.0}, 0.4}, {{0.0, 40.0}, 0.3}};
  for (const std::vector<int>& order : {std::vector{0, 1, 2, 3, 4, 5}, std::vector{3, 4, 5, 0, 1, 2}}) {
    mesh.indices = order;
    Raster raster(20, 20);
    raster.fill(mesh, 0xff, 255);
    EXPECT_EQ(raster.pixels(), std::vector<std::uint32_t>(400, 0xffU));
  }
}

TEST(Raster, LinesInAllDirectionsHaveTheCoverOfTheirDistance) {
  for (int k = 0; k < 48; ++k) {  // every sixth is level or upright
    const double angle = std::numbers::pi / 12.0 * k;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    Mesh mesh;
    add_polyline(mesh, std::vector<Vec2>{Vec2{30.3, 29.8} - 12.0 * out, Vec2{30.3, 29.8} + (10.0 + k) * out},
                 0.3 + 0.4 * k);
    expect_cover(mesh, 60, 60);
  }
}

TEST(Raster, DiscsAndRingsHaveTheCoverOfTheirDistance) {
  for (const double radius : {0.2, 0.7, 1.0, 3.3, 17.0, 80.0}) {
    Mesh disc;
    add_disc(disc, {31.2, 22.9}, radius);
    expect_cover(disc, 60, 60);
    for (const double width : {0.4, 1.0, 2.5, 9.0}) {
      Mesh ring;
      add_ring(ring, {31.2, 22.9}, radius, width);
      expect_cover(ring, 60, 60);
    }
  }
}

/// What was covered is forgotten, in all parts of a row of a wide picture.
TEST(Raster, AShapeLeavesNothingForTheNext) {
  constexpr int width = 4200;
  Mesh line;
  add_polyline(line, std::vector<Vec2>{{-5.0, 3.0}, {20.0, 3.2}, {2030.0, 5.0}, {4250.0, 2.5}}, 3.0);
  expect_cover(line, width, 8);
  Raster raster(width, 8);
  raster.fill(line, 0xff, 255);
  const std::vector<std::uint32_t> before = raster.pixels();
  Mesh dot;
  add_disc(dot, {2047.5, 4.0}, 2.0);
  raster.fill(dot, 0xff00, 255);
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (std::abs(static_cast<double>(k % width) - 2047.0) < 4.0) continue;
    ASSERT_EQ(raster.pixels()[k], before[k]) << k % width;
  }
}

TEST(Raster, AMaskIsCutOffAtTheEdges) {
  const std::vector<std::uint8_t> mask(16, 255);  // 4 × 4
  for (const int left : {-3, 5})
    for (const int top : {-3, 5}) {
      Raster raster(6, 6);
      raster.stamp(mask, 4, left, top, 0xff, 255);
      for (int i = 0; i < 36; ++i) {
        const bool inside = i % 6 >= left && i % 6 < left + 4 && i / 6 >= top && i / 6 < top + 4;
        EXPECT_EQ(raster.pixels()[static_cast<std::size_t>(i)], inside ? 0xffU : 0U)
            << left << ", " << top << ": " << i;
      }
    }
}

}  // namespace
}  // namespace engine
