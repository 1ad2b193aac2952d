#pragma once

#include <box2d/b2_math.h>

#include "ribbon/vec2.h"

namespace engine {

// The one place where Box2D's single precision and the cord's double precision meet.

/// Box2D's vectors as the cords', without loss.
inline ribbon::Vec2 to_double(b2Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
/// The cords' as Box2D's, to the nearest.
inline b2Vec2 to_float(ribbon::Vec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

}  // namespace engine
