#pragma once

#include "game/simulation/ghost.h"
#include "game/simulation/simulation.h"
#include "game/view/pose.h"

namespace game {

/// Returns the state of a player in a snapshot of the run's last tick, or of the time before it. `time`: s, since the
/// start of the run. `number`: of the player.
FigureState figure_of(const Simulation& simulation, const Snapshot& now, double time, int number = 0);

/// Returns the state of a ghost.
FigureState figure_of(const GhostPose& ghost, double time);

/// Returns the position of a held place in m.
ribbon::Vec2 held_position(const ribbon::box2d::Coupling& coupling, const Snapshot& now,
                           const ribbon::box2d::CordPoint& held);

/// Returns the position on a cord that a body holds in m, or nothing.
std::optional<ribbon::Vec2> held_position(const ribbon::box2d::Coupling& coupling, const Snapshot& now,
                                          const b2Body& body);

}  // namespace game
