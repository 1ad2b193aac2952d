#include "engine/draw/textured_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "engine/draw/pixel_pairs.h"
#include "tests/engine/draw/blue.h"
#include "tests/support/constants.h"
#include "tests/support/pixels.h"
#include "tests/support/points.h"

// Bands along lines.

namespace engine {
namespace {

using ribbon::Vec2;
using test_support::distance_to_path;

using constants::infinity;

Raster drawn_band(const std::vector<Vec2>& line, double width, Color color) {
  TexturedMesh mesh;
  BandLook look;
  look.width = width;
  look.color = color;
  add_band(mesh, line, look);
  EXPECT_TRUE(is_paintable(mesh));
  Raster raster(100, 100);
  raster.fill(mesh, {});
  return raster;
}

/// Checks that the band is opaque, and that nothing is beyond it. The straight ends are excluded.
void expect_band(const std::vector<Vec2>& line, double width) {
  const Raster raster = drawn_band(line, width, {0, 0, 255});
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const Vec2 p{x + 0.5, y + 0.5};
      const double away = distance_to_path(p, line);
      if (std::min(length(p - line.front()), length(p - line.back())) < 0.5 * width + 1.0) continue;
      if (away < 0.5 * width - 0.6) {
        ASSERT_EQ(blue(raster, x, y), 255) << "a gap at " << x << ", " << y;
      }
      if (away > 0.5 * width + 0.75) {
        ASSERT_EQ(blue(raster, x, y), 0) << "a bump at " << x << ", " << y;
      }
    }
}

TEST(Band, IsOpaqueAndOfConstantWidthOnCurvesAndSharpTurns) {
  expect_band({{10.0, 20.0}, {50.0, 35.0}, {90.0, 50.0}}, 9.0);
  expect_band({{10.0, 10.0}, {50.0, 15.0}, {60.0, 60.0}, {30.0, 50.0}, {32.0, 90.0}}, 12.0);
  expect_band({{20.0, 50.0}, {80.0, 50.0}, {20.0, 52.0}, {80.0, 60.0}}, 8.0);
}

TEST(Band, RandomLinesHaveNoGaps) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> somewhere(15.0, 85.0);
  std::uniform_real_distribution<double> width(3.0, 25.0);
  for (int attempt = 0; attempt < 150; ++attempt) {
    std::vector<Vec2> line;
    for (int k = 0; k < 3 + attempt % 6; ++k) line.push_back({somewhere(random), somewhere(random)});
    expect_band(line, width(random));
  }
}

TEST(Band, CurlsTighterThanTheBandHaveNoGaps) {
  std::vector<Vec2> curl;
  for (int i = 0; i <= 60; ++i) {
    const double radius = 2.0 + 0.5 * i;
    curl.push_back({50.0 + radius * std::cos(0.25 * i), 50.0 + radius * std::sin(0.25 * i)});
  }
  expect_band(curl, 14.0);
}

TEST(Band, TranslucentBendsBlendOnce) {
  std::vector<Vec2> wave;
  for (int i = 0; i <= 50; ++i) wave.push_back({10.0 + 1.6 * i, 50.0 + 20.0 * std::sin(0.1 * i)});
  for (const auto& line : {wave, std::vector<Vec2>{{10.0, 15.0}, {85.0, 20.0}, {45.0, 85.0}}}) {
    const Raster raster = drawn_band(line, 9.0, {0, 0, 255, 128});
    EXPECT_EQ(*std::max_element(raster.pixels().begin(), raster.pixels().end()), 128U);
  }
}

TEST(Band, ThinBandsKeepTheirTotalCover) {
  for (const double width : {0.2, 0.6, 1.0, 2.5}) {
    const Raster raster = drawn_band({{-50.0, 13.3}, {150.0, 60.9}}, width, {0, 0, 255});
    double sum = 0.0;
    for (const std::uint32_t p : raster.pixels()) sum += p / 255.0;
    const double along = length(Vec2{200.0, 47.6}) / 2.0;
    EXPECT_NEAR(sum, width * along, 0.03 * width * along) << width;
  }
}

