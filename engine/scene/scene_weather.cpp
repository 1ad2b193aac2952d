#include "engine/scene/scene_weather.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace engine {
namespace {

constexpr std::array<std::string_view, 10> names = {"wind_x",    "wind_y",      "air_density", "gusts",
                                                    "gust_time", "gust_length", "water_level", "water_density",
                                                    "current_x", "current_y"};
constexpr NumberRange accepted_speed{-1e3, 1e3};
constexpr NumberRange accepted_density{0.0, 1e5};

}  // namespace

std::optional<ribbon::WeatherDef> weather_of(const TiledMap& map) {
  const Properties& p = map.properties;
  if (std::none_of(names.begin(), names.end(), [&p](std::string_view name) { return p.has(name); })) return {};
  ribbon::WeatherDef def;
  def.wind = {p.number_or("wind_x", 0.0, accepted_speed), p.number_or("wind_y", 0.0, accepted_speed)};
  def.air_density = p.number_or("air_density", def.air_density, accepted_density);
  def.gusts = p.number_or("gusts", def.gusts, {0.0, 1.0});
  def.gust_time = p.number_or("gust_time", def.gust_time, {1e-3, 1e6});
  def.gust_length = p.number_or("gust_length", def.gust_length, {1e-3, 1e6});
  def.water_level = p.number_or("water_level", def.water_level, {-1e6, 1e6});
  def.water_density = p.number_or("water_density", def.water_density, accepted_density);
  def.current = {p.number_or("current_x", 0.0, accepted_speed), p.number_or("current_y", 0.0, accepted_speed)};
  return def;
}

}  // namespace engine
