#include "engine/draw/canvas.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "tests/engine/draw/mesh_cover.h"
#include "tests/support/constants.h"

namespace engine {
namespace {

using constants::infinity;
using constants::nan;

/// Records what it is asked to paint.
class RecordingCanvas : public Canvas {
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
  std::vector<TexturedMesh> textured_meshes;
  std::vector<Text> texts;
  std::vector<Color> backgrounds;

 protected:
  void paint_background(Color top, Color bottom) override { backgrounds = {top, bottom}; }
  void paint_mesh(const Mesh& mesh, Color) override { meshes.push_back(mesh); }
  void paint_textured(const TexturedMesh& mesh, const Texture&, const PixelBox&) override {
    textured_meshes.push_back(mesh);
  }
  void paint_text(Vec2 at, std::string_view utf8, double, Color) override { texts.push_back({at, std::string(utf8)}); }
};

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
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    canvas.polyline(good, bad, red);
    canvas.circle({0.0, 0.0}, bad, red);
    canvas.ring({0.0, 0.0}, bad, 0.1, red);
    canvas.ring({0.0, 0.0}, 0.1, bad, red);
    canvas.panel({0.0, 0.0}, {bad, 10.0}, 2.0, red);
    canvas.text({0.0, 0.0}, "x", bad, red);
  }
  for (const double bad : {nan, infinity, -infinity, 1e300}) {
    auto broken = good;
    broken[1].y = bad;
    canvas.polyline(broken, 0.1, red);
    canvas.polygon(broken, red);
    canvas.triangles(broken, std::vector<int>{0, 1, 2}, red);
    canvas.circle({bad, 0.0}, 0.1, red);
    canvas.ring({0.0, bad}, 0.1, 0.01, red);
    canvas.panel({bad, 0.0}, {10.0, 10.0}, 2.0, red);
  }
  canvas.text({nan, 0.0}, "x", 12.0, red);
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
  add_convex(mesh, std::vector<Vec2>{{-1e11, -1e11}, {1e11, -1e11}, {1e11, 10.0}, {-1e11, 10.0}});
  add_disc(mesh, {1e9, 5.0}, 3.0);
  add_polyline(mesh, std::vector<Vec2>{{-500.0, -400.0}, {-100.0, 9000.0}}, 10.0);
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
  for (const double scale : {0.0, -1.0, nan, infinity})
    EXPECT_THROW(canvas.set_view({{0.0, 0.0}, scale}), std::invalid_argument);
  EXPECT_THROW(canvas.set_view({{nan, 0.0}, 50.0}), std::invalid_argument);
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

}  // namespace
}  // namespace engine
