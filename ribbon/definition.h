#pragma once

#include <span>
#include <stdexcept>

#include "ribbon/vec2.h"

namespace ribbon {

/// Reports a value that is not accepted. The message names the field, its value and the accepted range.
class DefinitionError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Reports a call that is not accepted: for an object that does not exist or is of another kind, or at the wrong time.
/// The message names what was wrong and what is accepted.
class CallError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// What determines the motion of a point; colours as in Goto 2017, Fig. 4.1.
enum class PointKind : unsigned char {
  free,         ///< the forces on it (blue)
  operated,     ///< a target that drags it (yellow)
  constrained,  ///< a pin, which holds it in place or moves it (red)
};

/// Throws DefinitionError unless `positions` is empty or has one entry per point, each within ±1e9 m, and every pin is
/// the index of a point.
void check_points(int points, std::span<const Vec2> positions, std::span<const int> pins);

/// Throws DefinitionError unless both coordinates are within ±1e9 (m, m/s or N).
void check_coordinates(const char* field, Vec2 value);

/// Throws DefinitionError unless low ≤ value ≤ high. Example: "spacing is -1; accepted is 1e-06 to 1e+06".
void check_range(const char* field, double value, double low, double high);

/// Throws DefinitionError with the message "FIELD is VALUE; accepted is ACCEPTED".
[[noreturn]] void refuse(const char* field, double value, const char* accepted);

}  // namespace ribbon
