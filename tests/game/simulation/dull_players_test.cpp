// A level needs its idea: players that only press the same keys again and again do not reach the flag.

#include <gtest/gtest.h>

#include <cstdint>
#include <ostream>
#include <string>
#include <tuple>

#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"

namespace game {
namespace {

int runs(const Simulation& /*simulation*/, int /*number*/) { return button_right; }

/// Presses the key again for each jump, and holds it while it rises.
int runs_and_jumps(const Simulation& simulation, int number) {
  const Player& player = simulation.player(number);
  const bool jumps = player.is_on_ground() ? simulation.ticks() % 2 == 0 : player.body().GetLinearVelocity().y > 0.0F;
  return button_right | (jumps ? button_jump : 0);
}

/// Catches whatever it can, and lets go as soon as the swing carries it forwards and up.
int runs_jumps_and_catches(const Simulation& simulation, int number) {
  constexpr float forwards = 1.0F;  // m/s
  constexpr float upwards = 0.3F;
  const Player& player = simulation.player(number);
  if (player.is_on_ground()) return runs_and_jumps(simulation, number);
  if (!player.held_place(simulation.scene().coupling())) {
    return runs_and_jumps(simulation, number) | button_grab;
  }
  const b2Vec2 v = player.body().GetLinearVelocity();
  return button_right | (v.x > forwards && v.y > upwards ? button_jump : button_grab);
}

struct DullPlayer {
  const char* name;
  int (*buttons)(const Simulation&, int number);
};
void PrintTo(const DullPlayer& player, std::ostream* out) { *out << player.name; }

constexpr DullPlayer dull_players[] = {
    {"Runs", runs}, {"RunsAndJumps", runs_and_jumps}, {"RunsJumpsAndCatches", runs_jumps_and_catches}};

class DullPlayers : public testing::TestWithParam<std::tuple<std::string, DullPlayer>> {};
INSTANTIATE_TEST_SUITE_P(OfEveryLevel, DullPlayers,
                         testing::Combine(testing::ValuesIn(level_names()), testing::ValuesIn(dull_players)),
                         [](const auto& run) { return std::get<0>(run.param) + "_" + std::get<1>(run.param).name; });

TEST_P(DullPlayers, DoNotWin) {
  const Level level = load_level(std::get<0>(GetParam()));
  if (level.sandbox || !level.goal) GTEST_SKIP() << "has nothing to win";
  constexpr int most_ticks = 90 * ticks_per_second;
  Simulation simulation(level);
  while (!simulation.goal_ticks() && simulation.ticks() < most_ticks) {
    engine::TickInput input{};
    const auto buttons = [&](int number) {
      return static_cast<std::uint16_t>(std::get<1>(GetParam()).buttons(simulation, number));
    };
    input.buttons = buttons(0);
    if (simulation.players() == 2) input.second_buttons = buttons(1);
    simulation.tick(input);
  }
  EXPECT_FALSE(simulation.goal_ticks()) << "after " << simulation.ticks() << " ticks";
}

}  // namespace
}  // namespace game
