#pragma once

#include <gtest/gtest.h>

#include "engine/tick/workers.h"
#include "tests/engine/coupling/grip_world.h"

namespace engine {

/// Plays a scene with one worker, with three, and with estimates of errors. Expects the same bits. Returns the state at
/// the end, without the estimates. `Scene` is a GripWorld; `play` gets it as it was made and advances it.
template <typename Scene, typename Play>
ribbon::box2d::CouplingState expect_same_motion(const Play& play) {
  const auto state_after = [&play](int workers, bool estimates) {
    Workers crew(workers);
    Scene scene;
    scene.coupling.use(crew.parallel_for());
    scene.coupling.estimate_errors(estimates);
    play(scene);
    return state_without_errors(scene);
  };
  ribbon::box2d::CouplingState alone = state_after(1, false);
  EXPECT_TRUE(state_after(3, false) == alone) << "with three workers";
  EXPECT_TRUE(state_after(1, true) == alone) << "with estimates of errors";
  return alone;
}

}  // namespace engine
