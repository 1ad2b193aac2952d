// Two players in one run, and the rope between them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "game/simulation/buttons.h"
#include "game/simulation/ghost.h"
#include "game/simulation/recorded_run.h"
#include "game/simulation/simulation.h"
#include "tests/game/simulation/press.h"
#include "tests/game/simulation/small_level.h"
#include "tests/support/dice.h"
#include "tests/support/level_for_two.h"
#include "tests/support/refusal.h"

namespace game {
namespace {

using ribbon::Vec2;
using test_support::level_for_two;
using test_support::LevelForTwo;

double x(const Simulation& simulation, int player) { return simulation.player(player).position().x; }

/// Lets the second player walk off the edge and hang there from the rope.
void hang_second(Simulation& simulation) {
  while (x(simulation, 1) < 16.5) {
    ASSERT_LT(simulation.ticks(), 300);
    simulation.tick(press(x(simulation, 0) < 11.5 ? button_right : 0, button_right));
  }
  run(simulation, 120, 0, 0);
  ASSERT_LT(height_of(simulation, 1), 4.0);
  ASSERT_FALSE(simulation.player(1).is_on_ground());
}

TEST(TwoPlayers, EachHasItsOwnButtons) {
  const Level level = level_for_two({.tied = false});
  Simulation simulation(level);
  run(simulation, 40, button_left, button_right);
  EXPECT_LT(x(simulation, 0), 6.5);
  EXPECT_GT(x(simulation, 1), 15.5);
}

TEST(TwoPlayers, DoNotTouchEachOther) {
  const Level level = level_for_two({.tied = false});
  Simulation simulation(level);
  run(simulation, 75, button_right, button_left);
  EXPECT_GT(x(simulation, 0), x(simulation, 1) + 3.0);
  EXPECT_NEAR(height_of(simulation, 0), 4.75, 0.05);
  EXPECT_NEAR(height_of(simulation, 1), 4.75, 0.05);
}

TEST(TwoPlayers, ASecondPlayersButtonsDoNothingInALevelForOne) {
  const Level level = load_level(default_level);
  Simulation with(level);
  Simulation without(level);
  for (int k = 0; k < 60; ++k) {
    with.tick(press(button_right, button_left | button_jump | button_restart | button_retry));
    without.tick(press(button_right, 0));
  }
  EXPECT_EQ(with.hash(), without.hash());
}

TEST(TwoPlayers, OnlyBothTogetherWin) {
  const Level level = level_for_two({.tied = false});
  Simulation simulation(level);
  simulation.player().put({40.0, 4.0}, simulation.scene().coupling());
  run(simulation, 30, 0, 0);
  EXPECT_TRUE(simulation.is_at_flag(0));
  EXPECT_FALSE(simulation.is_at_flag(1));
  EXPECT_FALSE(simulation.goal_ticks());
  const_cast<Player&>(simulation.player(1)).put({39.0, 4.0}, simulation.scene().coupling());
  run(simulation, 30, 0, button_right);
  EXPECT_TRUE(simulation.goal_ticks());
}

TEST(TwoPlayers, EitherReachesTheCheckpointAndBothReturnToIt) {
  const Level level = level_for_two({.knows_checkpoint = true});
  Simulation simulation(level);
  while (x(simulation, 1) > 12.0) {
    ASSERT_LT(simulation.ticks(), 600);
    simulation.tick(press(0, button_left));
  }
  EXPECT_EQ(simulation.checkpoint(), 0U);
  run(simulation, 1, 0, button_retry);
  EXPECT_NEAR(x(simulation, 0), 11.6, 0.05);
  EXPECT_NEAR(x(simulation, 1), 12.4, 0.05);
  run(simulation, 240, 0, 0);
  EXPECT_NEAR(x(simulation, 0), 11.6, 0.3) << "the rope between them comes to rest";
  EXPECT_NEAR(x(simulation, 1), 12.4, 0.3);
  run(simulation, 90, button_left, button_right);
  EXPECT_LT(x(simulation, 1) - x(simulation, 0), simulation.tether()->length() + 0.05) << "both are tied again";
}

TEST(Tether, KeepsThePlayersWithinItsLength) {
  const Level level = level_for_two();
  Simulation simulation(level);
  const double whole = simulation.tether()->length();
  EXPECT_NEAR(whole, 7.25, 0.1);
  double most = 0.0;
  for (int k = 0; k < 60; ++k) {
    simulation.tick(press(button_left, button_right));
    most = std::max(most, x(simulation, 1) - x(simulation, 0));
  }
  EXPECT_GT(most, whole - 0.25) << "it is taut";
  EXPECT_LT(most, whole + 0.05);
}

TEST(Tether, APlayerThatStandsStillBearsItsPartner) {
  const Level level = level_for_two();
  Simulation simulation(level);
  hang_second(simulation);
  const double before = x(simulation, 0);
  const double height = height_of(simulation, 1);
  run(simulation, 120, 0, 0);
  EXPECT_NEAR(x(simulation, 0), before, 0.02);
  EXPECT_NEAR(height_of(simulation, 1), height, 0.05);
}

TEST(Tether, AHeavyPartnerPullsItAlong) {
  const Level level = level_for_two({.second_mass = 300.0});
  Simulation simulation(level);
  while (x(simulation, 1) < 16.5) {
    ASSERT_LT(simulation.ticks(), 300);
    simulation.tick(press(x(simulation, 0) < 11.5 ? button_right : 0, button_right));
  }
  run(simulation, 60, 0, 0);
  const double before = x(simulation, 0);
  run(simulation, 240, 0, 0);
  EXPECT_GT(x(simulation, 0), before + 0.3);
}

TEST(Tether, ReelingHaulsThePartnerUp) {
  const Level level = level_for_two();
  Simulation simulation(level);
  hang_second(simulation);
  const double height = height_of(simulation, 1);
  const double whole = simulation.tether()->length();
  run(simulation, 60, button_reel_in, 0);
  // It begins with a jolt, in which it is stronger than the player for some ticks.
  EXPECT_NEAR(simulation.tether()->length(), whole - Tether::reel_in_speed, 0.15);
  EXPECT_NEAR(height_of(simulation, 1), height + Tether::reel_in_speed, 0.35);
  run(simulation, 60, 0, button_reel_out);
  EXPECT_NEAR(simulation.tether()->length(), whole, 1e-9) << "not longer than it is";
}

TEST(Tether, IsNeverCaughtByTheHand) {
  const Level level = level_for_two();
  Simulation simulation(level);
  run(simulation, 60, button_grab, button_grab | button_jump);
  for (int k = 0; k < 2; ++k) EXPECT_FALSE(simulation.player(k).held_place(simulation.scene().coupling()));
}

TEST(Tether, AfterAFallOfOneBothReturnAndTheRopeIsWhole) {
  const Level level = level_for_two();
  Simulation simulation(level);
  run(simulation, 30, button_reel_in, 0);
  const double whole = simulation.scene().coupling().cord(simulation.tether()->cord()).direct().def().length;
  EXPECT_LT(simulation.tether()->length(), whole - 0.5);
  simulation.scene().coupling().cord(simulation.tether()->cord()).cut(3.0);
  while (simulation.falls() == 0) {
    ASSERT_LT(simulation.ticks(), 600);
    simulation.tick(press(0, button_right));
  }
  EXPECT_NEAR(x(simulation, 0), 8.0, 1e-6);
  EXPECT_NEAR(x(simulation, 1), 14.0, 1e-6);
  ASSERT_TRUE(simulation.scene().coupling().cord(simulation.tether()->cord()).is_valid());
  EXPECT_EQ(simulation.tether()->length(), whole);
  run(simulation, 120, button_left, button_right);
  EXPECT_LT(x(simulation, 1) - x(simulation, 0), whole + 0.05) << "it holds again";
}

/// Its end stays at the waist, within the grab range: a catch must not take the place that the waist holds.
TEST(Tether, ThatIsCutIsNotCaught) {
  const Level level = level_for_two();
  Simulation simulation(level);
  run(simulation, 30);
  ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const ribbon::box2d::CutEvent cut = coupling.cord(simulation.tether()->cord()).cut(1.0);
  ASSERT_TRUE(cut.first);
  for (int k = 0; k < 60; ++k) {
    run(simulation, 1, k % 2 == 0 ? button_grab | button_jump : 0, k % 2 == 0 ? button_grab : 0);
    for (const int player : {0, 1}) {
      const auto held = simulation.player(player).held_place(coupling);
      EXPECT_FALSE(held && held->cord == *(player == 0 ? cut.first : cut.second)) << k;
    }
  }
}

TEST(Tether, WithoutFallsBothReturnToAFoothold) {
  Level level = level_for_two();
  level.assists.no_fall = true;
  Simulation simulation(level);
  run(simulation, 60, button_right, 0);
  int returns = 0;
  for (int k = 0; k < 400; ++k) {
    const double before = height_of(simulation, 1);
    simulation.tick(press(button_right, button_right));
    returns += height_of(simulation, 1) > before + 1.0 ? 1 : 0;
  }
  EXPECT_GT(returns, 0);
  EXPECT_EQ(simulation.falls(), 0);
  while (height_of(simulation, 1) < 4.7) {
    ASSERT_LT(simulation.ticks(), 1200);
    run(simulation, 1);
  }
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(height_of(simulation, k), 4.75, 0.1) << "on the ground";
}

/// Two random players that hold each button for a while.
class RandomPair {
 public:
  engine::TickInput next() {
    if (left_-- == 0) {
      left_ = static_cast<int>(dice_(3.0, 40.0));
      buttons_ = press(random(), random());
    }
    return buttons_;
  }

