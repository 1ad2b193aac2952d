#include "engine/draw/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"

using engine::Align;
using engine::Color;
using engine::Mesh;
using engine::MeshBar;
using engine::MeshRing;
using engine::MeshVertex;
using engine::Raster;
using ribbon::Vec2;
using test_support::distance_to_path;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
using constants::infinity;
constexpr double pi = std::numbers::pi;

/// Records what it is asked to paint.
class RecordingCanvas : public engine::Canvas {
 public:
  int width() const override { return 200; }
  int height() const override { return 100; }
  double text_width(std::string_view utf8, double size) const override {
    return static_cast<double>(utf8.size()) * size / 2.0;
  }
  double line_height(double size) const override { return size; }

  struct Text {
    Vec2 at;
    std::string utf8;
  };
  std::vector<Mesh> meshes;
  std::vector<engine::TexturedMesh> textured_meshes;
  std::vector<Text> texts;
  std::vector<Color> backgrounds;

 protected:
  void paint_background(Color top, Color bottom) override { backgrounds = {top, bottom}; }
  void paint_mesh(const Mesh& mesh, Color) override { meshes.push_back(mesh); }
  void paint_textured(const engine::TexturedMesh& mesh, const engine::Texture&, const engine::PixelBox&) override {
    textured_meshes.push_back(mesh);
  }
  void paint_text(Vec2 at, std::string_view utf8, double, Color) override { texts.push_back({at, std::string(utf8)}); }
};

double triangle_area(Vec2 a, Vec2 b, Vec2 c) { return 0.5 * cross(b - a, c - a); }

template <typename Use>
void each_triangle(const Mesh& mesh, Use use) {
  const auto vertex = [&](std::size_t i) { return mesh.vertices.at(static_cast<std::size_t>(mesh.indices[i])); };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) use(vertex(i), vertex(i + 1), vertex(i + 2));
}

/// Returns the cover of the mesh at a point: the largest of all shapes over it.
double cover_at(const Mesh& mesh, Vec2 p) {
  double most = 0.0;
  for (const MeshBar& bar : mesh.bars) {
    const Vec2 piece = bar.to - bar.from;
    const double along = dot(p - bar.from, piece) / dot(piece, piece);
    if (along < 0.0 || along > 1.0) continue;
    most = std::max(most, bar.profile.at(std::abs(cross(piece, p - bar.from)) / length(piece)));
  }
  for (const MeshRing& ring : mesh.rings)
    most = std::max(most, ring.profile.at(std::abs(length(p - ring.center) - ring.radius)));
  each_triangle(mesh, [&](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    const double whole = triangle_area(a.at, b.at, c.at);
    const double wa = triangle_area(p, b.at, c.at) / whole;
    const double wb = triangle_area(a.at, p, c.at) / whole;
    const double wc = 1.0 - wa - wb;
    if (std::min({wa, wb, wc}) < -1e-9) return;
    most = std::max(most, wa * a.cover + wb * b.cover + wc * c.cover);
  });
  return most;
}

/// Returns the covered area of the mesh in pixels, with fractions.
double covered_pixels(const Mesh& mesh, int width, int height) {
  Raster raster(width, height);
  raster.fill(mesh, 0xff, 255);
  double sum = 0.0;
  for (const std::uint32_t pixel : raster.pixels()) sum += (pixel & 0xffU) / 255.0;
  return sum;
}

void expect_sound(const Mesh& mesh) {
  EXPECT_FALSE(mesh.is_empty());
  EXPECT_TRUE(is_paintable(mesh));
  each_triangle(mesh, [](const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    EXPECT_TRUE(is_finite(a.at) && is_finite(b.at) && is_finite(c.at));
    EXPECT_GT(std::abs(triangle_area(a.at, b.at, c.at)), 0.0);
    for (const MeshVertex& v : {a, b, c}) EXPECT_TRUE(v.cover >= 0.0 && v.cover <= 1.0) << v.cover;
  });
}

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

}  // namespace

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
    engine::add_polyline(mesh, std::vector<Vec2>{{-50.0, 13.3}, {150.0, 60.9}}, width);
    const double across = length(Vec2{200.0, 47.6}) / 2.0;  // the part of the line within the 100 pixels
    EXPECT_NEAR(covered_pixels(mesh, 100, 100), width * across, 0.02 * width * across) << width;
  }
}

TEST(CanvasMesh, DiscCoversItsAreaAndNothingBeyondItsBorder) {
  for (const double radius : {2.0, 3.3, 5.5, 20.0, 45.0}) {
    Mesh mesh;
    engine::add_disc(mesh, {50.3, 49.6}, radius);
    expect_sound(mesh);
    EXPECT_NEAR(covered_pixels(mesh, 100, 100), pi * radius * radius, 0.01 * pi * radius * radius) << radius;
    EXPECT_EQ(cover_at(mesh, {50.3 + radius + 1.0, 49.6}), 0.0) << radius;
  }
}

