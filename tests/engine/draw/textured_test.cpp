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
#include "tests/engine/draw/blue.h"
#include "tests/support/constants.h"
#include "tests/support/pixels.h"
#include "tests/support/points.h"

namespace engine {
namespace {

using ribbon::Vec2;
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
