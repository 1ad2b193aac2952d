#include "tests/study/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "game/simulation/buttons.h"
#include "tests/study/errors.h"
#include "tests/study/level_file.h"

namespace study {
namespace {

using ribbon::Vec2;

/// Returns a trace of two cords of 1 and 4 m at rest, and a player.
Trace still(std::size_t ticks) {
  Trace trace;
  trace.lengths = {1.0, 4.0};
  trace.places.assign(ticks, std::vector<Vec2>(2 * Trace::stations));
  trace.cords.assign(ticks, {{0, 0}, {1, 0}});
  trace.player.assign(ticks, {});
  trace.bodies.assign(ticks, {{0.0, 0.0}});
  trace.stretch.assign(ticks, 0.0);
  trace.mass = 3.0;
  trace.gravity = 9.0;
  Figures figures;
  figures.tension = 100.0;
  figures.penetration = 0.0;
  figures.energy = 50.0;
  trace.figures.assign(ticks, figures);
  return trace;
}

TEST(Trace, ErrorsAreTheirDefinitions) {
  const Trace a = still(10);
  Trace b = still(10);
  for (auto& places : b.places) {
    for (std::size_t s = 0; s < places.size(); ++s) places[s] = s < Trace::stations ? Vec2{0.3, 0.0} : Vec2{0.0, 0.4};
  }
  for (std::size_t k = 0; k < 5; ++k) b.player[k] = {0.0, 2.0};
  b.stretch[3] = 0.01;
  const Errors errors = difference(a, b, 10);
  EXPECT_NEAR(errors.position_m, std::sqrt(0.5 * (0.09 + 0.16)), 1e-15);
  EXPECT_NEAR(errors.position_relative, std::sqrt(0.5 * (0.09 + 0.01)), 1e-15);
  EXPECT_NEAR(errors.player_m, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(errors.stretch, 0.01, 1e-15);
  EXPECT_NEAR(errors.greatest_length(), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(difference(a, b, 3).stretch, 0.0, 1e-15);
}

/// The second cord of one run is cut in tick 6, that of the other one in tick 7, and cord 3 arrives in tick 8.
TEST(Trace, CordsAreComparedWhileBothRunsHaveThem) {
  Trace a = still(10);
  Trace b = still(10);
  for (Trace* trace : {&a, &b}) trace->lengths = {1.0, 4.0, 2.0, 2.0};
  const auto cut = [](Trace& trace, std::size_t tick, Vec2 place) {
    for (std::size_t k = tick; k < 10; ++k) {
      trace.cords[k] = {{0, 0}, {1, 1}, {2, 0}};
      trace.places[k].assign(3 * Trace::stations, place);
    }
  };
  cut(a, 5, {0.0, 0.0});
  cut(b, 6, {0.0, 0.5});
  b.cords[7].push_back({3, 0});
  b.places[7].insert(b.places[7].end(), Trace::stations, Vec2{50.0, 0.0});
  const double common = 6.0 * 2.0 - 1.0 + 4.0 * 3.0;  // cords and ticks; the second one in tick 6 is not the same
  EXPECT_NEAR(difference(a, b, 10).position_m, std::sqrt(0.25 * 12.0 / common), 1e-15);
  EXPECT_EQ(difference(a, b, 6).position_m, 0.0);
  EXPECT_EQ(agreeing_ticks(a, b, 0.01), 6U);
  Trace none = still(10);
  none.cords.assign(10, {});
  none.places.assign(10, {});
  EXPECT_TRUE(std::isnan(difference(none, a, 10).position_m));
  EXPECT_EQ(difference(none, a, 10).greatest_length(), 0.0);
  EXPECT_TRUE(a.has_cords());
  EXPECT_FALSE(none.has_cords());
}

TEST(Trace, BodiesHaveAnErrorOfTheirOwn) {
  const Trace a = still(10);
  Trace b = still(10);
  for (std::size_t k = 5; k < 10; ++k) b.bodies[k] = {{0.0, 4.0}};
  EXPECT_NEAR(difference(a, b, 10).body_m, std::sqrt(8.0), 1e-15);
  EXPECT_NEAR(difference(a, b, 10).greatest_length(), std::sqrt(8.0), 1e-15);
  EXPECT_EQ(agreeing_ticks(a, b, 0.01), 5U);
}

TEST(Trace, ErrorsOfOtherKindsAreSharesOfTheirScales) {
  const Trace reference = still(10);
  Trace trace = still(10);
  trace.figures[2].tension = 130.0;
  trace.figures[4].penetration = 0.7;
  trace.figures[5].energy = 50.0 - 27.0;
  trace.figures[6].momentum = {0.0, -9.0};
  const Errors errors = difference(trace, reference, 10);
  EXPECT_NEAR(errors.tension, 0.3, 1e-15);
  EXPECT_NEAR(errors.penetration, 0.7, 1e-15);
  EXPECT_NEAR(errors.energy, 27.0 / (3.0 * 9.0 * 4.0), 1e-15);  // the longest cord has 4 m
  EXPECT_NEAR(errors.momentum, 9.0 / (3.0 * 6.0), 1e-15);
  EXPECT_NEAR(difference(reference, trace, 10).tension, 30.0 / 130.0, 1e-15);
  EXPECT_EQ(difference(reference, trace, 10).penetration, 0.0);  // the value of the run itself, not a difference
  EXPECT_EQ(difference(trace, reference, 2).tension, 0.0);
  EXPECT_EQ(difference(trace, reference, 2).energy, 0.0);
}

TEST(Trace, UnavailableFiguresGiveNoError) {
  Trace trace = still(10);
  trace.figures[3] = {};
  Errors errors = difference(trace, still(10), 10);
  for (const double error : {errors.tension, errors.penetration, errors.energy}) EXPECT_TRUE(std::isnan(error));
  EXPECT_EQ(errors.momentum, 0.0);
  trace.figures.clear();
  errors = difference(trace, still(10), 10);
  EXPECT_TRUE(std::isnan(errors.momentum));
  Trace weightless = still(10);
  weightless.gravity = 0.0;
  EXPECT_TRUE(std::isnan(difference(still(10), weightless, 10).energy));
}

TEST(Trace, RunsAgreeUntilTheirFirstDifference) {
  const Trace a = still(10);
  Trace b = still(10);
  EXPECT_EQ(agreeing_ticks(a, b, 0.01), 10U);
  b.player[7] = {0.02, 0.0};
  EXPECT_EQ(agreeing_ticks(a, b, 0.01), 7U);
  b.places[4][40] = {0.0, -0.02};
  EXPECT_EQ(agreeing_ticks(a, b, 0.01), 4U);
  b.places[2][0] = {std::nan(""), 0.0};
  EXPECT_EQ(agreeing_ticks(a, b, 0.01), 2U);
  EXPECT_EQ(agreeing_ticks(a, still(1), 0.01), 1U);
}

TEST(Trace, ARunOfALevelIsTheSimulation) {
  const game::Level level = game::load_level("first_swing");
  const std::vector<engine::TickInput> inputs(20);
  const Trace trace = run(level, inputs);
  game::Simulation simulation(level);
  for (const engine::TickInput& input : inputs) simulation.tick(input);
  const auto x = simulation.scene().coupling().cord(0).positions();
  ASSERT_EQ(trace.places.size(), 20U);
  EXPECT_EQ(trace.places.back().front(), x.front());
  EXPECT_EQ(trace.places.back()[Trace::stations - 1], x.back());
  EXPECT_EQ(trace.player.back(), simulation.player().position());
  EXPECT_GT(trace.work.iterations, 0);
  EXPECT_GT(trace.figures.back().tension, 0.0);
  EXPECT_GE(trace.figures.back().penetration, 0.0);
  EXPECT_LT(trace.figures.back().penetration, 1.0);
  EXPECT_NEAR(trace.figures.back().stretch, 0.0, 1e-3);
  double energy = 0.0;
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    const double speed = length(simulation.scene().coupling().body(*body).velocity());
    if (body->GetType() == b2_dynamicBody) energy += 0.5 * static_cast<double>(body->GetMass()) * speed * speed;
  }
  EXPECT_GE(trace.figures.back().kinetic, energy);
  EXPECT_GT(trace.mass, level.player_mass + 13.0);  // plus its cords
  EXPECT_NEAR(trace.gravity, 9.81, 1e-6);
  EXPECT_TRUE(trace.failure.empty());
}

/// A ball flies over the pin of a hanging cord to the other side; 64 pixels are a metre, y is down.
constexpr const char* thrown_over = R"({
 "type": "map", "orientation": "orthogonal", "width": 20, "height": 20, "tilewidth": 32, "tileheight": 32,
 "layers": [{"type": "objectgroup", "name": "all", "objects": [
  {"id": 1, "type": "ground", "x": 0, "y": 608, "width": 640, "height": 32},
  {"id": 2, "type": "player", "x": 64, "y": 608, "width": 0, "height": 0, "point": true},
  {"id": 3, "type": "goal", "x": 512, "y": 320, "width": 32, "height": 32},
  {"id": 4, "type": "cord", "x": 320, "y": 240, "polyline": [{"x": 0, "y": 0}, {"x": 0, "y": 64}], "properties": [
   {"name": "columns", "type": "int", "value": 9}, {"name": "mass", "type": "float", "value": 1},
   {"name": "pin_first", "type": "bool", "value": true}]},
  {"id": 5, "type": "circle", "x": 284.8, "y": 268.8, "width": 6.4, "height": 6.4, "ellipse": true, "properties": [
   {"name": "density", "type": "float", "value": 1}, {"name": "velocity_x", "type": "float", "value": 2},
   {"name": "velocity_y", "type": "float", "value": 4.9}]}]}]})";

/// The two ropes of the lift are one island.
TEST(Trace, TheWorkOfAnIslandCountsOnce) {
  const LevelFile file(TEST_ASSETS "/levels/the_lift.tmj");
  std::vector<engine::TickInput> inputs(10);
  const Trace trace = run(file.level(), inputs);
  EXPECT_GT(trace.work.work, 0);
  EXPECT_EQ(trace.work.work, std::accumulate(trace.tick_work.begin(), trace.tick_work.end(), std::int64_t{0}));
}

TEST(Trace, ARestartDoesNotCountAsTunnelling) {
  const game::Level level = game::level_of(engine::parse_tiled_map(thrown_over, "thrown_over.tmj"));
  std::vector<engine::TickInput> inputs(70);
  inputs[60].buttons = game::button_restart;
  LevelRun jump(level, inputs);
  jump.reset();
  const auto ball = [&jump] { return jump.simulation().current().bodies.rbegin()[1].position; };  // before the player
  const double start = ball().x;
  for (int k = 0; k < 60; ++k) jump.tick();
  EXPECT_GT(ball().x, 5.5);  // to the right of the cord
  EXPECT_GT(ball().y, 5.5);  // and at its height
  EXPECT_LT(ball().y, 6.0);
  jump.tick();
  EXPECT_NEAR(ball().x, start, 0.1);

  const Trace trace = run(level, inputs);
  ASSERT_EQ(trace.crossings.size(), inputs.size());
  for (std::size_t k = 0; k < inputs.size(); ++k) EXPECT_EQ(trace.crossings[k], Crossings{0}) << "in tick " << k + 1;
}

}  // namespace
}  // namespace study
