#include "tests/study/windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/scene/tiled_edit.h"
#include "tests/study/level_study_fixture.h"
#include "tests/study/setting.h"
#include "tests/study/text.h"

namespace study {
namespace {

using ribbon::Accuracy;
using ribbon::Integrator;
using ribbon::Vec2;

/// Returns a trace of a cord at rest for a number of ticks, and a player.
Trace still_cord(std::size_t ticks) {
  Trace trace;
  trace.lengths = {1.0};
  trace.places.assign(ticks, std::vector<Vec2>(Trace::stations));
  trace.cords.assign(ticks, {{0, 0}});
  trace.player.assign(ticks, {});
  trace.bodies.assign(ticks, {});
  trace.stretch.assign(ticks, 0.0);
  return trace;
}

TEST(Windows, CordsAndPlayersAgreeForDifferentTimes) {
  const Trace a = still_cord(10);
  Trace b = still_cord(10);
  b.places[6][0] = {0.0, 0.01 * std::sqrt(1.0 * Trace::stations)};
  b.player[3] = {0.02, 0.0};
  EXPECT_EQ(agreeing_cord_ticks(a, b, 0.0099), 6U);
  EXPECT_EQ(agreeing_cord_ticks(a, b, 0.0101), 10U);
  EXPECT_EQ(agreeing_player_ticks(a, b, 0.01), 3U);
  b.places[2][0] = {std::nan(""), 0.0};
  EXPECT_EQ(agreeing_cord_ticks(a, b, 1.0), 2U);
  EXPECT_EQ(agreeing_player_ticks(a, still_cord(2), 0.01), 2U);
}

TEST(Windows, ValuesThatAreNotComparedGiveNoError) {
  EXPECT_EQ(WindowErrors{}.greatest(), 0.0);
  EXPECT_EQ((WindowErrors{unavailable, 2.0}.greatest()), 2.0);
  EXPECT_EQ((WindowErrors{3.0, 2.0}.greatest()), 3.0);
}

/// The run has the level's own settings until a tick, and another setting from then on.
TEST(Windows, ARunFromATickStartsInTheStateOfTheLevel) {
  const game::Level level = game::load_level("first_swing");
  const std::vector<engine::TickInput> inputs(40);
  const Trace whole = run(level, inputs);
  const Trace same = run_part(level, inputs, {25, 10, 0, {Accuracy::balanced()}});
  ASSERT_EQ(same.places.size(), 10U);
  EXPECT_EQ(same.places.front(), whole.places[25]);
  EXPECT_EQ(same.places.back(), whole.places[34]);
  const Trace other = run_part(level, inputs, {25, 100, 0, {Accuracy::fast()}});
  EXPECT_EQ(other.places.size(), 15U);
  EXPECT_NE(other.places.front(), whole.places[25]);
}

TEST(Windows, ARunEndsWhereItIsTold) {
  const game::Level level = game::load_level("first_swing");
  const std::vector<engine::TickInput> inputs(40);
  const Trace trace = StartedRun(level, inputs, 5).finish(20, {}, [](const Trace& t) { return t.places.size() == 7; });
  EXPECT_EQ(trace.places.size(), 7U);
}

/// The cord falls freely for the first ticks.
TEST_F(LevelStudy, AKickChangesAllVelocities) {
  leave_a_loose_cord();
  const game::Level level = game::load_level(level_path);
  const std::vector<engine::TickInput> inputs(10);
  const Trace left = run_part(level, inputs, {2, 6, 0, {{}, -0.1}});
  const Trace right = run_part(level, inputs, {2, 6, 0, {{}, 0.1}});
  const Vec2 apart = right.places.back()[0] - left.places.back()[0];
  EXPECT_NEAR(apart.x, 0.2 * 6.0 / 60.0, 1e-3);
  EXPECT_NEAR(apart.y, 0.0, 1e-6);
}

TEST_F(LevelStudy, APartThatBlowsUpSaysSo) {
  leave_a_loose_cord(-200'000);  // kilometres away
  const game::Level level = game::load_level(level_path);
  const std::vector<engine::TickInput> inputs(40);
  const Trace trace = run_part(level, inputs, {2, 6});
  EXPECT_EQ(trace.failure, "blew up in tick 3");
  EXPECT_EQ(trace.places.size(), 1U);
  const Windows windows(level, inputs, Accuracy::balanced(), Accuracy::balanced(), 2);
  EXPECT_EQ(windows.errors({}).failure, "blew up in tick 1 of a run that continues from tick 0");
}

/// Contacts are stiffer with more substeps: what presses on the contacts of one substep is too deep in those of 32. In
/// these ticks pieces of a bridge that was cut lie on each other.
TEST(Windows, ALeadInTakesAwayMostOfTheErrorOfTheStart) {
  const game::Level level = game::load_level("cut_the_bridge");
  const std::vector<engine::TickInput> inputs =
      inputs_of(engine::load_replay(TEST_ASSETS "/replays/cut_the_bridge.replay"));
  const auto error_of_one_substep = [&](std::size_t lead_in) {
    const Trace one = run_part(level, inputs, {266, 15, lead_in, {Accuracy{Integrator::tr_bdf2, 1, 8, 1e-4}}});
    const Trace fine = run_part(level, inputs, {266, 15, lead_in, {accuracy_of(reference({}, false, true))}});
    return difference(one, fine, 15).position_m;
  };
  const double without = error_of_one_substep(0);
  EXPECT_GT(without, 2e-3);
  EXPECT_LT(error_of_one_substep(Windows::lead_in), 0.5 * without);
}

/// The level first_swing, whose hammock falls to its shape at the start.
game::Level falling_hammock() {
  constexpr int hammock = 12;  // its object
  const std::string text = read_file(TEST_ASSETS "/levels/first_swing.tmj");
  return game::level_of(engine::parse_tiled_map(engine::with_property(text, hammock, "at_rest", false), "falling.tmj"));
}

TEST(Windows, ErrorsFallWithTheSubsteps) {
  const game::Level level = falling_hammock();
  const std::vector<engine::TickInput> inputs(40);
  const Windows windows(level, inputs, {Integrator::tr_bdf2, 16, 8, 1e-7}, {Integrator::tr_bdf2, 32, 8, 1e-7}, 20);
  EXPECT_EQ(windows.count(), 2U);  // of 15 ticks in 40
  EXPECT_EQ(windows.compared_cords(), 1.0);
  EXPECT_EQ(windows.compared_players(), 1.0);
  const double one = windows.errors(Accuracy{Integrator::tr_bdf2, 1, 8, 1e-5}).position_m;
  const double four = windows.errors(Accuracy{Integrator::tr_bdf2, 4, 8, 1e-6}).position_m;
  EXPECT_NEAR(std::log(one / four) / std::log(4.0), 2.0, 0.4);
  EXPECT_LT(windows.agreement().position_m, 0.2 * four);
  EXPECT_EQ(windows.errors(Accuracy{Integrator::tr_bdf2, 32, 8, 1e-7}).position_m, 0.0);
}

TEST(Windows, SettingsByCordComeBeforeThatOfAll) {
  const game::Level level = falling_hammock();
  const std::vector<engine::TickInput> inputs(40);
  const Accuracy exact{Integrator::tr_bdf2, 32, 8, 1e-7};
  const Accuracy coarse{Integrator::tr_bdf2, 1, 8, 1e-5};
  const Windows windows(level, inputs, {Integrator::tr_bdf2, 16, 8, 1e-7}, exact, 20);
  const auto scene = level.make_scene();
  Windows::CordAccuracies all_exact, all_coarse;
  for (const ribbon::box2d::CordId cord : scene->coupling().cords()) {
    all_exact[cord] = exact;
    all_coarse[cord] = coarse;
  }
  const double error = windows.errors(coarse).position_m;
  ASSERT_GT(error, 0.0);
  EXPECT_EQ(windows.errors(coarse, all_exact).position_m, 0.0);
  EXPECT_EQ(windows.errors(exact, all_coarse).position_m, error);
}

}  // namespace
}  // namespace study
