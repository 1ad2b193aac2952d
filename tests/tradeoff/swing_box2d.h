#pragma once

#include <memory>

#include "tests/support/box2d_ropes.h"
#include "tests/tradeoff/swing.h"

namespace tradeoff {

/// Each substep is a b2World::Step.
struct Box2dSetting {
  int substeps = 1;
  int velocity_iterations = 8;
  int position_iterations = 3;
};

std::unique_ptr<Swing> box2d_chain(test_support::Box2dChain::Limit limit, Box2dSetting setting);
/// `iterations` per substep.
std::unique_ptr<Swing> box2d_rope(const b2RopeTuning& tuning, int substeps, int iterations);

}  // namespace tradeoff
