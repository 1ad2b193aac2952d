#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "ribbon/cord.h"
#include "ribbon/medium.h"
#include "ribbon/weather.h"
#include "tests/support/constants.h"

namespace ribbon {

using constants::dt;
using constants::gravity;

constexpr double air = 1.2;  // kg/m³
constexpr double across = 1.2;
constexpr double along = 0.01;
inline const std::array presets{Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()};

inline CordDef rope_with_drag(double mass_per_length = 0.1) {
  CordDef def;
  def.points = 41;
  def.length = 4.0;
  def.mass_per_length = mass_per_length;
  def.drag_across = across;
  def.drag_along = along;
  return def;
}

inline double round_area(const CordDef& def) { return std::numbers::pi * def.radius * def.radius; }

/// N·s²/m³: the drag per length, and per square of the velocity.
inline double drag_across_of(const CordDef& def, double density) { return density * def.drag_across * def.radius; }
inline double drag_along_of(const CordDef& def, double density) {
  return density * def.drag_along * std::numbers::pi * def.radius;
}

inline WeatherDef wind(Vec2 velocity) {
  WeatherDef def;
  def.wind = velocity;
  return def;
}

/// Air of no density, and water up to y = 0.
inline WeatherDef water(Vec2 current = {}) {
  WeatherDef def;
  def.air_density = 0.0;
  def.water_level = 0.0;
  def.current = current;
  return def;
}

/// A cord that is stepped in a medium.
struct InMedium {
  Cord cord;
  const Medium& medium;
  double time = 0.0;
  IslandReport total = {};

  void step(int steps = 1) {
    for (int k = 0; k < steps; ++k) {
      Surroundings surroundings;
      surroundings.medium = &medium;
      surroundings.time = time;
      total += cord.step(dt, gravity, surroundings);
      time += dt;
    }
  }
  Vec2 momentum() const {
    Vec2 sum;
    for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)];
    return sum;
  }
  double top_speed() const {
    double top = 0.0;
    for (const Vec2 v : cord.velocities()) top = std::max(top, length(v));
    return top;
  }
  bool is_finite() const {
    const auto finite = [](Vec2 v) { return ribbon::is_finite(v); };
    return std::all_of(cord.positions().begin(), cord.positions().end(), finite) &&
           std::all_of(cord.velocities().begin(), cord.velocities().end(), finite);
  }
  double longest_link() const {
    double longest = 0.0;
    for (std::size_t p = 1; p < cord.positions().size(); ++p)
      longest = std::max(longest, length(cord.positions()[p] - cord.positions()[p - 1]));
    return longest;
  }
};

}  // namespace ribbon
