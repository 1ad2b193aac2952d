#pragma once

#include <numbers>

#include "ribbon/weather.h"
#include "tests/engine/coupling/grip_world.h"

namespace engine {

using ribbon::Weather;
using ribbon::WeatherDef;

/// Gusts over water at y = −6.
inline WeatherDef gusts_over_water() {
  WeatherDef def;
  def.wind = {8.0, 0.5};
  def.gusts = 0.6;
  def.water_level = -6.0;
  def.current = {-0.5, 0.0};
  return def;
}

inline CordDef feeling(CordDef def) {
  def.drag_across = 1.2;
  def.drag_along = 0.01;
  def.displaced_area = 0.8 * std::numbers::pi * def.radius * def.radius;
  return def;
}

struct Blown : GripWorld {
  explicit Blown(const WeatherDef& def = gusts_over_water()) : weather(def) { coupling.set_medium(&weather); }
  Weather weather;
};

}  // namespace engine
