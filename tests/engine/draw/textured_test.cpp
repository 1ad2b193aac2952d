#include "engine/draw/textured_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "engine/draw/canvas_raster.h"
#include "engine/draw/pixel_pairs.h"
#include "tests/support/constants.h"
#include "tests/support/pixels.h"
#include "tests/support/points.h"

namespace engine {
namespace {

using ribbon::Vec2;
using test_support::distance_to_path;
using test_support::pixel;

constexpr Color white{255, 255, 255};
using constants::infinity;

/// Four corners around a rectangle, with the whole image on it.
TexturedMesh rectangle(Vec2 from, Vec2 to, Color color = white) {
  TexturedMesh mesh;
  mesh.vertices = {{from, {0.0, 0.0}, color},
                   {{to.x, from.y}, {1.0, 0.0}, color},
                   {to, {1.0, 1.0}, color},
                   {{from.x, to.y}, {0.0, 1.0}, color}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

int blue(const Raster& raster, int x, int y) { return static_cast<int>(pixel(raster, x, y) & 0xffU); }

/// 0 … 255 from left to right in red, from top to bottom in green.
Image ramps(int side, Mipmaps mipmaps = Mipmaps::no) {
  std::vector<Color> pixels;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      pixels.push_back(
          {static_cast<std::uint8_t>(255 * x / (side - 1)), static_cast<std::uint8_t>(255 * y / (side - 1)), 0});
  return {side, side, pixels, mipmaps};
}

TEST(Textured, TrianglesThatShareEdgesBlendEachPixelOnce) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> somewhere(-20.0, 120.0);
  for (int attempt = 0; attempt < 200; ++attempt) {
    // A fan around a point in the middle covers the whole picture.
    TexturedMesh mesh;
    const Color half{0, 0, 255, 128};
    mesh.vertices.push_back({{0.5 * somewhere(random), 0.5 * somewhere(random)}, {}, half});
    std::vector<double> angles;
    for (int k = 0; k < 7; ++k) angles.push_back(0.05 * somewhere(random));
    for (int k = 0; k < 4; ++k) angles.push_back(0.5 * std::numbers::pi * k);
    std::sort(angles.begin(), angles.end(), [](double a, double b) {
      return std::fmod(a + 100.0 * std::numbers::pi, 2.0 * std::numbers::pi) <
             std::fmod(b + 100.0 * std::numbers::pi, 2.0 * std::numbers::pi);
    });
    for (const double angle : angles)
      mesh.vertices.push_back({mesh.vertices[0].at + 500.0 * Vec2{std::cos(angle), std::sin(angle)}, {}, half});
    const int rim = static_cast<int>(angles.size());
    for (int k = 0; k < rim; ++k) mesh.indices.insert(mesh.indices.end(), {0, 1 + k, 1 + (k + 1) % rim});
    Raster raster(64, 64);
    raster.fill(mesh, {});
    for (int i = 0; i < 64 * 64; ++i) ASSERT_EQ(raster.pixels()[static_cast<std::size_t>(i)], 128U) << i;
  }
}

TEST(Textured, AnEdgeThroughPixelMiddlesBelongsToOneSide) {
  const Color half{0, 0, 255, 128};
  TexturedMesh mesh = rectangle({2.5, 2.5}, {6.5, 6.5}, half);
  const TexturedMesh right = rectangle({6.5, 2.5}, {9.5, 6.5}, half);
  for (const TexturedVertex& v : right.vertices) mesh.vertices.push_back(v);
  for (const int i : right.indices) mesh.indices.push_back(i + 4);
  Raster raster(12, 12);
  raster.fill(mesh, {});
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x)
      EXPECT_EQ(blue(raster, x, y), x >= 2 && x < 9 && y >= 2 && y < 6 ? 128 : 0) << x << ' ' << y;
}

TEST(Textured, NearestFilteringKeepsTexelsUnchanged) {
  const Image image = ramps(32);
  Raster raster(40, 40);
  raster.fill(rectangle({3.0, 5.0}, {35.0, 37.0}), {&image, Filter::nearest, Wrap::clamp, Wrap::clamp});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      ASSERT_EQ(pixel(raster, x + 3, y + 5), static_cast<std::uint32_t>(255 * x / 31 * 65536 + 255 * y / 31 * 256));
}

TEST(Textured, LinearFollowsTheRampWithinALevel) {
  const Image image = ramps(256);
  Raster raster(320, 320);
  TexturedMesh mesh;  // turned and stretched
  mesh.vertices = {{{10.0, 20.0}, {0.1, 0.1}}, {{300.0, 60.0}, {0.9, 0.2}}, {{60.0, 310.0}, {0.2, 0.95}}};
  mesh.indices = {0, 1, 2};
  raster.fill(mesh, {&image, Filter::linear, Wrap::clamp, Wrap::clamp});
  int seen = 0;
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 320; ++x) {
      const Vec2 p{x + 0.5 - 10.0, y + 0.5 - 20.0};
      const double det = cross(Vec2{290.0, 40.0}, Vec2{50.0, 290.0});
      const double s = cross(p, {50.0, 290.0}) / det;
      const double t = cross({290.0, 40.0}, p) / det;
      if (s < 0.01 || t < 0.01 || s + t > 0.99) continue;
      ++seen;
      const double u = 0.1 + 0.8 * s + 0.1 * t;
      const double v = 0.1 + 0.1 * s + 0.85 * t;
      ASSERT_NEAR(pixel(raster, x, y) >> 16U & 0xffU, 256.0 * u - 0.5, 1.2);
      ASSERT_NEAR(pixel(raster, x, y) >> 8U & 0xffU, 256.0 * v - 0.5, 1.2);
    }
  EXPECT_GT(seen, 30000);
}

TEST(Textured, OutsideTheImageRepeatsOrClampsIt) {
  const Image image = ramps(8);
  TexturedMesh mesh = rectangle({0.0, 0.0}, {32.0, 32.0});
  for (TexturedVertex& v : mesh.vertices) v.uv = 4.0 * v.uv - Vec2{2.0, 1.0};
  Raster repeated(32, 32);
  repeated.fill(mesh, {&image, Filter::nearest, Wrap::repeat, Wrap::clamp});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      ASSERT_EQ(pixel(repeated, x, y) >> 16U, static_cast<unsigned>(255 * (x % 8) / 7));
      ASSERT_EQ(pixel(repeated, x, y) >> 8U & 0xffU, static_cast<unsigned>(255 * std::clamp(y - 8, 0, 7) / 7));
    }
}

