#pragma once

#include <span>
#include <stdexcept>

#include "ribbon/vec2.h"

namespace ribbon {

/// A definition that cannot be built. The sentence names the field, the value found and what is accepted.
class DefinitionError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// How a point is moved, with the colours of Goto 2017, Fig. 4.1.
enum class PointKind : unsigned char {
  free,         ///< by the cord (blue)
  operated,     ///< by whoever drags it (yellow)
  constrained,  ///< not at all, or with what it is pinned to (red)
};

/// Throws DefinitionError unless there is no position or one a point, each within ±1e9 m, and every pin is a point.
void check_points(int points, std::span<const Vec2> positions, std::span<const int> pins);

/// Throws DefinitionError unless both coordinates are within ±1e9 (m, m/s, or N).
void check_coordinates(const char* field, Vec2 value);

/// Throws DefinitionError unless low ≤ value ≤ high: "spacing is -1; accepted is 1e-06 to 1e+06".
void check_range(const char* field, double value, double low, double high);

/// Throws DefinitionError: "field is value; accepted is `accepted`".
[[noreturn]] void refuse(const char* field, double value, const char* accepted);

}  // namespace ribbon
