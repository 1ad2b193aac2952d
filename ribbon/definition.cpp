#include "ribbon/definition.h"

#include <cmath>
#include <sstream>
#include <string>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

template <typename... Parts>
[[noreturn]] void refuse_with(const Parts&... parts) {
  std::ostringstream sentence;
  (sentence << ... << parts);
  throw DefinitionError(sentence.str());
}

}  // namespace

void refuse(const char* field, double value, const char* accepted) {
  refuse_with(field, " is ", value, "; accepted is ", accepted);
}

void check_range(const char* field, double value, double low, double high) {
  // Comparisons with NaN are false, so this form refuses NaN too.
  if (!(value >= low && value <= high)) refuse_with(field, " is ", value, "; accepted is ", low, " to ", high);
}

void check_coordinates(const char* field, Vec2 value) {
  constexpr double max = 1e9;  // its square and cube do not overflow
  if (!(std::abs(value.x) <= max && std::abs(value.y) <= max)) {
    refuse_with(field, " is (", value.x, ", ", value.y, "); accepted are coordinates from ", -max, " to ", max);
  }
}

void check_points(int points, std::span<const Vec2> positions, std::span<const int> pins) {
  if (!positions.empty() && positions.size() != at(points)) {
    refuse_with("positions has ", positions.size(), " entries; accepted is none, or one a point: ", points);
  }
  for (std::size_t p = 0; p < positions.size(); ++p) {
    check_coordinates(("positions[" + std::to_string(p) + "]").c_str(), positions[p]);
  }
  for (std::size_t k = 0; k < pins.size(); ++k) {
    if (pins[k] < 0 || pins[k] >= points) {
      refuse_with("pins[", k, "] is ", pins[k], "; accepted is a point index from 0 to ", points - 1);
    }
  }
}

}  // namespace ribbon
