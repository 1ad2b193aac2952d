#include "ribbon/thesis_def.h"

#include <cmath>
#include <sstream>
#include <string>

namespace ribbon {
namespace {

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream sentence;
  (sentence << ... << parts);
  throw DefinitionError(sentence.str());
}

}  // namespace

void check_range(const char* field, double value, double low, double high) {
  // Written so that NaN, which compares false with everything, is refused too.
  if (!(value >= low && value <= high)) refuse(field, " is ", value, "; accepted is ", low, " to ", high);
}

void check_coordinates(const char* field, Vec2 value) {
  constexpr double most = 1e9;  // squares and cubes of it are far from overflow
  if (!(std::abs(value.x) <= most && std::abs(value.y) <= most)) {
    refuse(field, " is (", value.x, ", ", value.y, "); accepted are coordinates from ", -most, " to ", most);
  }
}

void check_points(int points, std::span<const Vec2> positions, std::span<const int> pins) {
  if (!positions.empty() && positions.size() != static_cast<std::size_t>(points)) {
    refuse("positions has ", positions.size(), " entries; accepted is none, or one a point: ", points);
  }
  for (std::size_t p = 0; p < positions.size(); ++p) {
    check_coordinates(("positions[" + std::to_string(p) + "]").c_str(), positions[p]);
  }
  for (std::size_t k = 0; k < pins.size(); ++k) {
    if (pins[k] < 0 || pins[k] >= points) {
      refuse("pins[", k, "] is ", pins[k], "; accepted is a point index from 0 to ", points - 1);
    }
  }
}

void check(const ThesisDef& def) {
  check_range("h", def.h, 2, 64);
  check_range("w", def.w, 2, std::floor(1e6 / def.h));
  check_range("spacing", def.spacing, 1e-6, 1e6);
  check_range("point_mass", def.point_mass, 1e-9, 1e9);
  check_range("spring_stiffness", def.spring_stiffness, 0.0, 1e15);
  check_range("bar_damping", def.bar_damping, 0.0, 1e15);
  check_range("drag", def.drag, 0.0, 1e6);
  check_range("area_stiffness", def.area_stiffness, 0.0, 1.0);
  check_range("area_floor", def.area_floor, 0.0, 0.9);
  check_range("radius", def.radius, 0.0, 0.5 * def.spacing);
  check_range("substeps", def.substeps, 1, 4096);
  check_points(def.w * def.h, def.positions, def.pins);
}

}  // namespace ribbon