TEST(Textured, ClipsToTheRectangleAndThePicture) {
  for (const PixelBox& clip : {PixelBox{-5, 3, 7, 400}, PixelBox{2, -9, 2, 9}, PixelBox{30, 30, 10, 10}, PixelBox{}}) {
    Raster raster(16, 12);
    raster.fill(rectangle({-50.0, -50.0}, {50.0, 50.0}, {0, 0, 255}), {}, clip);
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 16; ++x) {
        const bool inside = x >= clip.left && x < clip.right && y >= clip.top && y < clip.bottom;
        ASSERT_EQ(blue(raster, x, y), inside ? 255 : 0) << x << ' ' << y;
      }
  }
}

TEST(Textured, ColoursOfTheCornersMixAndMultiplyTheImage) {
  TexturedMesh mesh = rectangle({0.0, 0.0}, {256.0, 4.0});
  for (TexturedVertex& v : mesh.vertices) v.color = v.uv.x == 0.0 ? Color{0, 0, 0} : Color{0, 0, 255};
  const std::vector<Color> half{{255, 255, 128}};
  const Image image(1, 1, half);
  Raster plain(256, 4);
  plain.fill(mesh, {});
  Raster tinted(256, 4);
  tinted.fill(mesh, {&image});
  for (int x = 0; x < 256; ++x) {
    ASSERT_NEAR(blue(plain, x, 2), x, 1.0);
    ASSERT_NEAR(blue(tinted, x, 2), 0.5 * x, 1.5);
  }
}

TEST(Textured, ATranslucentTexelIsBlendedWithTheBackground) {
  const Image image(1, 1, std::vector<Color>{{255, 0, 0, 64}});
  Raster raster(4, 4);
  raster.fill_row(1, 0x0000ff);
  raster.fill(rectangle({0.0, 0.0}, {4.0, 4.0}), {&image});
  EXPECT_NEAR(pixel(raster, 1, 1) >> 16U, 64.0, 1.0);
  EXPECT_NEAR(blue(raster, 1, 1), 191.0, 1.0);
  EXPECT_NEAR(pixel(raster, 1, 2) >> 16U, 64.0, 1.0);
}

/// A reduced checkerboard with mipmaps is grey and keeps its mean brightness.
TEST(Textured, ASmallPictureOfAFinePatternIsItsMean) {
  std::vector<Color> checks;
  for (int i = 0; i < 64 * 64; ++i) checks.push_back((i + i / 64) % 2 == 0 ? Color{0, 0, 255} : Color{0, 0, 0});
  const Image image(64, 64, checks);
  Raster raster(8, 8);
  raster.fill(rectangle({0.3, 0.3}, {7.7, 7.7}), {&image});
  for (int y = 1; y < 7; ++y)
    for (int x = 1; x < 7; ++x) EXPECT_NEAR(blue(raster, x, y), 128, 2);
}