TEST(Band, LengthRunsAlongTheImageAndWidthAcrossIt) {
  TexturedMesh mesh;
  add_band(mesh, std::vector<Vec2>{{10.0, 50.0}, {40.0, 50.0}, {40.0, 50.0}, {90.0, 50.0}}, {20.0, 0.1, 3.0});
  for (const TexturedVertex& v : mesh.vertices) {
    EXPECT_NEAR(v.uv.x, 3.0 + 0.1 * (v.at.x - 10.0), 1e-12);
    EXPECT_NEAR(v.uv.y, (v.at.y - 40.0) / 20.0, 1e-12);
  }
  ASSERT_FALSE(mesh.indices.empty());
}

TEST(Band, EachPointHasItsColour) {
  const std::vector<Vec2> line{{10.0, 50.0}, {50.0, 50.0}, {90.0, 50.0}};
  const std::vector<Color> colors{{0, 0, 0}, {0, 0, 200}, {0, 0, 100}};
  TexturedMesh mesh;
  BandLook look{20.0};
  look.colors = colors;
  add_band(mesh, line, look);
  Raster raster(100, 100);
  raster.fill(mesh, {});
  EXPECT_NEAR(blue(raster, 30, 50), 100, 3);
  EXPECT_NEAR(blue(raster, 50, 50), 200, 5);
  EXPECT_NEAR(blue(raster, 70, 50), 150, 3);
}

/// The middle line of a band without round corners, from its cross-sections of four vertices.
std::vector<Vec2> middle_line(const TexturedMesh& mesh) {
  std::vector<Vec2> line;
  for (std::size_t k = 0; k + 3 < mesh.vertices.size(); k += 4)
    line.push_back(0.5 * (mesh.vertices[k + 1].at + mesh.vertices[k + 2].at));
  return line;
}

TEST(Band, AStraightLineOfManyPointsIsOnePiece) {
  std::vector<Vec2> many;
  for (int k = 0; k <= 100; ++k) many.push_back({10.0 + 3.0 * k, 20.0 + 2.0 * k});
  TexturedMesh mesh;
  TexturedMesh of_two;
  add_band(mesh, many, {.width = 6.0});
  add_band(of_two, std::vector{many.front(), many.back()}, {.width = 6.0});
  EXPECT_EQ(mesh.indices.size(), of_two.indices.size());
}

TEST(Band, LeavesOutOnlyWhatIsNotVisible) {
  std::vector<Vec2> curve;
  for (int k = 0; k <= 300; ++k) {
    const double x = 3.0 * k;
    curve.push_back({x, 200.0 + 12.0 * std::sin(0.012 * x)});
  }
  TexturedMesh mesh;
  add_band(mesh, curve, {.width = 6.0});
  const std::vector<Vec2> middle = middle_line(mesh);
  EXPECT_LT(middle.size(), curve.size() / 2);
  for (const Vec2 p : curve) EXPECT_LT(distance_to_path(p, middle), 0.035) << p.x;
}

TEST(Band, ALineThatTurnsBackReachesItsFarthestPoint) {
  TexturedMesh mesh;
  add_band(mesh, std::vector<Vec2>{{10.0, 50.0}, {40.0, 50.0}, {80.0, 50.0}, {60.0, 50.0}, {30.0, 50.0}},
           {.width = 6.0});
  double most = 0.0;
  for (const TexturedVertex& v : mesh.vertices) most = std::max(most, v.at.x);
  EXPECT_GE(most, 80.0);
}

TEST(Band, DegenerateInputDrawsNothing) {
  TexturedMesh mesh;
  const std::vector<Vec2> good{{10.0, 50.0}, {90.0, 50.0}};
  add_band(mesh, {}, {5.0});
  add_band(mesh, std::vector<Vec2>(4, Vec2{3.0, 3.0}), {5.0});
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) add_band(mesh, good, {bad});
  for (const double bad : {infinity, std::nan(""), 1e300})
    add_band(mesh, std::vector<Vec2>{{bad, 3.0}, {5.0, 6.0}}, {5.0});
  BandLook miscounted{5.0};
  const std::vector<Color> one(1);
  miscounted.colors = one;
  add_band(mesh, good, miscounted);
  EXPECT_TRUE(mesh.indices.empty());
}

}  // namespace
}  // namespace engine
