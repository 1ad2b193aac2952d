#pragma once

#include <memory>

#include "ribbon/cord_def.h"
#include "tests/tradeoff/swing.h"

namespace tradeoff {

/// A cord that does not stretch, coupled to a Box2D world whose one body it carries: the whole tick of both.
std::unique_ptr<Swing> held_swing(const ribbon::Accuracy& accuracy);
/// That world without the cord: what b2World::Step costs by itself.
std::unique_ptr<Swing> falling_body();

}  // namespace tradeoff
