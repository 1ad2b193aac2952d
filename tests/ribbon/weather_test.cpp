#include "ribbon/weather.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "ribbon/definition.h"
#include "tests/support/refusal.h"

namespace ribbon {
namespace {

TEST(WeatherMedium, IsAirAboveAndWaterBelow) {
  WeatherDef def;
  def.wind = {5.0, 1.0};
  def.current = {-1.0, 0.0};
  def.water_level = 2.0;
  const Weather weather(def);
  EXPECT_EQ(weather.def(), def);
  const MediumSample above = weather.at({0.0, 2.2}, 0.1, 0.0);
  EXPECT_EQ(above.density, 1.2);
  EXPECT_EQ(above.velocity, (Vec2{5.0, 1.0}));
  EXPECT_EQ(above.density_gradient, Vec2{});
  const MediumSample below = weather.at({0.0, 1.8}, 0.1, 0.0);
  EXPECT_EQ(below.density, 1000.0);
  EXPECT_EQ(below.velocity, (Vec2{-1.0, 0.0}));
  const MediumSample half = weather.at({0.0, 2.0}, 0.1, 0.0);
  EXPECT_NEAR(half.density, 500.6, 1e-9);
  EXPECT_LT(half.velocity.x, -0.98) << "by the shares of the mass";
}

TEST(WeatherMedium, HasNoWaterByDefault) {
  const Weather weather{WeatherDef{}};
  EXPECT_EQ(weather.at({0.0, -1e9}, 1.0, 0.0).density, 1.2);
}

/// The share of a circle, and its derivative.
TEST(WeatherMedium, PassesThroughTheSurfaceSmoothly) {
  WeatherDef def;
  def.air_density = 0.0;
  def.water_density = 1.0;
  def.water_level = 0.0;
  const Weather weather(def);
  constexpr double radius = 0.3;
  constexpr double small = 1e-6;
  for (double s = -1.1; s < 1.1; s += 0.01) {
    const double inside = std::clamp(s, -1.0, 1.0);
    const double circle = 0.5 + (inside * std::sqrt(1.0 - inside * inside) + std::asin(inside)) / std::numbers::pi;
    const MediumSample sample = weather.at({0.0, -s * radius}, radius, 0.0);
    EXPECT_NEAR(sample.density, circle, 0.013) << s;
    const double change = weather.at({0.0, -s * radius + small}, radius, 0.0).density -
                          weather.at({0.0, -s * radius - small}, radius, 0.0).density;
    EXPECT_NEAR(sample.density_gradient.y, change / (2.0 * small), 1e-4) << s;
  }
}

TEST(WeatherMedium, GustsStayWithinTheirShare) {
  WeatherDef def;
  def.wind = {10.0, 0.0};
  def.gusts = 0.4;
  const Weather weather(def);
  double least = 1e9;
  double most = 0.0;
  double sum = 0.0;
  double before = weather.at({0.0, 0.0}, 0.1, 0.0).velocity.x;
  constexpr int count = 100'000;
  for (int k = 0; k < count; ++k) {
    const double speed = weather.at({0.0, 0.0}, 0.1, 0.01 * k).velocity.x;
    EXPECT_NEAR(speed, before, 0.15) << "no jump";
    before = speed;
    least = std::min(least, speed);
    most = std::max(most, speed);
    sum += speed;
  }
  EXPECT_GE(least, 6.0);
  EXPECT_LT(least, 6.2);
  EXPECT_LE(most, 14.0);
  EXPECT_GT(most, 13.8);
  EXPECT_NEAR(sum / count, 10.0, 0.01);
}

TEST(WeatherMedium, GustsMoveAlong) {
  WeatherDef def;
  def.wind = {10.0, 0.0};
  def.gusts = 1.0;
  def.gust_time = 4.0;
  def.gust_length = 20.0;
  const Weather weather(def);
  for (double t = 0.0; t < 10.0; t += 0.37) {
    EXPECT_NEAR(weather.at({3.0, 0.0}, 0.1, t).velocity.x, weather.at({3.0 + 5.0, 0.0}, 0.1, t + 1.0).velocity.x, 1e-9);
  }
}

/// Only additions, multiplications and the like: the same bits everywhere.
TEST(WeatherMedium, HasKnownBits) {
  WeatherDef def;
  def.wind = {7.3, -0.4};
  def.gusts = 0.7;
  def.water_level = 0.1;
  def.current = {0.3, 0.0};
  const MediumSample sample = Weather(def).at({1.7, 0.13}, 0.05, 12.345);
  EXPECT_EQ(sample.density, 132.90608755325169);
  EXPECT_EQ(sample.velocity.x, 0.35692641035277284);
  EXPECT_EQ(sample.density_gradient.y, -10748.10031471882);
}

TEST(WeatherMedium, RefusesWhatIsOutOfRange) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Bad {
    std::string field;
    std::function<void(WeatherDef&)> spoil;
  };
  const std::vector<Bad> fields = {
      {"wind", [](WeatherDef& d) { d.wind.x = nan; }},
      {"wind", [](WeatherDef& d) { d.wind.y = 2e4; }},
      {"air_density", [](WeatherDef& d) { d.air_density = -1.0; }},
      {"gusts", [](WeatherDef& d) { d.gusts = 1.1; }},
      {"gust_time", [](WeatherDef& d) { d.gust_time = 0.0; }},
      {"gust_length", [](WeatherDef& d) { d.gust_length = infinity; }},
      {"water_level", [](WeatherDef& d) { d.water_level = infinity; }},
      {"water_level", [](WeatherDef& d) { d.water_level = nan; }},
      {"water_density", [](WeatherDef& d) { d.water_density = 1e7; }},
      {"current", [](WeatherDef& d) { d.current.x = -2e4; }},
  };
  for (const Bad& bad : fields) {
    WeatherDef def;
    bad.spoil(def);
    EXPECT_TRUE(test_support::starts_with(test_support::refusal<DefinitionError>([&] { const Weather weather(def); }),
                                          bad.field + " is "));
  }
}

}  // namespace
}  // namespace ribbon
