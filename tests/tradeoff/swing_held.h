#pragma once

#include <memory>

#include "ribbon/cord_def.h"
#include "tests/tradeoff/swing.h"

namespace tradeoff {

/// Returns an inextensible cord that carries the only body of a Box2D world; a tick includes both.
std::unique_ptr<Swing> held_swing(const ribbon::Accuracy& accuracy);
/// Returns that world without the cord, for the cost of b2World::Step alone.
std::unique_ptr<Swing> falling_body();

}  // namespace tradeoff
