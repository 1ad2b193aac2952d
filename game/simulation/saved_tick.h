#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

#include "game/simulation/drag.h"
#include "game/simulation/player.h"
#include "game/simulation/rules.h"
#include "game/simulation/target.h"
#include "game/simulation/tether.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/world_snapshot.h"
#include "ribbon/vec2.h"

namespace game {

/// What a run remembers of one of its players, besides the Player.
struct Seat {
  Targets targets{};                    ///< of its lines
  std::optional<std::size_t> inside{};  ///< the checkpoint in which it is
  ribbon::Vec2 foothold{};              ///< m, feet: the position after a fall with the assist no_fall
  ribbon::Vec2 next_foothold{};         ///< m, feet: becomes foothold if the player keeps standing
  int standing_ticks = 0;               ///< on firm ground
  std::uint16_t buttons_before = 0;
};

/// The last fall of a run.
struct LastFall {
  int player = 0;         ///< which fell
  bool is_death = false;  ///< a danger of the level killed it; else it fell out of the level
};

/// State of a Simulation between two ticks.
struct SavedTick {
  /// Drag, checkpoint, the seats, ticks, ticks of the run, falls, the last fall, and ticks at the goal: the members of
  /// Simulation with these names.
  using Progress =
      std::tuple<Drag, std::optional<std::size_t>, std::array<Seat, 2>, int, int, int, LastFall, std::optional<int>>;

  ribbon::box2d::CouplingState cords;
  ribbon::box2d::WorldSnapshot world;
  std::optional<Player> player;
  std::optional<Player> second;  ///< in a run of two players
  std::optional<Tether> tether;  ///< if they are tied together
  Progress progress;
  Rules rules;
  double ride_time = 0.0;  ///< s, engine::Rides::time
  int restarts = 0;        ///< of the simulation before this tick
};

}  // namespace game
