#include <gtest/gtest.h>

#include <random>
#include <span>
#include <string>
#include <vector>

#include "engine/replay/flight_recorder.h"
#include "tests/bits/bit_scenes.h"
#include "tests/flight/code.h"
#include "tests/flight/figures.h"
#include "tests/flight/replay.h"
#include "tests/flight/shrink.h"

namespace flight {
namespace {

/// Stores the last step and its result.
class LastStep : public ribbon::box2d::StepWatcher {
 public:
  void before(const ribbon::box2d::SolverInput& input) noexcept override { engine::capture(input, step); }
  void after(const ribbon::box2d::SolverInput& input, std::span<const ribbon::IslandReport> reports,
             const ribbon::IslandReport& total) noexcept override {
    step.outcome = {"a test", total.work, total.unconverged, engine::hash_of_positions(input.cords)};
    by_island.assign(reports.begin(), reports.end());
  }

  engine::SolverStep step;
  std::vector<ribbon::IslandReport> by_island;
};

class FlightOf : public testing::TestWithParam<bits::BitScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, FlightOf, testing::ValuesIn(bits::bit_scenes().begin(), bits::bit_scenes().end()),
                         [](const auto& scene) { return std::string(scene.param.name); });

/// Captures, writes, reads and replays every third tick.
TEST_P(FlightOf, GivesTheBitsOfTheCouplingsOwnStep) {
  bits::BitWorld world;
  GetParam().build(world);
  LastStep last;
  world.coupling.watch(&last);
  for (int k = 0; k < GetParam().ticks; ++k) {
    bits::tick(GetParam(), world, k);
    if (k % 3 != 0) continue;
    const std::string text = engine::to_text(last.step);
    const engine::SolverStep read = engine::read_solver_step(text, "a text");
    ASSERT_EQ(engine::to_text(read), text);
    Replay replay(read);
    for (int times = 0; times < 2; ++times) {
      replay.reset();
      replay.run();
      ASSERT_EQ(replay.hash(), last.step.outcome.positions) << "tick " << k;
      ASSERT_TRUE(std::ranges::equal(replay.island_reports(), last.by_island)) << "tick " << k;
      ASSERT_TRUE(replay.is_as_recorded());
    }
  }
}

/// A file with a wrong byte is either refused with a message or contains another valid step.
TEST(Flight, AcceptsOrRefusesAFileWithAWrongByte) {
  for (const bits::BitScene& scene : bits::bit_scenes()) {
    bits::BitWorld world;
    scene.build(world);
    LastStep last;
    world.coupling.watch(&last);
    for (int k = 0; k < scene.ticks / 2; ++k) bits::tick(scene, world, k);
    const std::string text = engine::to_text(last.step);
    std::minstd_rand dice(7);
    int refused = 0;
    for (int times = 0; times < 300; ++times) {
      std::string spoilt = text;
      spoilt[dice() % spoilt.size()] = "0123456789-.eE,:[]{}\"tfn "[dice() % 26];
      try {
        const engine::SolverStep step = engine::read_solver_step(spoilt, "a text");
        Replay replay(step);
        replay.run();
      } catch (const engine::SolverStepError& error) {
        ASSERT_EQ(std::string(error.what()).find("a text"), 0U);
        ++refused;
      }
    }
    EXPECT_GT(refused, 10) << scene.name;
  }
}

/// Returns a rope over pegs with a load in a grip, and a distant second rope.
engine::SolverStep swinging_step() {
  engine::SolverStep step;
  step.dt = 1.0 / 60.0;
  step.gravity = {0.0, -9.81};
  for (int k = 0; k < 4; ++k) {
    ribbon::RigidBody body;
    body.position = {0.6 + 0.8 * k, -0.1};
    if (k == 3) body.inverse_mass = 0.1, body.acceleration = step.gravity;
    step.bodies.push_back(body);
  }
  for (int k = 0; k < 2; ++k) {
    ribbon::CordDef def;
    def.points = 31;
    def.length = 3.0;
    def.friction = 0.4;
    def.drag = 0.1;
    for (int i = 0; i < def.points; ++i) def.positions.push_back({0.1 * i, 10.0 * k});
    def.pins = {0};
    engine::SolverStep::Cord cord;
    cord.def = def;
    cord.state = ribbon::Cord(def).save();
    cord.id = 1000U + static_cast<unsigned>(k);
    step.cords.push_back(cord);
  }
  for (int k = 0; k < 3; ++k) {
    step.cords[0].circles.push_back({k, {}, 0.095, 0.3, 0.0, 1U + static_cast<unsigned>(k)});
  }
  step.cords[0].grips.push_back({30, 3, {0.0, 0.1}});
  return step;
}

TEST(Shrink, KeepsTheFailureAndLittleElse) {
  const engine::SolverStep step = swinging_step();
  Replay whole(step);
  whole.run();
  const std::int64_t most = whole.total().work / 4;
  const auto fails = [most](const engine::SolverStep& candidate) {
    Replay replay(candidate);
    replay.run();
    return replay.total().work > most;
  };
  int shown = 0;
  const engine::SolverStep smallest = shrink(step, fails, [&shown](const engine::SolverStep&, int) { ++shown; });
  EXPECT_TRUE(fails(smallest));
  EXPECT_LT(size_of(smallest), size_of(step) / 2);
  EXPECT_GT(shown, 0);
  EXPECT_NO_THROW(engine::check(smallest));
  Replay again(smallest);
  again.run();
  EXPECT_TRUE(again.is_as_recorded());
}

TEST(Figures, MeasureStretchAndPenetrationOfARope) {
  engine::SolverStep step = swinging_step();
  step.cords.pop_back();
  for (std::size_t p = 0; p < 31; ++p) step.cords[0].state.positions[p].x *= 1.25;
  step.cords[0].state.velocities[4] = {3.0, 4.0};
  step.bodies[0].position.y = -0.1;
  const Replay replay(step);
  const Figures figures = figures_of(step, replay.cords(), replay.bodies(), false);
  EXPECT_TRUE(figures.finite);
  EXPECT_NEAR(figures.stretch, 0.25, 1e-12);
  EXPECT_EQ(figures.stretched_cord, 0);
  EXPECT_NEAR(figures.penetration, 0.095 + 0.01 - 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(figures.speed, 5.0);
  EXPECT_NEAR(figures.grip_gap, 0.75, 1e-12);
  EXPECT_NEAR(figures.energy, 0.5 * 0.01 * 25.0 - 10.0 * 9.81 * 0.1, 1e-9);
}

TEST(Code, NamesFieldsThatDifferFromTheirDefaults) {
  const std::string code = code_of(swinging_step(), 77);
  EXPECT_NE(code.find("step.cords[0].def.points = 31;"), std::string::npos);
  EXPECT_NE(code.find("step.cords[1].id = 1001U;"), std::string::npos);
  EXPECT_NE(code.find("EXPECT_LE(replay.total().work, 77);"), std::string::npos);
  EXPECT_EQ(code.find("restitution"), std::string::npos);
}

}  // namespace
}  // namespace flight
