// Running over bridges, and what a fall out of the level brings back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"
#include "tests/game/simulation/press.h"

namespace game {
namespace {

using ribbon::Vec2;

Vec2 feet(const Simulation& simulation) {
  return simulation.player().position() - Vec2{0.0, 0.5 * simulation.player().tuning().height};
}

/// Returns how far the feet rise above the higher end of a bridge while the player runs over it from one ledge to the
/// other, m.
double rise_over(const Level& level, ribbon::box2d::CordId bridge, int side) {
  Simulation simulation(level);
  const auto points = simulation.scene().coupling().cord(bridge).positions();
  const Vec2 left = points.front();
  const Vec2 right = points.back();
  const double radius = 0.5 * simulation.scene().coupling().cord(bridge).shape().thickness;
  const bool to_right = side == button_right;
  const Vec2 start = (to_right ? left : right) + Vec2{to_right ? -2.5 : 2.5, radius + 0.76};
  simulation.player().body().SetTransform(ribbon::box2d::to_float(start), 0.0F);
  double most = 0.0;
  for (int k = 0; k < 600; ++k) {
    simulation.tick(press(side));
    const Vec2 now = feet(simulation);
    const bool near_left = std::abs(now.x - left.x) < 2.5;
    if (near_left || std::abs(now.x - right.x) < 2.5) {
      most = std::max(most, now.y - (near_left ? left.y : right.y) - radius);
    }
    if (to_right ? now.x > right.x + 2.0 : now.x < left.x - 2.0) return most;
  }
  ADD_FAILURE() << "the player has not run over cord " << bridge;
  return most;
}

TEST(Running, OverTheEndsOfABridgeLeavesThePlayerLow) {
  const Level level = load_level("rolling_bridge");
  for (const ribbon::box2d::CordId bridge : {0, 1}) {
    for (const int side : {button_left, button_right}) {
      EXPECT_LT(rise_over(level, bridge, side), 0.1) << "cord " << bridge << " to " << side;
    }
  }
}

/// A trampoline keeps what it gives.
TEST(Running, LeavesABounceItsSpeed) {
  const Level level = load_level("trampoline");
  Simulation simulation(level);
  const auto cloth = simulation.scene().coupling().cord(0).positions();
  const Vec2 middle = cloth[cloth.size() / 2];
  simulation.player().body().SetTransform(ribbon::box2d::to_float(middle + Vec2{0.0, 4.75}), 0.0F);
  double highest = 0.0;
  bool has_bounced = false;
  for (int k = 0; k < 240; ++k) {
    simulation.tick({});
    has_bounced = has_bounced || feet(simulation).y < middle.y;
    if (has_bounced) highest = std::max(highest, feet(simulation).y - middle.y);
  }
  EXPECT_GT(highest, 2.0);  // of 4 m
}

TEST(Falling, BringsCordsAndBodiesBack) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  const Snapshot start = simulation.current();
  for (int k = 0; k < 200 && !simulation.scene().coupling().body(simulation.player().body()).held_place(); ++k) {
    const bool at_edge = simulation.player().position().x > 7.2;
    simulation.tick(press(button_right | (at_edge ? button_jump | button_grab : 0)));
  }
  for (int k = 0; k < 60; ++k) simulation.tick(press(button_right | button_grab));
  while (simulation.falls() == 0 && simulation.ticks() < 1200) simulation.tick({});
  ASSERT_EQ(simulation.falls(), 1);
  EXPECT_EQ(simulation.current().cords, start.cords);
  const std::size_t player = start.bodies.size() - 1;
  for (std::size_t k = 0; k < player; ++k) {
    EXPECT_EQ(simulation.current().bodies[k].position, start.bodies[k].position) << "body " << k;
  }
  EXPECT_LT(length(feet(simulation) - level.player_start), 1e-6);
  EXPECT_GT(simulation.run_ticks(), 100);  // the clock goes on
}

/// What the pointer drags, a rope and a ball, is where it was at the start too, and free.
TEST(Falling, EndsADrag) {
  const Level level = load_level("first_swing");
  for (const Vec2 from : {Vec2{11.0, 8.0}, Vec2{5.8, 5.81}}) {
    Simulation simulation(level);
    const Snapshot start = simulation.current();
    engine::TickInput input = press(button_right | button_drag);
    engine::set_pointer(input, from);
    simulation.tick(input);
    engine::set_pointer(input, from + Vec2{0.0, 2.0});
    for (int k = 0; k < 30; ++k) simulation.tick(input);
    ASSERT_TRUE(simulation.drag().cord_point() || simulation.drag().body() != nullptr) << from.x;
    ASSERT_NE(simulation.current().cords, start.cords);
    while (simulation.falls() == 0 && simulation.ticks() < 1200) simulation.tick(input);
    ASSERT_EQ(simulation.falls(), 1);
    EXPECT_EQ(simulation.current().cords, start.cords);
    EXPECT_FALSE(simulation.drag().cord_point());
    EXPECT_EQ(simulation.drag().body(), nullptr);
    for (int k = 0; k < 60; ++k) simulation.tick({});
    EXPECT_EQ(simulation.scene().coupling().cord(0).kind(20), ribbon::PointKind::free);
  }
}

/// The cord of a line that was thrown is gone, and another can be thrown.
TEST(Falling, TakesTheLineBack) {
  const Level level = load_level("long_line");
  Simulation simulation(level);
  const auto throw_at_first = [&] {
    simulation.player().body().SetTransform(ribbon::box2d::to_float(level.hooks[0] - Vec2{1.0, 5.0}), 0.0F);
    engine::TickInput input = press(button_throw);
    engine::set_pointer(input, level.hooks[0]);
    simulation.tick(input);
    for (int k = 0; k < 30; ++k) simulation.tick({});
    return simulation.player().line().state() == Line::State::held;
  };
  ASSERT_TRUE(throw_at_first());
  simulation.tick(press(button_jump));
  while (simulation.falls() == 0 && simulation.ticks() < 1200) simulation.tick({});
  ASSERT_EQ(simulation.falls(), 1);
  EXPECT_EQ(simulation.player().line().state(), Line::State::stowed);
  EXPECT_TRUE(simulation.scene().coupling().cords().empty());
  EXPECT_TRUE(throw_at_first());
}

}  // namespace
}  // namespace game