TEST(Textured, RefusesAnInvalidImage) {
  const std::vector<Color> twelve(12);
  EXPECT_THROW(Image(3, 4, twelve), std::invalid_argument);
  EXPECT_THROW(Image(4, 4, twelve), std::invalid_argument);
  EXPECT_THROW(Image(0, 4, {}), std::invalid_argument);
  EXPECT_THROW(Image(8192, 1, std::vector<Color>(8192)), std::invalid_argument);
}

TEST(Textured, RecognisesAnInvalidMesh) {
  TexturedMesh mesh = rectangle({0.0, 0.0}, {4.0, 4.0});
  EXPECT_TRUE(is_paintable(mesh));
  for (const double bad : {infinity, std::nan(""), 1e300}) {
    TexturedMesh broken = mesh;
    broken.vertices[2].at.x = bad;
    EXPECT_FALSE(is_paintable(broken));
    broken = mesh;
    broken.vertices[1].uv.y = bad;
    EXPECT_FALSE(is_paintable(broken));
    broken = mesh;
    broken.vertices[0].cover = bad;
    EXPECT_FALSE(is_paintable(broken));
  }
  mesh.indices.back() = 4;
  EXPECT_FALSE(is_paintable(mesh));
}

/// Slivers and far corners have steep planes. Nothing may exceed the picture or its channel.
TEST(Textured, SliversAndFarCornersKeepWithinTheirColours) {
  const Image image = ramps(16, Mipmaps::yes);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> near(-2.0, 18.0);
  std::uniform_real_distribution<double> exponent(-9.0, 9.0);
  for (int attempt = 0; attempt < 3000; ++attempt) {
    TexturedMesh mesh;
    for (int k = 0; k < 3; ++k) {
      const double far = std::pow(10.0, exponent(random));
      mesh.vertices.push_back({{near(random) + (attempt % 3 == k ? far : 0.0), near(random)},
                               {5e4 * near(random), near(random)},
                               {0, 0, static_cast<std::uint8_t>(100 * (k % 2)), 255},
                               0.5 * (k % 3)});
    }
    if (attempt % 2 == 0)
      mesh.vertices[2].at = mesh.vertices[1].at + Vec2{std::pow(10.0, exponent(random) - 9.0), 1e-9};
    mesh.indices = {0, 1, 2};
    ASSERT_TRUE(is_paintable(mesh));
    Raster raster(16, 16);
    raster.fill(mesh, {});
    for (const std::uint32_t p : raster.pixels()) ASSERT_LE(p, 100U);
    raster.fill(mesh, {&image});
    for (const std::uint32_t p : raster.pixels()) ASSERT_LE(p >> 24U, 0U);
  }
}

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

/// An image without interpolation is copied where a texel covers a pixel, and blended where it is translucent.
TEST(Textured, CopiesTexelsAtTheirOwnSize) {
  std::vector<Color> texels;
  for (int k = 0; k < 64; ++k)
    texels.push_back({static_cast<std::uint8_t>(3 * k), 90, 7,
                      static_cast<std::uint8_t>(k % 3 == 0   ? 255
                                                : k % 3 == 1 ? 0
                                                             : 128)});
  const Image image(8, 8, texels, Mipmaps::no);
  Raster raster(20, 20);
  raster.fill(rectangle({5.0, 6.0}, {13.0, 14.0}), {&image, Filter::nearest, Wrap::clamp, Wrap::clamp});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const Color c = texels[8 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)];
      const int red = static_cast<int>(pixel(raster, 5 + x, 6 + y) >> 16U);
      EXPECT_NEAR(red, c.r * c.a / 255.0, 1.0) << x << " " << y;
    }
  }
  EXPECT_EQ(pixel(raster, 4, 7), 0U);
  EXPECT_EQ(pixel(raster, 13, 7), 0U);
}