 private:
  int random() {
    int buttons = 0;
    for (const int button : {button_left, button_right, button_jump, button_reel_in, button_reel_out, button_grab}) {
      if (dice_(0.0, 1.0) < 0.35) buttons |= button;
    }
    return buttons;
  }

  test_support::Dice dice_{3};
  engine::TickInput buttons_{};
  int left_ = 0;
};

TEST(TwoPlayers, SaveAndRestoreGiveTheSameBits) {
  const Level level = level_for_two({.knows_checkpoint = true});
  Simulation simulation(level);
  simulation.scene().world().SetAllowSleeping(false);
  RandomPair pair;
  SavedTick saved;
  SavedTick before;
  for (int round = 0; round < 40; ++round) {
    std::vector<engine::TickInput> inputs;
    std::vector<std::uint64_t> hashes;
    simulation.save(before);
    simulation.tick(pair.next());
    simulation.save(saved);
    const auto here = simulation.hash();
    for (int k = 0; k < 20; ++k) {
      inputs.push_back(pair.next());
      simulation.tick(inputs.back());
      hashes.push_back(simulation.hash().combined());
    }
    ASSERT_TRUE(simulation.restore(saved, &before));
    EXPECT_EQ(simulation.hash(), here);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      simulation.tick(inputs[k]);
      ASSERT_EQ(simulation.hash().combined(), hashes[k]) << "round " << round << ", tick " << k;
    }
  }
}

TEST(TwoPlayers, TheHashHasBothPlayersAndTheRope) {
  const Level level = level_for_two();
  const auto hash_after = [&level](int first, int second) {
    Simulation simulation(level);
    simulation.tick(press(first, second));
    return simulation.hash().combined();
  };
  EXPECT_NE(hash_after(0, 0), hash_after(0, button_left));
  EXPECT_NE(hash_after(0, 0), hash_after(button_left, 0));
  EXPECT_NE(hash_after(0, 0), hash_after(button_reel_in, 0));
  EXPECT_EQ(hash_after(button_left, button_left), hash_after(button_left, button_left));
}

RunOptions recorded() {
  RunOptions options;
  options.replay = assets_folder() + "/replays/pull_me_up.replay";
  return options;
}

TEST(TwoPlayers, ARecordingOfBothIsVerifiedAndSought) {
  const engine::Replay replay = engine::load_replay(recorded().replay);
  EXPECT_EQ(replay.header.players, 2);
  RunOptions options = recorded();
  options.verify = true;
  RecordedRun verified(options);
  while (!verified.is_over()) verified.tick({});
  EXPECT_EQ(verified.exit_status(), 0) << verified.closing_line();
  RecordedRun sought(recorded());
  for (const int tick : {250, 20, 400}) {
    sought.seek(tick);
    EXPECT_EQ(sought.simulation().hash(), replay.ticks[static_cast<std::size_t>(tick) - 1].state) << tick;
  }
}

TEST(TwoPlayers, ARecordingWithOtherButtonsOfTheSecondDiffers) {
  engine::Replay replay = engine::load_replay(recorded().replay);
  replay.ticks[10].input.second_buttons ^= button_right;
  const Level level = load_level(replay.header.level);
  Simulation simulation(level);
  engine::ReplayVerifier verifier(replay);
  while (!verifier.done()) {
    simulation.tick(verifier.input());
    verifier.check(simulation.hash());
  }
  EXPECT_EQ(verifier.result().outcome, engine::VerifyOutcome::diverged);
  EXPECT_EQ(verifier.result().ticks, 10U);
}

TEST(TwoPlayers, TheGhostHasBoth) {
  const Level level = load_level("pull_me_up");
  const auto ghost = Ghost::load(recorded().replay, level);
  ASSERT_TRUE(ghost);
  Simulation simulation(level);
  const engine::Replay replay = engine::load_replay(recorded().replay);
  for (int k = 0; k < 100; ++k) {
    ghost->advance(k);
    simulation.tick(replay.ticks[static_cast<std::size_t>(k)].input);
  }
  for (int k = 0; k < 2; ++k) {
    ASSERT_TRUE(ghost->at(100, k));
    EXPECT_EQ(ghost->at(100, k)->at, simulation.player(k).position());
  }
  EXPECT_FALSE(Ghost::load(TEST_ASSETS "/replays/first_swing.replay", load_level("first_swing"))->at(0, 1));
}

TEST(TheLightOneFirst, TheThinRopeBreaksUnderTheHeavyOne) {
  const Level level = load_level("the_light_one_first");
  Simulation simulation(level);
  while (x(simulation, 0) > 13.0 || x(simulation, 1) > 11.2) {
    ASSERT_LT(simulation.ticks(), 600);
    simulation.tick(x(simulation, 0) > 13.0 ? press(button_left) : press(0, button_left));
  }
  int breaks = 0;
  for (int k = 0; k < 120; ++k) {
    simulation.tick(press(0, button_grab | button_up));
    for (const ribbon::box2d::CutEvent& cut : simulation.scene().coupling().last_step().cut_events())
      breaks += cut.broke ? 1 : 0;
  }
  EXPECT_GE(breaks, 1);
  EXPECT_NEAR(height_of(simulation, 1), 3.75, 0.1);
}

/// Returns the map of a level for two whose second player is changed.
engine::TiledMap with_second(const std::function<void(engine::MapObject&)>& change) {
  engine::TiledMap map = level_for_two().map;
  for (engine::MapObject& object : map.objects) {
    if (object.kind == "player_2") change(object);
  }
  return map;
}

TEST(LevelForTwo, SaysWhatIsWrongAndWhatIsAccepted) {
  const auto moved = with_second([](engine::MapObject& second) { second.position.x += 1.0; });
  EXPECT_NE(level_refusal(moved).find("a cord with an end 1 m from its player"), std::string::npos)
      << level_refusal(moved);
  const auto shaped = with_second([](engine::MapObject& second) { second.shape = engine::MapShape::rectangle; });
  EXPECT_NE(level_refusal(shaped).find("accepted is point"), std::string::npos);
  engine::TiledMap three = level_for_two().map;
  three.objects.push_back(three.objects[1]);
  EXPECT_NE(level_refusal(three).find("is a second player_2"), std::string::npos);
  engine::TiledMap untied = level_for_two().map;
  std::erase_if(untied.objects, [](const engine::MapObject& object) { return object.kind == "cord"; });
  EXPECT_NE(level_refusal(untied).find("\"tether\" is 7; accepted is the id of a cord"), std::string::npos)
      << level_refusal(untied);
  for (const char* const property : {"pin_first", "solid"}) {
    engine::TiledMap held = level_for_two().map;
    for (engine::MapObject& object : held.objects) {
      if (object.kind == "cord") object.properties.insert(property, true);
    }
    EXPECT_NE(level_refusal(held).find("accepted is a cord without pins, anchors and wheels that is not solid"),
              std::string::npos)
        << level_refusal(held);
  }
}

TEST(TwoPlayers, EitherRestartsTheRun) {
  const Level level = level_for_two();
  Simulation simulation(level);
  run(simulation, 40, button_left, button_right);
  run(simulation, 1, 0, button_restart);
  EXPECT_EQ(simulation.run_ticks(), 1);
  EXPECT_NEAR(x(simulation, 1), 14.0, 1e-3);
}

}  // namespace
}  // namespace game