TEST(CanvasMesh, RingIsHollow) {
  Mesh mesh;
  engine::add_ring(mesh, {50.0, 50.0}, 30.0, 4.0);
  expect_sound(mesh);
  EXPECT_EQ(cover_at(mesh, {50.0, 50.0}), 0.0);
  EXPECT_EQ(cover_at(mesh, {80.0, 50.0}), 1.0);
  EXPECT_EQ(cover_at(mesh, {50.0, 83.0}), 0.0);
  EXPECT_NEAR(covered_pixels(mesh, 100, 100), 2.0 * pi * 30.0 * 4.0, 8.0);
}

TEST(CanvasMesh, RingWiderThanItsRadiusIsADisc) {
  Mesh mesh;
  engine::add_ring(mesh, {50.0, 50.0}, 10.0, 30.0);
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
  engine::add_convex(mesh, std::vector<Vec2>{{10.0, 50.0}, {90.0, 50.0}, {90.0, 50.3}, {10.0, 50.3}});
  expect_sound(mesh);
  EXPECT_NEAR(covered_pixels(mesh, 100, 100), 24.0, 0.8);
}

TEST(CanvasMesh, TrianglesHaveARimOnTheirCommonBoundaryOnly) {
  Mesh mesh;
  const std::vector<Vec2> square{{20.0, 20.0}, {60.0, 20.0}, {60.0, 60.0}, {20.0, 60.0}, {40.0, 40.0}};
  engine::add_triangles(mesh, square, std::vector<int>{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4});
  expect_sound(mesh);
  EXPECT_EQ(cover_at(mesh, {40.0, 40.0}), 1.0);
  EXPECT_NEAR(cover_at(mesh, {40.0, 19.5}), 0.5, 1e-9);
  EXPECT_NEAR(cover_at(mesh, {20.0, 61.0}), 0.0, 1e-9);
  EXPECT_EQ(mesh.bars.size(), 4U) << "a rim around the middle";
  for (const MeshRing& ring : mesh.rings) EXPECT_GT(length(ring.center - Vec2{40.0, 40.0}), 15.0);
}

TEST(CanvasMesh, RoundedRectangle) {
  Mesh mesh;
  engine::add_rounded_rectangle(mesh, {10.0, 20.0}, {60.0, 40.0}, 12.0);
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
  engine::add_disc(mesh, {50.0, 50.0}, 40.0);
  engine::add_ring(mesh, {50.0, 50.0}, 40.0, 3.0);
  EXPECT_EQ(mesh.rings.size(), 5U);
  EXPECT_TRUE(mesh.indices.empty());
}

