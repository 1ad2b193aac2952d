// The drawn hands and feet on the cords of all recorded runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "game/view/figure_state.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double on_cord = 0.02;       // m
constexpr double feet_on_cord = 0.03;  // m
constexpr double arm = 0.56;           // m

struct Frame {
  const Simulation& simulation;
  const Snapshot& now;
  FigureState state;
  Pose pose;
};

/// Calls `check` for each tick of a level's recorded run.
void for_each_tick(const std::string& name, const std::function<void(const Frame&)>& check) {
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/" + name + ".replay");
  const Level level = load_level(name);
  Simulation simulation(level);
  for (const engine::RecordedTick& tick : replay.ticks) {
    simulation.tick(tick.input);
    const FigureState state =
        figure_of(simulation, simulation.current(), 1.0 * simulation.run_ticks() / ticks_per_second);
    check({simulation, simulation.current(), state, pose_of(state)});
    if (testing::Test::HasFailure()) return;
  }
}

/// Returns the distance of a point to the cord that the player holds.
double distance_to_cord(const Frame& frame, Vec2 p) {
  const ribbon::box2d::Coupling& coupling = frame.simulation.scene().coupling();
  const auto held = frame.simulation.player().held_place(coupling);
  const std::vector<Vec2>& x = frame.now.cords[static_cast<std::size_t>(held->cord)];
  const auto rows = static_cast<std::size_t>(coupling.cord(held->cord).shape().rows);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = static_cast<std::size_t>(held->point) % rows; k + rows < x.size(); k += rows) {
    const Vec2 link = x[k + rows] - x[k];
    const double s = std::clamp(dot(p - x[k], link) / std::max(dot(link, link), 1e-12), 0.0, 1.0);
    nearest = std::min(nearest, length(x[k] + s * link - p));
  }
  return nearest;
}

/// Returns whether the player hangs and its cord is not being pulled in.
bool hangs(const Frame& frame) {
  if (!frame.state.cord || frame.state.on_ground) return false;
  return length(frame.state.cord->held() - frame.simulation.player().hand()) < 0.03;
}

class HandOnCord : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Recorded, HandOnCord, testing::ValuesIn(level_names()),
                         [](const auto& level) { return level.param; });

TEST_P(HandOnCord, AHandHoldsThePlaceThatThePlayerHolds) {
  for_each_tick(GetParam(), [](const Frame& frame) {
    const ribbon::box2d::Coupling& coupling = frame.simulation.scene().coupling();
    const auto place = frame.simulation.player().held_place(coupling);
    const auto held = place ? std::optional(held_position(coupling, frame.now, *place)) : std::nullopt;
    ASSERT_EQ(held.has_value(), frame.state.cord.has_value());
    if (!held) return;
    const auto& hand = frame.pose.hand;
    EXPECT_LT(std::min(length(hand[0] - *held), length(hand[1] - *held)), on_cord) << frame.simulation.ticks();
    if (frame.state.on_ground || frame.state.cheers || frame.state.throws_at) return;
    for (const Vec2 each : hand) EXPECT_LT(distance_to_cord(frame, each), on_cord) << frame.simulation.ticks();
  });
}

TEST_P(HandOnCord, ArmsAreNotStretchedWhileHanging) {
  int steady = 0;
  for_each_tick(GetParam(), [&steady](const Frame& frame) {
    if (!hangs(frame)) return;
    ++steady;
    for (const std::size_t k : {0U, 1U}) {
      const Pose& pose = frame.pose;
      EXPECT_LE(length(pose.elbow[k] - pose.shoulder[k]) + length(pose.hand[k] - pose.elbow[k]), arm)
          << frame.simulation.ticks();
    }
  });
  if (GetParam() == "first_swing") {
    EXPECT_GT(steady, 50);
  }
}

/// Returns whether the cord below is long enough for the feet, and does not swing away from them.
bool is_within_reach_of_feet(const Frame& frame) {
  const HeldCord& cord = *frame.state.cord;
  if (length(cord.at(-1.3) - cord.at(-1.2)) < 0.05) return false;
  return length(cord.at(-1.1) - frame.pose.hip) < 0.5 && length(cord.at(-1.2) - frame.pose.hip) < 0.5;
}

/// The player slides down a rope of the first level after it has caught it, and climbs it.
TEST(ClimbingFigure, HandsAndFeetAreOnTheCord) {
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/first_swing.replay");
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  std::size_t start = 0;
  while (!simulation.scene().coupling().body(simulation.player().body()).held_place())
    simulation.tick(replay.ticks.at(start++).input);
  int climbing = 0;
  for (int k = 0; k < 300; ++k) {
    engine::TickInput input;
    input.buttons = button_grab;
    if (k > 30) input.buttons |= k < 50 || k % 100 > 80 ? button_down : button_up;
    simulation.tick(input);
    const FigureState state = figure_of(simulation, simulation.current(), k / 60.0);
    const Frame frame{simulation, simulation.current(), state, pose_of(state)};
    ASSERT_TRUE(state.cord) << k;
    if (!hangs(frame)) continue;
    for (const Vec2 hand : frame.pose.hand) EXPECT_LT(distance_to_cord(frame, hand), on_cord) << k;
    const Vec2 up = state.cord->at(0.5) - state.cord->held();
    const double speed = dot(state.velocity, up) / length(up);
    if (!state.climbs || std::abs(speed) < 1.0) continue;
    if (!is_within_reach_of_feet(frame)) continue;
    ++climbing;
    for (const Vec2 foot : frame.pose.foot) EXPECT_LT(distance_to_cord(frame, foot), feet_on_cord) << k;
  }
  EXPECT_GT(climbing, 50);
}

}  // namespace
}  // namespace game
