#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "ribbon/cord.h"
#include "tests/support/contact_world.h"

// Bodies that something else has pushed since the last step (RigidBody::pushed): a cord between where the solver
// expected them and where they are is taken along.

namespace ribbon {
namespace {

using test_support::ContactWorld;

constexpr double cord_radius = 0.02;  // m
constexpr double corner = 0.005;      // m, radius of what meets the cord

/// A cord that lies straight along x, without gravity.
CordDef straight() {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.radius = cord_radius;
  def.mass_per_length = 0.2;
  for (int i = 0; i < def.points; ++i) def.positions.push_back({0.1 * i, 0.0});
  return def;
}

/// Returns the height of the cord at x, m.
double height_at(std::span<const Vec2> cord, double x) {
  for (std::size_t k = 1; k < cord.size(); ++k) {
    const Vec2 a = cord[k - 1];
    const Vec2 b = cord[k];
    if (a.x <= x && x < b.x) return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
  }
  return std::nan("");
}

/// A cord, and a body that was expected above it and is below it.
struct Pushed : ContactWorld {
  Pushed() : ContactWorld(straight()) {
    gravity = {};
    ball = add_ball({1.03, -0.03}, corner, 10.0, 0.3);
    body(ball).velocity = {0.0, -0.5};
  }
  int ball;
};

TEST(PushedBody, TakesTheCordAlong) {
  for (const bool is_told : {true, false}) {
    Pushed world;
    if (is_told) world.body(world.ball).pushed = {0.0, -0.06};
    const Vec2 momentum = world.momentum();
    world.step();
    const Vec2 end = world.body(world.ball).position;
    EXPECT_EQ(height_at(world.cord.positions(), end.x) < end.y, is_told);
    EXPECT_NEAR(end.y, -0.03 - 0.5 / 60.0, 2e-3);
    EXPECT_NEAR(length(world.momentum() - momentum), 0.0, 1e-9);
    EXPECT_EQ(length(world.body(world.ball).impulse) > 0.005, is_told);
  }
}

TEST(PushedBody, OfACornerThatWasTurnedTakesTheCordAlong) {
  for (const bool is_told : {true, false}) {
    ContactWorld world(straight());
    world.gravity = {};
    // An arm of 0.5 m that was level and 3 cm above the cord, and has been turned by 0.12 rad: its end is 3 cm below.
    const int body = world.add_body({0.55, 0.03}, 10.0, 1.0);
    const double turn = -0.12;
    world.add_circle(body, {0.5 * std::cos(turn), 0.5 * std::sin(turn)}, corner, 0.3);
    if (is_told) world.body(body).pushed_turn = turn;
    world.step();
    const Vec2 end = world.body(body).position + world.circles[0].offset;
    EXPECT_EQ(height_at(world.cord.positions(), end.x) < end.y, is_told);
  }
}

/// A push moves the cord by 3.6 m/s in the step, and gives it none of that.
TEST(PushedBody, LeavesTheCordWithTheVelocityOfTheBody) {
  for (const double restitution : {0.0, 1.0}) {
    Pushed world;
    world.body(world.ball).velocity = {};
    world.circles[0].restitution = restitution;
    world.body(world.ball).pushed = {0.0, -0.06};
    world.step();
    EXPECT_LT(height_at(world.cord.positions(), 1.03), -0.03);
    EXPECT_LT(world.fastest(), 0.05);
    EXPECT_LT(length(world.body(world.ball).velocity), 0.05);
  }
}

/// The cord gets the velocity of the ball, which loses to it no more than in an impact without a push.
TEST(PushedBody, GetsBackWhatThePushHasLost) {
  for (const double mass : {0.05, 1.0}) {
    ContactWorld world(straight());
    world.gravity = {};
    const int ball = world.add_ball({1.03, -0.03}, corner, mass, 0.3);
    world.body(ball).velocity = {0.0, -2.0};
    world.body(ball).pushed = {0.0, -0.06};
    const Vec2 momentum = world.momentum();
    world.step();
    EXPECT_LT(world.body(ball).velocity.y, -1.0) << mass;
    EXPECT_LT(world.fastest(), 2.1) << mass;
    EXPECT_NEAR(length(world.momentum() - momentum), 0.0, 1e-9) << mass;
  }
}

/// A cord is between the body and what stands still.
TEST(PushedBody, IsNotThrownBack) {
  Pushed world;
  world.add_edge(world.add_body({1.0, -0.05}, 0.0, 0.0), {-2.0, 0.0}, {2.0, 0.0}, 0.01, 0.3);
  RigidBody& ball = world.body(world.ball);
  ball.position.y = 0.0;
  ball.velocity = {};
  ball.pushed = {0.0, -0.06};
  world.step();
  EXPECT_GT(world.body(world.ball).position.y, -0.02);
  EXPECT_LT(world.body(world.ball).velocity.y, 0.05);
}

/// A ball was pushed up and turned by what it rolls on. A place of contact that does not go along with it is deep in
/// the ball at the start of the step, and throws it up.
TEST(PushedBody, GoesAlongWithItsSupport) {
  ContactWorld world(straight());
  world.gravity = {};
  const int ball = world.add_ball({1.03, -0.095}, 0.08, 10.0, 0.3);
  world.body(ball).pushed = {0.0, 0.08};
  world.body(ball).pushed_turn = 0.2;
  for (const double x : {-0.06, 0.06}) world.supports.push_back({ball, {x, -0.05}, {0.0, 1.0}});
  world.step();
  EXPECT_LT(length(world.body(ball).velocity), 0.05);
  EXPECT_LT(length(world.body(ball).moved), 1e-3);
  EXPECT_LT(world.fastest(), 0.5);
}

/// A cord with a load of 1,000 kg falls on the ball, which rests on the ground since it was pushed up.
TEST(PushedBody, IsNotPressedThroughItsSupport) {
  ContactWorld world(straight());
  world.cord.attach_mass(10, 1000.0);
  Cord::State state = world.cord.save();
  state.velocities.assign(state.velocities.size(), {0.0, -3.0});
  world.cord.restore(state);
  const int ball = world.add_ball({1.0, -0.1}, 0.08, 10.0, 0.3);
  world.body(ball).pushed = {0.0, 0.08};
  world.supports.push_back({ball, {0.0, -0.08}, {0.0, 1.0}});
  world.step();
  EXPECT_GT(world.body(ball).moved.y, -5e-3);
}

/// The same of a body that was turned: the arm stands still, and so does the cord.
TEST(PushedBody, ThatWasTurnedStandsStill) {
  ContactWorld world(straight());
  world.gravity = {};
  const int body = world.add_body({0.55, 0.03}, 10.0, 1.0);
  const double turn = -0.12;
  world.add_circle(body, {0.5 * std::cos(turn), 0.5 * std::sin(turn)}, corner, 0.3);
  world.body(body).pushed_turn = turn;
  world.step();
  EXPECT_LT(world.fastest(), 0.05);
  EXPECT_LT(std::abs(world.body(body).angular_velocity), 0.05);
}

/// What touches nothing goes on from where it is, with the velocity that it has.
TEST(PushedBody, MovesOnWhereNothingIsInItsWay) {
  Pushed world;
  RigidBody& ball = world.body(world.ball);
  ball.pushed = {0.0, 0.01};  // from further below
  world.step();
  EXPECT_NEAR(ball.position.y, -0.03 - 0.5 / 60.0, 1e-12);
  EXPECT_NEAR(ball.velocity.y, -0.5, 1e-12);
  const auto cord = world.cord.positions();
  EXPECT_TRUE(std::all_of(cord.begin(), cord.end(), [](Vec2 x) { return std::abs(x.y) < 1e-9; }));
}

}  // namespace
}  // namespace ribbon
