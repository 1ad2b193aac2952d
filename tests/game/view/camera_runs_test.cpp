// The camera in all recorded runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/replay/replay.h"
#include "game/simulation/level.h"
#include "game/view/effects.h"
#include "tests/game/view/window_size.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double max_acceleration = 50.0;  // m/s²: 0.8 m/s in a frame
constexpr double max_zoom = 0.004;         // per frame
constexpr int dark_ticks = 12;             // after a fall

class CameraInRuns : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Recorded, CameraInRuns, testing::ValuesIn(level_names()),
                         [](const auto& level) { return level.param; });

TEST_P(CameraInRuns, MovesWithoutJerks) {
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/" + GetParam() + ".replay");
  const Level level = load_level(GetParam());
  Simulation simulation(level);
  Effects effects(simulation);
  effects.follow(palette(false), true);
  Vec2 before = effects.view(1.0, window_width, window_height, true).center;
  Vec2 step_before{};
  int falls = 0;
  int dark = 0;  // ticks left in which a fall has made the picture dark
  double scale_before = effects.view(1.0, window_width, window_height, false).pixels_per_metre;
  for (const engine::RecordedTick& tick : replay.ticks) {
    simulation.tick(tick.input);
    effects.follow(palette(false), true);
    const Vec2 now = effects.view(1.0, window_width, window_height, true).center;
    const double scale = effects.view(1.0, window_width, window_height, false).pixels_per_metre;
    if (simulation.falls() > falls) dark = dark_ticks;
    falls = simulation.falls();
    if (dark-- <= 0) {
      EXPECT_LT(3600.0 * length(now - before - step_before), max_acceleration) << simulation.ticks();
      EXPECT_NEAR(scale / scale_before, 1.0, max_zoom) << simulation.ticks();
    }
    step_before = now - before;
    before = now;
    scale_before = scale;
  }
}

/// A ring in the picture at the start is seen whole: it is what the player aims at first.
TEST_P(CameraInRuns, ShowsWholeRingsAtTheStart) {
  constexpr double radius = 0.5;  // m
  const Level level = load_level(GetParam());
  Simulation simulation(level);
  Effects effects(simulation);
  for (const int ticks : {0, 1, 60}) {
    while (simulation.ticks() < ticks) {
      simulation.tick({});
      effects.follow(palette(false), false);
    }
    if (ticks == 0) effects.follow(palette(false), false);
    for (const bool reduced : {false, true}) {
      const engine::View view = effects.view(1.0, window_width, window_height, reduced);
      const Vec2 half = 0.5 / view.pixels_per_metre * Vec2{1.0 * window_width, 1.0 * window_height};
      for (const Vec2 ring : level.hooks) {
        const Vec2 off = ring - view.center;
        const bool is_seen = std::abs(off.x) < half.x - radius && std::abs(off.y) < half.y + radius;
        EXPECT_TRUE(!is_seen || std::abs(off.y) < half.y - radius) << ticks << ' ' << ring.x << ' ' << ring.y;
      }
    }
  }
}

TEST(CameraOnTheTrampoline, ShowsTheClothDuringAJump) {
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/trampoline.replay");
  const Level level = load_level("trampoline");
  Simulation simulation(level);
  Effects effects(simulation);
  double ground = level.player_start.y;
  double highest = 0.0;
  for (const engine::RecordedTick& tick : replay.ticks) {
    simulation.tick(tick.input);
    effects.follow(palette(false), false);
    const Player& player = simulation.player();
    const double soles = player.position().y - 0.5 * player.tuning().height;
    if (player.is_on_ground()) ground = soles;
    const engine::View view = effects.view(1.0, window_width, window_height, false);
    const double half = 0.5 * window_height / view.pixels_per_metre;
    EXPECT_LT(view.center.y - half, std::min(ground, soles)) << simulation.ticks();
    EXPECT_GT(view.center.y + half, player.position().y + 0.75) << simulation.ticks();
    highest = std::max(highest, soles - ground);
  }
  EXPECT_GT(highest, 4.0);
}

}  // namespace
}  // namespace game
