#pragma once

#include <memory>

#include "tests/support/box2d_ropes.h"
#include "tests/tradeoff/swing.h"

namespace tradeoff {

/// A substep is a b2World::Step of its own, as often a tick as asked for.
struct Box2dDials {
  int substeps = 1;
  int velocity_iterations = 8;
  int position_iterations = 3;
};

std::unique_ptr<Swing> box2d_chain(test_support::Box2dChain::Limit limit, Box2dDials dials);
/// `iterations` a substep.
std::unique_ptr<Swing> box2d_rope(const b2RopeTuning& tuning, int substeps, int iterations);

}  // namespace tradeoff
