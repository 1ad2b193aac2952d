// No tick of the game costs many times as much as others, by the number of Newton steps, which is the same on every
// machine. build/release/bin/frame_cost measures their time on this machine.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "tests/support/dice.h"

namespace game {
namespace {

struct Effort {
  int most_steps = 0;  ///< maximum Newton steps of a tick, summed over all cords; each cord of a coupled solve counts
  int tick = 0;        ///< the tick with that maximum
  int unconverged = 0;
};

void add_tick(Effort& effort, const Simulation& simulation) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  int steps = 0;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    steps += coupling.cord(c).island_report().iterations;
    effort.unconverged += coupling.cord(c).island_report().unconverged;
  }
  if (steps > effort.most_steps) effort.tick = simulation.ticks();
  effort.most_steps = std::max(effort.most_steps, steps);
}

class EffortOfEveryLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Effort, EffortOfEveryLevel, testing::ValuesIn(level_names()),
                         [](const auto& level) { return level.param; });

TEST_P(EffortOfEveryLevel, IsEvenDuringItsWinningRun) {
  constexpr int most_steps = 160;
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/" + GetParam() + ".replay");
  const Level level = load_level(GetParam());
  Simulation simulation(level);
  Effort effort;
  for (const auto& recorded : replay.ticks) {
    simulation.tick(recorded.input);
    add_tick(effort, simulation);
  }
  EXPECT_LE(effort.most_steps, most_steps) << "tick " << effort.tick;
}

/// Back and forth among the curtains, and up.
std::uint16_t at_random_among_curtains(test_support::Dice& dice, double x) {
  constexpr double left_end = 9.0;  // m
  constexpr double right_end = 17.0;
  const double way = x < left_end ? 0.0 : x > right_end ? 1.0 : dice(0.0, 2.0);
  const int jump = dice() < 0.3 ? button_jump : 0;
  return static_cast<std::uint16_t>((way < 1.0 ? button_right : button_left) | jump);
}

/// Soft cloth with friction gets stuck on itself in configurations that no solve resolves: with a quarter of this
/// bending stiffness, or with friction 0.2, some ticks take thousands of steps.
TEST(Effort, OfCurtainsStaysEvenUnderAnyPush) {
  constexpr int most_steps = 400;
  const Level level = load_level("curtains");
  for (unsigned seed = 1; seed <= 8; ++seed) {
    test_support::Dice dice(seed);
    Simulation simulation(level);
    Effort effort;
    engine::TickInput input;
    int left = 0;
    for (int k = 0; k < 600; ++k) {
      if (left-- == 0) {
        input.buttons = at_random_among_curtains(dice, simulation.player().position().x);
        left = static_cast<int>(dice(5.0, 55.0));
      }
      simulation.tick(input);
      add_tick(effort, simulation);
    }
    EXPECT_LE(effort.most_steps, most_steps) << "seed " << seed << ", tick " << effort.tick;
    EXPECT_EQ(effort.unconverged, 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace game
