#pragma once

#include <box2d/box2d.h>

#include "tests/fuzz/bytes.h"

namespace fuzz {

/// A body of any type and shape. Box2D aborts for NaN; this class satisfies its assertions, and tries all other
/// numbers.
b2Body& add_some_body(b2World& world, Bytes& bytes);
/// Puts it elsewhere, or pushes it, switches it off or on, changes its type or its mass.
void disturb(b2Body& body, Bytes& bytes);
/// Anything: this is for our own doors.
b2Vec2 some_hand(Bytes& bytes);

}  // namespace fuzz
