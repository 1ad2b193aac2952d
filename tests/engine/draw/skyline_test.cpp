#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/window/sdl_canvas.h"
#include "tests/support/pixels.h"

namespace engine {
namespace {

using ribbon::Vec2;
using test_support::pixel;

constexpr Color grey{100, 100, 100};
constexpr std::uint32_t filled = 0x646464U;
constexpr std::uint32_t empty = 0U;

SkylineLook plain() {
  SkylineLook look;
  look.upper = look.lower = grey;
  return look;
}

TEST(Skyline, FillsWhatIsBelowTheLine) {
  HeadlessCanvas canvas(40, 30);
  canvas.skyline(std::array{Vec2{-5.0, 10.25}, Vec2{50.0, 10.25}}, plain());
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 30; ++y) {
      if (y == 10) continue;
      EXPECT_EQ(pixel(canvas.raster(), x, y), y < 10 ? empty : filled) << x << " " << y;
    }
    EXPECT_EQ(pixel(canvas.raster(), x, 10), 0x4b4b4bU) << x;  // three quarters
  }
}

TEST(Skyline, FillsWhatIsAboveTheLine) {
  HeadlessCanvas canvas(40, 30);
  SkylineLook look = plain();
  look.is_above = true;
  canvas.skyline(std::array{Vec2{-5.0, 10.25}, Vec2{50.0, 10.25}}, look);
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 30; ++y) {
      if (y == 10) continue;
      EXPECT_EQ(pixel(canvas.raster(), x, y), y < 10 ? filled : empty) << x << " " << y;
    }
    EXPECT_EQ(pixel(canvas.raster(), x, 10), 0x191919U) << x;  // a quarter
  }
}

/// The area below any line, from the sum of all pixels.
TEST(Skyline, HasTheAreaBelowTheLine) {
  HeadlessCanvas canvas(200, 100);
  std::vector<Vec2> line;
  for (int k = 0; k <= 20; ++k) line.push_back({10.0 * k, 50.0 + 30.0 * std::sin(0.7 * k)});
  SkylineLook look;
  look.upper = look.lower = {255, 255, 255};
  canvas.skyline(line, look);
  double sum = 0.0;
  for (const std::uint32_t p : canvas.raster().pixels()) sum += (p & 0xffU) / 255.0;
  double area = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) area += 10.0 * (100.0 - 0.5 * (line[k].y + line[k - 1].y));
  EXPECT_NEAR(sum, area, 0.005 * area);
}

TEST(Skyline, EndsWhereItIsTold) {
  HeadlessCanvas canvas(40, 30);
  SkylineLook look = plain();
  look.end = 20.0;
  canvas.skyline(std::array{Vec2{0.0, 5.0}, Vec2{40.0, 5.0}}, look);
  EXPECT_EQ(pixel(canvas.raster(), 7, 19), filled);
  EXPECT_EQ(pixel(canvas.raster(), 7, 20), empty);
}

TEST(Skyline, HasAVerticalGradient) {
  HeadlessCanvas canvas(4, 100);
  SkylineLook look;
  look.bottom = 100.0;
  look.lower = {200, 100, 0};
  canvas.skyline(std::array{Vec2{0.0, 0.0}, Vec2{4.0, 0.0}}, look);
  for (int y = 0; y < 100; ++y) EXPECT_NEAR(pixel(canvas.raster(), 2, y) >> 16U, 2.0 * (y + 0.5), 1.5) << y;
}

/// Lines beside the canvas, above and below it.
TEST(Skyline, IsClipped) {
  HeadlessCanvas canvas(40, 30);
  canvas.skyline(std::array{Vec2{-9.0, 400.0}, Vec2{90.0, 400.0}}, plain());
  canvas.skyline(std::array{Vec2{50.0, 5.0}, Vec2{90.0, 5.0}}, plain());
  for (const std::uint32_t p : canvas.raster().pixels()) ASSERT_EQ(p, empty);
  canvas.skyline(std::array{Vec2{-1e9, -1e9}, Vec2{1e9, -1e9}}, plain());
  for (const std::uint32_t p : canvas.raster().pixels()) ASSERT_EQ(p, filled);
}

TEST(Skyline, DrawsNothingForBadNumbers) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  HeadlessCanvas canvas(40, 30);
  SkylineLook flat = plain();
  flat.bottom = flat.top;
  canvas.skyline(std::array{Vec2{0.0, 0.0}, Vec2{40.0, nan}}, plain());
  canvas.skyline(std::array{Vec2{40.0, 0.0}, Vec2{0.0, 0.0}}, plain());
  canvas.skyline(std::array{Vec2{40.0, 0.0}}, plain());
  canvas.skyline({}, plain());
  canvas.skyline(std::array{Vec2{0.0, 0.0}, Vec2{40.0, 0.0}}, flat);
  for (const std::uint32_t p : canvas.raster().pixels()) ASSERT_EQ(p, empty);
}

TEST(HeadlessCanvas, RecallsTheUpperRows) {
  HeadlessCanvas canvas(8, 6);
  EXPECT_FALSE(canvas.recall(3, 6));
  canvas.clear({10, 10, 10});
  canvas.remember(3);
  canvas.clear({20, 20, 20});
  EXPECT_FALSE(canvas.recall(4, 6));
  EXPECT_TRUE(canvas.recall(3, 2));
  EXPECT_EQ(pixel(canvas.raster(), 5, 1), 0x0a0a0aU);
  EXPECT_EQ(pixel(canvas.raster(), 5, 2), 0x141414U);
  EXPECT_TRUE(canvas.recall(3, 600));
  EXPECT_EQ(pixel(canvas.raster(), 5, 5), 0x0a0a0aU);
  canvas.resize(9, 6);
  EXPECT_FALSE(canvas.recall(3, 6));
}

}  // namespace
}  // namespace engine
