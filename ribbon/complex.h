#pragma once

#include "ribbon/vec2.h"

namespace ribbon {

/// A vector of the plane as a complex number x + i·y: turning and scaling is multiplication.
constexpr Vec2 times(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
constexpr Vec2 conj(Vec2 a) { return {a.x, -a.y}; }
/// A rotation by `angle` [rad], up to two turns, as a complex number: by + − × ÷ √ alone, the same bits everywhere.
Vec2 rotation(double angle);

}  // namespace ribbon
