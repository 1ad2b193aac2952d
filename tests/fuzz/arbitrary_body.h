#pragma once

#include <box2d/box2d.h>

#include "tests/fuzz/bytes.h"

namespace fuzz {

/// A body of any type and shape. Box2D aborts for NaN; this class satisfies its assertions, and tries all other
/// numbers.
b2Body& add_arbitrary_body(b2World& world, Bytes& bytes);
/// Moves, pushes, disables or enables a body, or changes its type or mass.
void disturb(b2Body& body, Bytes& bytes);
/// Returns any vector, also NaN: the coupling has to check it.
b2Vec2 arbitrary_anchor(Bytes& bytes);

}  // namespace fuzz
