#include "game/sound/cue_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "tests/game/program.h"
#include "tests/support/autopilot.h"
#include "tests/support/level_for_two.h"

namespace game {
namespace {

using test_support::first_swing_level;

/// A player above a floor, and a ball of 16 kg that falls on the floor; heights are in m above the floor.
Level drop(double player_height, double ball_height = 1.0, double ball_x = 14.0) {
  std::ostringstream map;
  map << R"({"type":"map","orientation":"orthogonal","renderorder":"right-down","version":"1.8","width":20,"height":20,
             "tilewidth":64,"tileheight":64,"infinite":false,"tilesets":[],"layers":[{"type":"objectgroup","objects":[)";
  const auto object = [&map](int id, const char* rest, double x, double y, double w, double h) {
    map << (id > 1 ? ",{" : "{") << R"("id":)" << id << R"(,"name":"","rotation":0,)" << rest << R"(,"x":)" << 64.0 * x
        << R"(,"y":)" << 64.0 * (20.0 - y) << R"(,"width":)" << 64.0 * w << R"(,"height":)" << 64.0 * h << "}";
  };
  object(1, R"("type":"ground")", 0.0, 1.0, 20.0, 1.0);
  object(2, R"("type":"player","point":true)", 5.0, 1.0 + player_height, 0.0, 0.0);
  object(3, R"("type":"goal")", 18.0, 19.0, 1.0, 1.0);
  object(4, R"("type":"circle","ellipse":true,"properties":[{"name":"body","type":"string","value":"dynamic"},
               {"name":"density","type":"float","value":20}])",
         ball_x, 2.0 + ball_height, 1.0, 1.0);
  object(5, R"("type":"hook","point":true)", 6.0, 7.0, 0.0, 0.0);
  object(6, R"("type":"checkpoint")", 7.0, 4.0, 1.0, 4.0);
  map << "]}]}";
  return level_of(engine::parse_tiled_map(map.str(), "drop.tmj"));
}

struct Heard {
  std::vector<Cue> cues;
  double most_wind = 0.0;
  double most_reel = 0.0;