TEST(CanvasMesh, RecognisesInvalidBarsAndRings) {
  const engine::Profile good{1.0, 2.0, 1.0};
  const auto bar = [](Vec2 from, Vec2 to, engine::Profile profile) {
    Mesh mesh;
    mesh.bars.push_back({from, to, profile});
    return is_paintable(mesh);
  };
  const auto ring = [](Vec2 center, double radius, engine::Profile profile) {
    Mesh mesh;
    mesh.rings.push_back({center, radius, profile});
    return is_paintable(mesh);
  };
  EXPECT_TRUE(bar({1.0, 2.0}, {3.0, 4.0}, good));
  EXPECT_FALSE(bar({1.0, 2.0}, {1.0, 2.0}, good));
  EXPECT_FALSE(bar({nan_value, 2.0}, {1.0, 2.0}, good));
  EXPECT_TRUE(ring({1.0, 2.0}, 0.0, good));
  EXPECT_FALSE(ring({1.0, 2.0}, -1.0, good));
  EXPECT_FALSE(ring({infinity, 2.0}, 1.0, good));
  for (const engine::Profile& bad : {engine::Profile{2.0, 2.0, 1.0}, engine::Profile{-1.0, 2.0, 1.0},
                                     engine::Profile{1.0, infinity, 1.0}, engine::Profile{1.0, 2.0, 1.5}}) {
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

TEST(Raster, LinesInAllDirectionsHaveTheCoverOfTheirDistance) {
  for (int k = 0; k < 48; ++k) {  // every sixth is level or upright
    const double angle = pi / 12.0 * k;
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
    engine::add_disc(disc, {31.2, 22.9}, radius);
    expect_cover(disc, 60, 60);
    for (const double width : {0.4, 1.0, 2.5, 9.0}) {
      Mesh ring;
      engine::add_ring(ring, {31.2, 22.9}, radius, width);
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
  engine::add_disc(dot, {2047.5, 4.0}, 2.0);
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

TEST(Canvas, DegenerateInputDrawsNothing) {
  RecordingCanvas canvas;
  const Color red{255, 0, 0};
  const std::vector<Vec2> none;
  const std::vector<Vec2> one{{0.1, 0.1}};
  const std::vector<Vec2> same(5, Vec2{0.1, 0.1});
  const std::vector<Vec2> flat{{0.0, 0.0}, {0.5, 0.5}, {1.0, 1.0}};
  const std::vector<Vec2> good{{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.5}};
  for (const auto& points : {none, one, same}) {
    canvas.polyline(points, 0.1, red);
    canvas.polygon(points, red);
  }
  canvas.polygon(flat, red);
  for (const double bad : {0.0, -1.0, nan_value, infinity}) {
    canvas.polyline(good, bad, red);
    canvas.circle({0.0, 0.0}, bad, red);
    canvas.ring({0.0, 0.0}, bad, 0.1, red);
    canvas.ring({0.0, 0.0}, 0.1, bad, red);
    canvas.panel({0.0, 0.0}, {bad, 10.0}, 2.0, red);
    canvas.text({0.0, 0.0}, "x", bad, red);
  }
  for (const double bad : {nan_value, infinity, -infinity, 1e300}) {
    auto broken = good;
    broken[1].y = bad;
    canvas.polyline(broken, 0.1, red);
    canvas.polygon(broken, red);
    canvas.triangles(broken, std::vector<int>{0, 1, 2}, red);
    canvas.circle({bad, 0.0}, 0.1, red);
    canvas.ring({0.0, bad}, 0.1, 0.01, red);
    canvas.panel({bad, 0.0}, {10.0, 10.0}, 2.0, red);
  }
  canvas.text({nan_value, 0.0}, "x", 12.0, red);
  canvas.text({0.0, 0.0}, "", 12.0, red);
  canvas.triangles(good, std::vector<int>{0, 1, 3}, red);
  canvas.triangles(good, std::vector<int>{0, 1, -1}, red);
  canvas.triangles(good, std::vector<int>{0, 1}, red);
  canvas.triangles(good, std::vector<int>{0, 1, 1}, red);
  canvas.polygon(good, {255, 0, 0, 0});
  EXPECT_TRUE(canvas.meshes.empty());
  EXPECT_TRUE(canvas.texts.empty());
}

TEST(Canvas, ShapesFarOutsideAreHarmless) {
  Raster raster(20, 20);
  Mesh mesh;
  engine::add_convex(mesh, std::vector<Vec2>{{-1e11, -1e11}, {1e11, -1e11}, {1e11, 10.0}, {-1e11, 10.0}});
  engine::add_disc(mesh, {1e9, 5.0}, 3.0);
  engine::add_polyline(mesh, std::vector<Vec2>{{-500.0, -400.0}, {-100.0, 9000.0}}, 10.0);
  raster.fill(mesh, 0xff, 255);
  EXPECT_EQ(raster.pixels()[5 * 20 + 5], 0xffU);
  EXPECT_EQ(raster.pixels()[15 * 20 + 5], 0U);
}

TEST(Canvas, ViewMapsTheCenterToTheMiddleAndUpToUp) {
  RecordingCanvas canvas;
  canvas.set_view({{3.0, -2.0}, 10.0});
  EXPECT_EQ(canvas.to_pixels({3.0, -2.0}), (Vec2{100.0, 50.0}));
  EXPECT_EQ(canvas.to_pixels({4.0, 0.0}), (Vec2{110.0, 30.0}));
  EXPECT_EQ(canvas.to_world({110.0, 30.0}), (Vec2{4.0, 0.0}));
}

TEST(Canvas, RefusesAViewThatShowsNothingAndKeepsTheOldOne) {
  RecordingCanvas canvas;
  canvas.set_view({{1.0, 2.0}, 50.0});
  for (const double scale : {0.0, -1.0, nan_value, infinity})
    EXPECT_THROW(canvas.set_view({{0.0, 0.0}, scale}), std::invalid_argument);
  EXPECT_THROW(canvas.set_view({{nan_value, 0.0}, 50.0}), std::invalid_argument);
  EXPECT_EQ(canvas.view().center, (Vec2{1.0, 2.0}));
  EXPECT_EQ(canvas.view().pixels_per_metre, 50.0);
}

TEST(Canvas, WorldShapesPassThroughTheViewAndPanelsDoNot) {
  RecordingCanvas canvas;
  canvas.set_view({{0.0, 0.0}, 20.0});
  canvas.circle({1.0, 1.0}, 0.5, {});
  canvas.panel({5.0, 5.0}, {30.0, 20.0}, 4.0, {});
  ASSERT_EQ(canvas.meshes.size(), 2U);
  EXPECT_EQ(cover_at(canvas.meshes[0], {120.0, 30.0}), 1.0);
  EXPECT_EQ(cover_at(canvas.meshes[0], {120.0, 41.0}), 0.0);
  EXPECT_EQ(cover_at(canvas.meshes[1], {20.0, 15.0}), 1.0);
}

TEST(Canvas, TextIsAlignedByItsMeasuredWidth) {
  RecordingCanvas canvas;
  for (const Align align : {Align::left, Align::center, Align::right})
    canvas.text({100.0, 7.0}, "four", 10.0, {}, align);
  ASSERT_EQ(canvas.texts.size(), 3U);
  EXPECT_EQ(canvas.texts[0].at, (Vec2{100.0, 7.0}));
  EXPECT_EQ(canvas.texts[1].at, (Vec2{90.0, 7.0}));
  EXPECT_EQ(canvas.texts[2].at, (Vec2{80.0, 7.0}));
}

TEST(Canvas, PlainClearIsAGradientOfOneColour) {
  RecordingCanvas canvas;
  canvas.clear({1, 2, 3});
  EXPECT_EQ(canvas.backgrounds, (std::vector<Color>{{1, 2, 3}, {1, 2, 3}}));
}