/// One translucent texel far from what is drawn makes the image go the general way, with the same colours.
TEST(Textured, OpaqueImagesHaveTheColoursOfTheGeneralWay) {
  std::vector<Color> texels;
  for (int k = 0; k < 64 * 64; ++k)
    texels.push_back(
        {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(7 * k), static_cast<std::uint8_t>(k / 16)});
  const Image opaque(64, 64, texels, Mipmaps::no);
  texels.back().a = 254;
  const Image general(64, 64, texels, Mipmaps::no);
  EXPECT_TRUE(opaque.is_opaque());
  EXPECT_FALSE(general.is_opaque());
  Raster a(50, 40);
  Raster b(50, 40);
  TexturedMesh mesh = rectangle({-3.0, -2.0}, {60.0, 45.0});
  for (TexturedVertex& v : mesh.vertices) v.uv = 0.7 * v.uv + Vec2{0.1, 0.1};
  for (const std::uint8_t light : {std::uint8_t{255}, std::uint8_t{120}}) {
    mesh.vertices[2].color = mesh.vertices[3].color = {light, light, light};
    a.fill(mesh, {&opaque, Filter::nearest});
    b.fill(mesh, {&general, Filter::nearest});
    EXPECT_EQ(a.pixels(), b.pixels());
  }
}

/// A row that leaves the image is sampled in another way than one that stays inside.
TEST(Textured, ARowHasTheSameColoursWhetherItLeavesTheImageOrNot) {
  const Image image = ramps(64);
  TexturedMesh mesh;  // turned, from half an image before it to half an image behind it
  mesh.vertices = {{{0.0, 30.0}, {-0.5, -0.5}},
                   {{170.0, 0.0}, {1.5, -0.5}},
                   {{200.0, 170.0}, {1.5, 1.5}},
                   {{30.0, 200.0}, {-0.5, 1.5}}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    Raster whole(200, 200);
    Raster middle(200, 200);
    whole.fill(mesh, {&image, Filter::linear, wrap, wrap});
    middle.fill(mesh, {&image, Filter::linear, wrap, wrap}, {85, 85, 115, 115});
    for (int y = 85; y < 115; ++y) {
      for (int x = 85; x < 115; ++x) {
        for (const unsigned shift : {8U, 16U})
          EXPECT_NEAR(pixel(whole, x, y) >> shift & 0xffU, pixel(middle, x, y) >> shift & 0xffU, 1.0) << x << " " << y;
      }
    }
  }
}

/// Repeated images are the same at a whole number of images from their start.
/// A copy far from the image is the image, which a clamped texture has only once. Its seams are outside.
TEST(Textured, FarCopiesOfAnImageAreTheSame) {
  const Image image = ramps(32);
  for (const double far_away : {-5.0, 7.0, 4096.0, -100'000.0}) {
    Raster once(60, 60);
    Raster far(60, 60);
    TexturedMesh mesh = rectangle({3.0, 4.0}, {55.0, 57.0});
    mesh.vertices[1].at.y += 2.0;  // turned a little, so that rows are not rows of the image
    for (TexturedVertex& v : mesh.vertices) v.uv = 0.8 * v.uv + Vec2{0.1, 0.1};
    once.fill(mesh, {&image, Filter::linear, Wrap::clamp, Wrap::clamp});
    for (TexturedVertex& v : mesh.vertices) v.uv += Vec2{far_away, -far_away};
    far.fill(mesh, {&image, Filter::linear});
    EXPECT_EQ(once.pixels(), far.pixels()) << far_away;
  }
}

TEST(PixelPairs, FourPixelsBlendLikePairs) {
  for (std::uint32_t alpha = 0; alpha < 256; ++alpha) {
    for (std::uint32_t below = 0; below < 256; below += 5) {
      const std::uint32_t color = alpha << 24U | alpha / 2 << 16U | alpha << 8U | alpha / 3;
      const Four four = {color, color / 2 & 0x7f7f7f7fU, 0xff102030U, 0U};
      const Four pixels = {below << 16U | (255 - below) << 8U | below, below, 0xffffffU, below << 8U};
      const Four expected =
          joined(over(lower_pair(four), lower_pair(pixels)), over(upper_pair(four), upper_pair(pixels)));
      const Four blended = over(four, pixels);
      for (std::size_t k = 0; k < 4; ++k)
        ASSERT_EQ(blended[k] & 0xffffffU, expected[k] & 0xffffffU) << alpha << " " << below << " " << k;
    }
  }
}

TEST(Image, IsMadeOfPremultipliedPixels) {
  const Image image = Image::of_premultiplied(2, 1, {0x80402010U, 0xff123456U});
  EXPECT_FALSE(image.is_opaque());
  EXPECT_EQ(image.level(1.0).pixels[0], 0x80402010U);
  EXPECT_THROW(Image::of_premultiplied(3, 1, {0U, 0U, 0U}), std::invalid_argument);
  EXPECT_THROW(Image::of_premultiplied(2, 2, {0U}), std::invalid_argument);
}

}  // namespace
}  // namespace engine
