#pragma once

#include "game/simulation/drag.h"
#include "game/simulation/players.h"
#include "game/simulation/rules.h"
#include "game/simulation/run_progress.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/world_snapshot.h"

namespace game {

/// State of a Simulation between two ticks.
struct SavedTick {
  ribbon::box2d::CouplingState cords;
  ribbon::box2d::WorldSnapshot world;
  Players::State players;
  RunProgress progress;
  Drag drag;
  Rules rules;
  double ride_time = 0.0;  ///< s, engine::Rides::time
  int restarts = 0;        ///< of the simulation before this tick
};

}  // namespace game
