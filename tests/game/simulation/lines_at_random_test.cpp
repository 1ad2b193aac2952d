// Lines, knots and ledges under a player that presses anything at any time.

#include <gtest/gtest.h>

#include <algorithm>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"
#include "tests/support/dice.h"

namespace game {
namespace {

using ribbon::Vec2;

/// Presses and releases keys every few ticks, and aims anywhere.
class RandomPlayer {
 public:
  explicit RandomPlayer(unsigned seed) : dice_(seed) {}

  engine::TickInput input(const Simulation& simulation) {
    if (dice_() < 0.08) {
      held_ = 0;
      for (const int button :
           {button_left, button_right, button_jump, button_grab, button_up, button_reel_in, button_reel_out}) {
        if (dice_() < 0.3) held_ |= button;
      }
      pointer_ = simulation.player().hand() + Vec2{dice_(-10.0, 10.0), dice_(-8.0, 12.0)};
    }
    int pressed = held_;
    if (dice_() < 0.07) pressed |= button_throw;
    if (dice_() < 0.07) pressed |= button_throw_second;
    if (dice_() < 0.03) pressed |= button_tie;
    engine::TickInput input;
    input.buttons = static_cast<std::uint16_t>(pressed);
    engine::set_pointer(input, pointer_);
    return input;
  }

 private:
  test_support::Dice dice_;
  int held_ = 0;
  Vec2 pointer_;
};

/// Two lines, and all bodies are sticky.
Level with_lines(const std::string& name) {
  Level level = load_level(name);
  level.lines = 2;
  for (engine::MapObject& object : level.map.objects) {
    if (object.kind == "ground" || object.kind == "circle" || object.kind == "load")
      object.properties.insert("sticky", true);
  }
  return level;
}

class LinesAtRandom : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Lines, LinesAtRandom,
                         testing::Values("bound_beams", "tie_it_down", "sandbox", "round_the_pegs"),
                         [](const auto& level) { return level.param; });

constexpr int returning_ticks = 20;  // of a hand that something has stopped, to its line

/// The ends of a held line are at its place and in the hand, nothing flies apart, and nearly all steps are solved.
TEST_P(LinesAtRandom, HoldAndStayWhole) {
  const Level level = with_lines(GetParam());
  int ticks = 0;
  int unconverged = 0;
  int held = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    RandomPlayer player(seed);
    Simulation simulation(level);
    int free_ticks = 0;  // since the player ran into something
    while (simulation.ticks() < 900) {
      simulation.tick(player.input(simulation));
      ++ticks;
      const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
      free_ticks = simulation.player().body().GetContactList() != nullptr ? 0 : free_ticks + 1;
      unconverged += coupling.last_step().report().unconverged;
      ASSERT_LT(simulation.player().body().GetLinearVelocity().Length(), 30.0F) << seed << " " << simulation.ticks();
      for (const Line& line : simulation.player().lines().all()) {
        if (!line.is_held() || line.is_new()) continue;
        ++held;
        const auto points = coupling.cord(*line.cord()).positions();
        ASSERT_LT(length(points.front() - line.end()), 0.02) << seed << " " << simulation.ticks();
        if (free_ticks < returning_ticks) continue;  // what it runs into stops the hand
        ASSERT_LT(length(points.back() - simulation.player().hand()), 0.01) << seed << " " << simulation.ticks();
      }
    }
  }
  EXPECT_LT(unconverged, ticks / 200);
  EXPECT_GT(held, ticks / 10);
}

}  // namespace
}  // namespace game
