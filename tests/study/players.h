#pragma once

#include <cstddef>
#include <vector>

#include "engine/tick/input.h"
#include "game/simulation/level.h"

namespace study {

/// The inputs of a player.
using Inputs = std::vector<engine::TickInput>;

/// Returns random buttons for a number of ticks; the same for the same seed.
Inputs random_inputs(unsigned seed, int ticks);

/// A recommended setting must keep the error with this number of other players too.
inline constexpr std::size_t judging_players = 8;

/// The cords that a player meets in a level with the cords' own settings.
struct Meetings {
  bool any_cord = false;     ///< whether a cord exists in any tick
  std::vector<int> held;     ///< ids of the cords that it holds, ascending
  std::vector<int> touched;  ///< ids of those that it touches, ascending
};
Meetings meetings_of(const game::Level& level, const Inputs& inputs);

/// Returns random buttons with which a cord exists in some tick, where the level has none before a line arrives: those
/// of the first of 24 seeds. If there are none, those of the seed.
Inputs random_inputs_with_cords(const game::Level& level, unsigned seed, int ticks);

/// Returns up to `count` of 24 random players, of two seconds each: one after the other the one that holds or touches
/// the most cords that none before it does. A player that meets no cord shows no setting to be too cheap, so that a
/// study which judges by one player recommends what fails with the next one.
std::vector<Inputs> players_that_meet_cords(const game::Level& level, unsigned seed, std::size_t count);

}  // namespace study
