#pragma once

#include <box2d/b2_math.h>

#include "ribbon/vec2.h"

namespace ribbon::box2d {

// The only conversions between the single precision of Box2D and the double precision of cords.

/// Converts to double precision, exactly.
inline Vec2 to_double(b2Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
/// Converts to single precision, rounded to the nearest value.
inline b2Vec2 to_float(Vec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

}  // namespace ribbon::box2d
