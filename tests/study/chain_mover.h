#pragma once

#include <span>
#include <string>

#include "engine/tick/input.h"
#include "game/simulation/level.h"
#include "tests/study/setting.h"
#include "tests/study/trace.h"

namespace study {

/// Moves a level's cords as chains of Box2D's joints (game/lab/joint_chain.h), with as many world steps per tick
/// as the setting has substeps. The scene's own cords are not stepped: they get the positions of the chains, so that
/// the player can hold them, and figures and pictures show the chains. A grip at a point is a revolute joint;
/// box2d_max_distance adds a joint that limits the distance of the hand from each pin of the cord to the length of the
/// cord between them. One run at a time.
Method chain_method(const Setting& setting);

/// Returns why a level cannot be run with chains, in a sentence; empty if it can. `own` is the run of its own cords.
std::string chains_unsupported_reason(const game::Level& level, std::span<const engine::TickInput> inputs,
                                      const Trace& own);

}  // namespace study
