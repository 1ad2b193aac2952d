#pragma once

#include "ribbon/vec2.h"

namespace ribbon {

/// Returns the product of two vectors as complex numbers x + i·y: multiplication rotates and scales.
constexpr Vec2 times(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
/// Returns the complex conjugate x − i·y: the inverse of a rotation.
constexpr Vec2 conj(Vec2 a) { return {a.x, -a.y}; }
/// Returns the rotation by a finite `angle` [rad] as a complex number of length 1. It uses only + − × ÷ √, so the bits
/// are the same on every machine. Error: 5e-14 up to 1e20 rad; beyond, 5e-14 for some angle that rounds to this double.
Vec2 rotation(double angle);

}  // namespace ribbon
