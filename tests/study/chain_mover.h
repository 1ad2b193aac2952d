#pragma once

#include <span>
#include <string>

#include "engine/tick/input.h"
#include "game/simulation/level.h"
#include "tests/study/dials.h"
#include "tests/study/trace.h"

namespace study {

/// Moves a level's cords as chains of Box2D's joints (tests/support/joint_chain.h), in as many world steps a tick as
/// the dials have substeps. The scene's own cords are not stepped: they are laid where the chains are, so that the
/// player catches and holds them as ever, and whoever looks at a run sees the chains. A hand that holds a point is a
/// revolute joint; box2d_max_distance adds a joint that keeps the hand no further from each pin of the cord than the
/// cord between them is long. One run at a time.
Method chain_method(const Dials& dials);

/// Why a level cannot be run so, in a sentence; empty if it can.
std::string why_no_chains(const game::Level& level, std::span<const engine::TickInput> inputs);

}  // namespace study
