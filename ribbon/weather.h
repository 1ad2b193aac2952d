#pragma once

#include <limits>

#include "ribbon/medium.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Defines air that moves and water below a level.
struct WeatherDef {
  Vec2 wind{};                ///< m/s, mean velocity of the air, within ±1e4
  double air_density = 1.2;   ///< kg/m³, 0 … 1e6
  double gusts = 0.0;         ///< 0 … 1: the wind is at most this share stronger or weaker than its mean
  double gust_time = 5.0;     ///< s, 1e-3 … 1e6, from one gust to the next
  double gust_length = 20.0;  ///< m, 1e-3 … 1e6, the same in space, along x; gusts move towards +x
  /// m, y of the surface of the water, within ±1e9; minus infinity, the default, for no water.
  double water_level = -std::numeric_limits<double>::infinity();
  double water_density = 1000.0;  ///< kg/m³, 0 … 1e6
  Vec2 current{};                 ///< m/s, velocity of the water, within ±1e4

  bool operator==(const WeatherDef&) const = default;
};

/// Throws DefinitionError for the first field that is out of range.
void check(const WeatherDef& def);

/// A medium that is given by numbers. Its results have the same bits on all machines.
class Weather : public Medium {
 public:
  /// Throws DefinitionError if check(def) does.
  explicit Weather(const WeatherDef& def);

  /// Returns the definition.
  const WeatherDef& def() const { return def_; }
  /// Returns air or water, or their mean where the surface is within `half_height`. The share of water is that of the
  /// cross-section of a round cord, within 1.3 %.
  MediumSample at(Vec2 place, double half_height, double time) const override;

 private:
  WeatherDef def_;
};

}  // namespace ribbon
