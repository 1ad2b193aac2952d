#pragma once

#include <memory>

#include "ribbon/cord_def.h"
#include "tests/tradeoff/swing.h"

namespace tradeoff {

/// An inextensible cord, coupled to a Box2D world whose only body it carries: the whole tick of both.
std::unique_ptr<Swing> held_swing(const ribbon::Accuracy& accuracy);
/// That world without the cord: the cost of b2World::Step alone.
std::unique_ptr<Swing> falling_body();

}  // namespace tradeoff