  int count(Noise noise) const {
    return static_cast<int>(std::count_if(cues.begin(), cues.end(), [&](const Cue& c) { return c.noise == noise; }));
  }
  double loudest(Noise noise) const {
    double most = 0.0;
    for (const Cue& cue : cues) most = cue.noise == noise ? std::max(most, cue.how.volume) : most;
    return most;
  }
};

Heard listen(CueDetector& detector, Simulation& simulation, int ticks, int buttons = 0) {
  Heard heard;
  engine::TickInput input;
  input.buttons = static_cast<std::uint16_t>(buttons);
  for (int k = 0; k < ticks; ++k) {
    simulation.tick(input);
    detector.update(simulation);
    heard.cues.insert(heard.cues.end(), detector.cues().begin(), detector.cues().end());
    heard.most_wind = std::max(heard.most_wind, detector.wind().volume);
    heard.most_reel = std::max(heard.most_reel, detector.reel().volume);
  }
  return heard;
}

Heard heard_of(const Level& level, int ticks, int buttons = 0) {
  CueDetector detector;
  Simulation simulation(level);
  return listen(detector, simulation, ticks, buttons);
}

Heard winning_run(CueDetector& detector, Simulation& simulation) {
  Heard heard;
  Simulation unheard(simulation.level());
  test_support::Autopilot autopilot;
  while (!simulation.goal_ticks() && simulation.ticks() < 1800) {
    engine::TickInput input;
    input.buttons = autopilot.buttons(simulation);
    simulation.tick(input);
    detector.update(simulation);
    heard.cues.insert(heard.cues.end(), detector.cues().begin(), detector.cues().end());
    heard.most_wind = std::max(heard.most_wind, detector.wind().volume);
    unheard.tick(input);
    if (simulation.hash() == unheard.hash()) continue;
    ADD_FAILURE() << "listening changed the run in tick " << simulation.ticks();
    break;
  }
  return heard;
}

TEST(CueDetector, DetectsTheEventsOfAWinningRunAndChangesNoneOfItsBits) {
  CueDetector detector;
  Simulation simulation(first_swing_level());
  const Heard heard = winning_run(detector, simulation);
  EXPECT_EQ(heard.count(Noise::goal), 1);
  EXPECT_GE(heard.count(Noise::catches), 2);
  EXPECT_EQ(heard.count(Noise::catches), heard.count(Noise::lets_go));
  EXPECT_GE(heard.count(Noise::creak), 3);
  EXPECT_LE(heard.count(Noise::creak), simulation.ticks() / 14);
  EXPECT_GE(heard.count(Noise::jump), 1);
  EXPECT_GE(heard.count(Noise::footstep), 3);
  EXPECT_GT(heard.most_wind, 0.05);
  for (const Cue& cue : heard.cues) {
    EXPECT_GE(cue.how.volume, 0.0);
    EXPECT_LE(cue.how.volume, 1.0);
    EXPECT_GT(cue.how.pitch, 0.5);
    EXPECT_LT(cue.how.pitch, 2.0);
  }
}

TEST(CueDetector, AHigherFallIsLouder) {
  double last = 0.0;
  for (const double height : {0.2, 0.6, 1.8}) {
    const Heard heard = heard_of(drop(height), 90);
    EXPECT_EQ(heard.count(Noise::thud), 2) << "the player and the ball, " << height << " m";
    double own = 0.0;
    for (const Cue& cue : heard.cues) {
      if (cue.noise == Noise::thud && cue.how.pan == 0.0) own = cue.how.volume;
    }
    EXPECT_GT(own, last + 0.1) << height;
    last = own;
  }
}

TEST(CueDetector, DistantSoundsAreQuieterAndOnTheirSide) {
  const auto thud_of_ball = [](double x) {
    for (const Cue& cue : heard_of(drop(0.0, 1.0, x), 60).cues) {
      if (cue.noise == Noise::thud && cue.how.pan != 0.0) return cue.how;
    }
    return engine::Playing{0.0, 0.0, 0.0};
  };
  const engine::Playing near = thud_of_ball(6.5);
  const engine::Playing far = thud_of_ball(16.0);
  const engine::Playing left = thud_of_ball(1.0);
  EXPECT_GT(near.volume, 1.5 * far.volume);
  EXPECT_GT(far.pan, near.pan);
  EXPECT_GT(near.pan, 0.0);
  EXPECT_LT(left.pan, 0.0);
}

TEST(CueDetector, BodiesAtRestAreSilent) {
  CueDetector detector;
  const Level level = drop(0.0, 0.0);
  Simulation simulation(level);
  listen(detector, simulation, 30);
  const Heard heard = listen(detector, simulation, 200);
  EXPECT_TRUE(heard.cues.empty());
  EXPECT_EQ(heard.most_wind, 0.0);
}

TEST(CueDetector, RunningIsHeardInStepsThatComeWithTheSpeed) {
  const Heard heard = heard_of(drop(0.0), 120, button_right);
  EXPECT_NEAR(heard.count(Noise::footstep), 2.0 * 6.0 / 1.05, 2.0);
}

TEST(CueDetector, ALineIsHeardWhenThrownAttachedAndReeled) {
  CueDetector detector;
  const Level level = drop(0.0);
  Simulation simulation(level);
  listen(detector, simulation, 20);
  const Heard thrown = listen(detector, simulation, 30, button_throw);
  EXPECT_EQ(thrown.count(Noise::throws), 1);
  EXPECT_EQ(thrown.count(Noise::hook), 1);
  EXPECT_EQ(thrown.count(Noise::catches), 0) << "a line is no cord that is caught";
  ASSERT_EQ(simulation.player().line().state(), Line::State::held);
  EXPECT_EQ(thrown.most_reel, 0.0) << "no line is reeled";
  EXPECT_GT(listen(detector, simulation, 30, button_reel_in).most_reel, 0.3);
  EXPECT_EQ(listen(detector, simulation, 1, button_throw).count(Noise::lets_go), 1);
}

TEST(CueDetector, ACheckpointIsHeardOnce) {
  EXPECT_EQ(heard_of(drop(0.0), 60, button_right).count(Noise::checkpoint), 1);
}

/// A swing on ropes that break at a force: the largest share of it, and the warnings.
struct Swing {
  double most = 0.0;              // N
  std::vector<double> warned_at;  // N, the largest tension in the tick of each warning
};

Swing swing_with(double breaking_force) {
  const Level& level = first_swing_level();
  Simulation simulation(level);
  ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    const int links = static_cast<int>(coupling.cord(id).direct().tensions().size());
    for (int k = 0; k < links; ++k) coupling.cord(id).direct().set_breaking_force(k, breaking_force);
  }
  CueDetector detector;
  test_support::Autopilot autopilot;
  Swing swing;
  for (int k = 0; k < 300; ++k) {
    const bool holds = coupling.body(simulation.player().body()).held_place().has_value();
    simulation.tick({holds ? std::uint16_t{button_grab} : autopilot.buttons(simulation), {}});
    detector.update(simulation);
    double tension = 0.0;
    for (const ribbon::box2d::CordId id : coupling.cords()) {
      const auto tensions = coupling.cord(id).direct().tensions();
      tension = std::max(tension, *std::max_element(tensions.begin(), tensions.end()));
    }
    swing.most = std::max(swing.most, tension);
    for (const Cue& cue : detector.cues()) {
      if (cue.noise == Noise::strains) swing.warned_at.push_back(tension);
    }
  }
  return swing;
}

TEST(CueDetector, ARopeWarnsFrom80PerCentOfItsBreakingForceOn) {
  const double most = swing_with(1e9).most;
  ASSERT_GT(most, 600.0) << "it carries the player";
  EXPECT_TRUE(swing_with(most / 0.79).warned_at.empty());
  const double force = most / 0.99;
  const Swing near = swing_with(force);
  EXPECT_EQ(near.most, most) << "it did not break";
  ASSERT_GE(near.warned_at.size(), 1U);
  for (const double tension : near.warned_at) EXPECT_GE(tension, 0.8 * force);
}

TEST(CueDetector, ARestartIsNotHeardAsAFallAThudOrARelease) {
  Simulation simulation(first_swing_level());
  CueDetector detector;
  const engine::Replay golden = engine::load_replay(test_support::golden());
  for (const auto& tick : golden.ticks) {
    simulation.tick(tick.input);
    detector.update(simulation);
    if (simulation.scene().coupling().body(simulation.player().body()).held_place()) break;
  }
  engine::TickInput restart;
  restart.buttons = button_restart;
  simulation.tick(restart);
  detector.update(simulation);
  EXPECT_TRUE(detector.cues().empty());
}

TEST(CueDetector, TheSameRunHasTheSameCues) {
  CueDetector detector;
  Simulation first(first_swing_level());
  Simulation second(first_swing_level());
  const Heard once = winning_run(detector, first);
  CueDetector other;
  const Heard again = winning_run(other, second);
  ASSERT_EQ(once.cues.size(), again.cues.size());
  for (std::size_t k = 0; k < once.cues.size(); ++k) {
    EXPECT_EQ(once.cues[k].noise, again.cues[k].noise);
    EXPECT_EQ(once.cues[k].how.volume, again.cues[k].how.volume);
  }
}

/// The own sounds of both players where one runs and jumps.
std::array<Heard, 2> heard_of_two(int runner) {
  const Level level = test_support::level_for_two({.tied = false});
  Simulation simulation(level);
  std::array<CueDetector, 2> detectors{CueDetector(0), CueDetector(1)};
  std::array<Heard, 2> heard;
  for (int k = 0; k < 120; ++k) {
    engine::TickInput input;
    const auto buttons = static_cast<std::uint16_t>(k < 40 ? button_left : k < 60 ? button_left | button_jump : 0);
    (runner == 0 ? input.buttons : input.second_buttons) = buttons;
    simulation.tick(input);
    for (std::size_t p = 0; p < detectors.size(); ++p) {
      detectors[p].update(simulation);
      heard[p].cues.insert(heard[p].cues.end(), detectors[p].cues().begin(), detectors[p].cues().end());
    }
  }
  return heard;
}

TEST(CueDetector, EachPlayerHasItsOwnSounds) {
  const std::array<Heard, 2> first = heard_of_two(0);
  const std::array<Heard, 2> second = heard_of_two(1);
  for (const Noise noise : {Noise::jump, Noise::footstep}) {
    EXPECT_GE(first[0].count(noise), 1);
    EXPECT_EQ(second[1].count(noise), first[0].count(noise));
    EXPECT_EQ(first[1].count(noise), 0);
    EXPECT_EQ(second[0].count(noise), 0);
  }
  EXPECT_GE(second[0].count(Noise::thud), 1);  // one of the level
  EXPECT_EQ(second[1].count(Noise::thud), 0);
  for (const Cue& cue : second[1].cues) EXPECT_NE(cue.how.pan, 0.0);  // beside the first player
}

}  // namespace
}  // namespace game
