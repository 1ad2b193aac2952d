#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include "game/simulation/drag.h"
#include "game/simulation/player.h"
#include "game/simulation/rules.h"
#include "game/simulation/target.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/world_snapshot.h"
#include "ribbon/vec2.h"

namespace game {

/// State of a Simulation between two ticks.
struct SavedTick {
  /// Drag, checkpoint, targets of lines, two footholds, ticks of standing, buttons, ticks, ticks of the run, falls, and
  /// ticks at the goal: the members of Simulation with these names.
  using Progress = std::tuple<Drag, std::optional<std::size_t>, Targets, ribbon::Vec2, ribbon::Vec2, int, std::uint16_t,
                              int, int, int, std::optional<int>>;

  ribbon::box2d::CouplingState cords;
  ribbon::box2d::WorldSnapshot world;
  std::optional<Player> player;
  Progress progress;
  Rules rules;
  double ride_time = 0.0;  ///< s, engine::Rides::time
  int restarts = 0;        ///< of the simulation before this tick
};

}  // namespace game
