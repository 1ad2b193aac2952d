// The sounds of what the rules of a level do: cuts, coins, deaths; and on which side those of the second player are.

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <utility>

#include "game/sound/cue_detector.h"
#include "tests/game/simulation/small_level.h"
#include "tests/support/level_for_two.h"

namespace game {
namespace {

/// How often each noise was heard.
struct Counts {
  std::array<int, noise_count> all{};
  int of(Noise noise) const { return all[static_cast<std::size_t>(noise)]; }
};

/// Counts the noises of a run that presses these buttons.
Counts count_noises(const Level& level, int ticks, int buttons = 0) {
  Simulation simulation(level);
  CueDetector detector;
  Counts counts;
  for (int k = 0; k < ticks; ++k) {
    simulation.tick(press(k == 0 ? 0 : buttons));
    detector.update(simulation);
    for (const Cue& cue : detector.cues()) ++counts.all[static_cast<std::size_t>(cue.noise)];
  }
  return counts;
}

MapObject danger(const char* kind, Vec2 center) {
  MapObject object = box_of(0, kind, center, {0.6, 1.0});
  if (std::string(kind) == "fire") object.properties.insert("seconds", 1.0);
  return object;
}

/// A disc on its way down carries a blade through the rope.
TEST(CuesOfRules, ACutIsHeardOnce) {
  MapObject carrier = disc_of(30, "circle", {7.0, 8.0}, 0.3);
  carrier.properties.insert("body", std::string("kinematic"));
  carrier.properties.insert("velocity_x", 3.0);
  MapObject edge = line_of(20, "blade", {{7.0, 8.02}, {8.0, 8.02}});
  edge.properties.insert("body", std::int64_t{30});
  const Level level = level_of(small_map({hanging_rope(10, {10.0, 10.0}), carrier, edge}));
  EXPECT_EQ(count_noises(level, 30).of(Noise::cut), 0);
  EXPECT_EQ(count_noises(level, 120).of(Noise::cut), 1);
}

TEST(CuesOfRules, TheKnifeIsHeardAtEachCut) {
  engine::TiledMap map = small_map({hanging_rope(10, {3.5, 6.5})});
  map.properties.insert("knife", true);
  const Level level = level_of(std::move(map));
  EXPECT_EQ(count_noises(level, 30, button_cut).of(Noise::cut), 1) << "the key is held";
  EXPECT_EQ(count_noises(level, 30).of(Noise::cut), 0);
}

TEST(CuesOfRules, ALineThatIsThrownIsNoCut) {
  const Level level = level_of(small_map({point_of(0, "hook", {4.0, 7.0})}));
  const Counts heard = count_noises(level, 60, button_throw);
  EXPECT_EQ(heard.of(Noise::hook), 1);
  EXPECT_EQ(heard.of(Noise::cut), 0);
}

TEST(CuesOfRules, ACoinIsHeardOnce) {
  const Level level = level_of(small_map({point_of(20, "coin", {5.0, 2.5}), point_of(21, "coin", {7.0, 2.5})}));
  EXPECT_EQ(count_noises(level, 120, button_right).of(Noise::coin), 2);
  EXPECT_EQ(count_noises(level, 120).of(Noise::coin), 0);
}

TEST(CuesOfRules, ADeathIsHeardOtherwiseThanAFall) {
  for (const char* const kind : {"spikes", "fire"}) {
    const Level deadly = level_of(small_map({danger(kind, {6.0, 2.5})}));
    const Counts death = count_noises(deadly, 40, button_right);
    EXPECT_EQ(death.of(Noise::dies), 1) << kind;
    EXPECT_EQ(death.of(Noise::fall), 0) << kind;
  }
  const Counts fall = count_noises(level_of(small_map({})), 200, button_left);  // off the left end of the ground
  EXPECT_GE(fall.of(Noise::fall), 1);
  EXPECT_EQ(fall.of(Noise::dies), 0);
}

/// The second player is to the right of the first one.
TEST(CuesOfRules, ReelAndWindOfTheSecondPlayerAreOnItsSide) {
  Level level = test_support::level_for_two({.tied = false});
  level.hooks = {{14.5, 9.0}};
  Simulation simulation(level);
  std::array<CueDetector, 2> detectors{CueDetector(0), CueDetector(1)};
  const auto listen = [&](int ticks, int second) {
    for (int k = 0; k < ticks; ++k) {
      simulation.tick(press(0, second));
      for (CueDetector& detector : detectors) detector.update(simulation);
    }
  };
  listen(10, button_right);
  listen(1, button_throw);
  listen(30, 0);
  ASSERT_TRUE(simulation.player(1).line().is_held());
  listen(10, button_reel_in);
  EXPECT_GT(detectors[1].reel().volume, 0.1);
  EXPECT_GT(detectors[1].reel().pan, 0.3);
  listen(1, button_throw);
  while (simulation.player(1).position().y > -1.0) {
    ASSERT_LT(simulation.ticks(), 400);
    listen(1, button_right);  // into the abyss
  }
  EXPECT_GT(detectors[1].wind().volume, 0.05);
  EXPECT_GT(detectors[1].wind().pan, 0.3);
  EXPECT_LT(detectors[1].wind().volume, 0.5) << "it is far away";
  EXPECT_EQ(detectors[0].wind().pan, 0.0);
}

}  // namespace
}  // namespace game
