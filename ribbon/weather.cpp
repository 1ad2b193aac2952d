#include "ribbon/weather.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/definition.h"

namespace ribbon {
namespace {

constexpr double max_speed = 1e4;                  // m/s, in each component
constexpr double second_gust = std::numbers::phi;  // frequency of a second wave of gusts, so that they never repeat
// The share of a circle below a level, as ½ + a·s + b·s³ + c·s⁵ with s from −1 to 1: its slope in the middle is that of
// a circle, 2/π, and at both ends 0, so that what floats high is not thrown about.
constexpr double a = 2.0 * std::numbers::inv_pi;
constexpr double b = 1.25 - 2.0 * a;
constexpr double c = 0.5 - a - b;

void check_velocity(const char* field, Vec2 velocity) {
  check_range(field, velocity.x, -max_speed, max_speed);
  check_range(field, velocity.y, -max_speed, max_speed);
}

/// A wave of period 1, between −1 and 1: two parabolas, because the bits of a sine differ from library to library.
double wave(double phase) {
  const double s = 2.0 * (phase - std::floor(phase)) - 1.0;
  return 4.0 * s * (1.0 - std::abs(s));
}

/// The share of something that is under water, and its derivative by the depth of the middle.
struct Submerged {
  double share;
  double per_depth;  // 1/m
};

/// Of a circle whose middle is s radii under water, it is ½ + (s·√(1 − s²) + asin s)/π; the polynomial is within 0.013.
Submerged submerged(double depth, double radius) {
  const double s = depth / radius;
  if (!(s > -1.0)) return {0.0, 0.0};
  if (s >= 1.0) return {1.0, 0.0};
  const double s2 = s * s;
  return {0.5 + s * (a + s2 * (b + s2 * c)), (a + s2 * (3.0 * b + s2 * 5.0 * c)) / radius};
}

}  // namespace

void check(const WeatherDef& def) {
  check_velocity("wind", def.wind);
  check_range("air_density", def.air_density, 0.0, 1e6);
  check_range("gusts", def.gusts, 0.0, 1.0);
  check_range("gust_time", def.gust_time, 1e-3, 1e6);
  check_range("gust_length", def.gust_length, 1e-3, 1e6);
  if (!(std::isinf(def.water_level) && def.water_level < 0.0)) check_range("water_level", def.water_level, -1e9, 1e9);
  check_range("water_density", def.water_density, 0.0, 1e6);
  check_velocity("current", def.current);
}

Weather::Weather(const WeatherDef& def) : def_(def) { check(def); }

MediumSample Weather::at(Vec2 place, double half_height, double time) const {
  Vec2 wind = def_.wind;
  if (def_.gusts > 0.0) {
    const double phase = time / def_.gust_time - place.x / def_.gust_length;
    wind = (1.0 + 0.5 * def_.gusts * (wave(phase) + wave(second_gust * phase))) * wind;
  }
  const Submerged water = submerged(def_.water_level - place.y, half_height);
  const double of_water = water.share * def_.water_density;
  const double of_air = (1.0 - water.share) * def_.air_density;
  MediumSample sample;
  sample.density = of_water + of_air;
  sample.density_gradient = {0.0, -water.per_depth * (def_.water_density - def_.air_density)};
  if (sample.density > 0.0) {
    sample.velocity = (of_water / sample.density) * def_.current + (of_air / sample.density) * wind;
  }
  return sample;
}

}  // namespace ribbon
