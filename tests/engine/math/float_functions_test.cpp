#include "engine/math/float_functions.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace engine {
namespace {

constexpr std::uint32_t infinity_bits = 0x7f800000U;

std::uint32_t bits_of(float x) { return std::bit_cast<std::uint32_t>(x); }

/// Rounds what a function of the C library returns for long double. `is_certain` becomes false if a number within its
/// error, which is below 2⁻⁶¹ of it, rounds to another float: then the test has to fail, for it does not know.
float rounded(long double value, bool& is_certain) {
  const long double error = 0x1p-61L * value;
  is_certain = static_cast<float>(value - error) == static_cast<float>(value + error);
  return static_cast<float>(value);
}

void expect_nearest_sines(float x) {
  bool certain_sine = false, certain_cosine = false;
  const float sine = rounded(std::sin(static_cast<long double>(x)), certain_sine);
  const float cosine = rounded(std::cos(static_cast<long double>(x)), certain_cosine);
  const bool linear = std::abs(x) < 0x1p-20F;  // there x − x³/6 rounds to x, which is midway for no error
  const SineCosine both = correct_sine_cosine(x);
  const bool good = (certain_sine || linear) && (certain_cosine || linear) && correct_sine(x) == sine &&
                    correct_cosine(x) == cosine && both.sine == sine && both.cosine == cosine;
  if (!good) ADD_FAILURE() << std::hexfloat << x << ": " << correct_sine(x) << " " << correct_cosine(x);
}

TEST(FloatFunctions, SinesAreTheNearestFloats) {
  for (std::uint32_t bits = 0; bits < infinity_bits; bits += 9973U) {
    expect_nearest_sines(std::bit_cast<float>(bits));
    expect_nearest_sines(-std::bit_cast<float>(bits));
  }
}

// Odd and even functions: the positive floats are enough.
TEST(LongFloatFunctions, SinesOfAllFloatsAreTheNearest) {
  for (std::uint32_t bits = 0; bits < infinity_bits; ++bits) expect_nearest_sines(std::bit_cast<float>(bits));
}

TEST(FloatFunctions, SinesAtTheEdges) {
  EXPECT_EQ(bits_of(correct_sine(-0.0F)), bits_of(-0.0F));
  EXPECT_EQ(correct_cosine(-0.0F), 1.0F);
  for (const float x : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(correct_sine(x)));
    EXPECT_TRUE(std::isnan(correct_cosine(-x)));
    EXPECT_TRUE(std::isnan(correct_sine_cosine(x).cosine));
  }
}

void expect_nearest_angle(float y, float x) {
  bool is_certain = false;
  const float angle = rounded(std::atan2(static_cast<long double>(y), static_cast<long double>(x)), is_certain);
  if (!is_certain || bits_of(correct_atan2(y, x)) != bits_of(angle))
    ADD_FAILURE() << std::hexfloat << y << ", " << x << ": " << correct_atan2(y, x) << " is not " << angle;
}

TEST(FloatFunctions, AnglesOfRandomFloatsAreTheNearest) {
  std::mt19937 random(1);
  for (int k = 0; k < 300000; ++k) {
    // Floats of all sizes, most of whose angles are near an axis, and vectors of similar coordinates.
    const auto y = static_cast<std::uint32_t>(random());
    const auto x = static_cast<std::uint32_t>(random());
    const bool finite = (y & infinity_bits) != infinity_bits && (x & infinity_bits) != infinity_bits;
    // Below 2⁻¹²⁶ an angle has few bits and is often exactly midway, where long double does not see the rest.
    const float ratio = std::abs(std::bit_cast<float>(y) / std::bit_cast<float>(x));
    if (finite && (ratio > 0x1p-100F || std::signbit(std::bit_cast<float>(x))))
      expect_nearest_angle(std::bit_cast<float>(y), std::bit_cast<float>(x));
    expect_nearest_angle(static_cast<float>(static_cast<std::int32_t>(y)),
                         static_cast<float>(static_cast<std::int32_t>(x)));
  }
}

// Vectors whose angle is as near to the middle between two floats as a float y allows: 2⁻²⁴ of the distance between
// random angles and theirs.
TEST(FloatFunctions, AnglesNearTheMiddleBetweenFloatsAreTheNearest) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> angles(0.001F, 1.57F);
  std::uniform_real_distribution<float> lengths(1.0F, 2.0F);
  for (int k = 0; k < 300000; ++k) {
    const float angle = angles(random);
    const auto above = static_cast<double>(std::nextafter(angle, 2.0F));
    const double middle = 0.5 * (static_cast<double>(angle) + above);
    const float x = lengths(random);
    const auto y = static_cast<float>(static_cast<double>(x) * std::tan(middle));
    expect_nearest_angle(y, x);
    expect_nearest_angle(-y, -x);
    expect_nearest_angle(x, y);
  }
}

TEST(FloatFunctions, AnglesMidwayBetweenSubnormalFloatsRoundToZero) {
  const float least = std::numeric_limits<float>::denorm_min();
  for (int k = 0; k < 1000; ++k) {
    const float y = least * static_cast<float>(2 * k + 1);  // y/2 is midway, and its angle a little less
    EXPECT_EQ(bits_of(correct_atan2(y, 2.0F)), static_cast<std::uint32_t>(k));
    EXPECT_EQ(bits_of(correct_atan2(-y, 2.0F)), static_cast<std::uint32_t>(k) | 0x80000000U);
  }
}

TEST(FloatFunctions, AnglesAtTheEdges) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float y : {0.0F, -0.0F, 1.0F, -1.0F, infinity, -infinity}) {
    for (const float x : {0.0F, -0.0F, 1.0F, -1.0F, infinity, -infinity}) {
      const double angle = std::atan2(static_cast<double>(y), static_cast<double>(x));
      EXPECT_EQ(bits_of(correct_atan2(y, x)), bits_of(static_cast<float>(angle))) << y << ", " << x;
    }
    EXPECT_TRUE(std::isnan(correct_atan2(y, std::numeric_limits<float>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(correct_atan2(std::numeric_limits<float>::quiet_NaN(), y)));
  }
}

}  // namespace
}  // namespace engine
