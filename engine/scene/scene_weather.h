#pragma once

#include <optional>

#include "engine/scene/tiled_map.h"
#include "ribbon/weather.h"

namespace engine {

/// Returns the weather that the properties of a map define; nothing if it has none of them: wind_x, wind_y [m/s],
/// air_density [kg/m³], gusts, gust_time [s], gust_length [m], water_level [m, y in the world], water_density,
/// current_x, current_y [m/s]. Throws MapError for a value that is out of range.
std::optional<ribbon::WeatherDef> weather_of(const TiledMap& map);

}  // namespace engine
