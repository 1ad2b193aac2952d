#pragma once

#include <limits>

#include "ribbon/vec2.h"

/// Values that most tests use.
namespace constants {

constexpr double g = 9.81;                ///< m/s²
constexpr ribbon::Vec2 gravity{0.0, -g};  ///< m/s²
constexpr double dt = 1.0 / 60.0;         ///< s, a tick
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace constants
