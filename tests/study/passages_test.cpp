#include "tests/study/passages.h"

#include <gtest/gtest.h>

#include "tests/support/coupled_world.h"
#include "tests/support/points.h"

namespace study {
namespace {

using ribbon::Vec2;

/// A rope of 2 m along x at height 0, 2 cm thick, without gravity.
ribbon::CordDef rope(double y = 0.0) {
  ribbon::CordDef def;
  def.points = 5;
  def.length = 2.0;
  def.positions = test_support::equally_spaced(def.points, {0.0, y}, {0.5, 0.0});
  return def;
}

TEST(Passages, ALinkThatGoesOverAPointPassesIt) {
  const PassingLink before{{0.0, 0.0}, {1.0, 0.0}, {0.5, 1.0}};
  EXPECT_TRUE(passes(before, {{0.0, 0.0}, {1.0, 0.0}, {0.5, -1.0}}));   // the point moves
  EXPECT_TRUE(passes(before, {{0.0, 2.0}, {1.0, 2.0}, {0.5, 1.0}}));    // the link does
  EXPECT_TRUE(passes(before, {{0.0, 3.0}, {1.0, 1.5}, {0.5, 1.0}}));    // the link also rotates
  EXPECT_FALSE(passes(before, {{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.5}}));   // it stays above
  EXPECT_FALSE(passes(before, {{0.0, 0.0}, {1.0, 0.0}, {3.5, -1.0}}));  // it passes beyond the end
  EXPECT_FALSE(passes(before, before));
}

TEST(Passages, ACircleThatIsOnTheOtherSideAfterATickHasPassed) {
  test_support::CoupledWorld world({}, {});
  world.add(rope());
  b2Body& ball = world.add_circle(b2_dynamicBody, {0.75, 0.3}, 0.1, 1.0, 0.0);
  PassageWatch watch;
  const auto look = [&] { return watch.look(world.world, world.coupling, {})[0]; };
  EXPECT_EQ(look(), 0);
  ball.SetTransform({0.75F, 0.09F}, 0.0F);  // only penetrates
  EXPECT_EQ(look(), 0);
  ball.SetTransform({0.75F, -0.3F}, 0.0F);
  EXPECT_EQ(look(), through_body);
  EXPECT_EQ(look(), 0);
  watch.forget();
  ball.SetTransform({0.75F, 0.3F}, 0.0F);
  EXPECT_EQ(look(), 0);                      // a new start
  ball.SetTransform({0.75F, 0.005F}, 0.0F);  // nearer to the line than the cord's radius
  EXPECT_EQ(look(), through_body);
  b2Filter none;
  none.maskBits = 0;
  EXPECT_EQ(PassageWatch().look(world.world, world.coupling, none)[0], 0);
}

TEST(Passages, AnEdgeIsPassedByWhatCrossesIt) {
  for (const double lowest : {-1.0, 0.005}) {
    test_support::CoupledWorld world({}, {});
    world.add(rope());
    world.add_edges({{0.75, 1.0}, {0.75, lowest}}, 0.0);
    EXPECT_EQ(PassageWatch().look(world.world, world.coupling, {})[0], lowest < 0.0 ? through_body : 0);
  }
}

TEST(Passages, APolygonIsPassedByWhatIsInsideWithAllItsThickness) {
  for (const double depth : {0.005, 0.015}) {  // m, of the middle line; the radius is 0.01
    test_support::CoupledWorld world({}, {});
    world.add(rope());
    b2PolygonShape shape;
    shape.SetAsBox(0.1F, 0.1F, {0.75F, static_cast<float>(depth - 0.1)}, 0.0F);
    const b2BodyDef def;
    world.world.CreateBody(&def)->CreateFixture(&shape, 0.0F);
    EXPECT_EQ(PassageWatch().look(world.world, world.coupling, {})[0], depth > 0.01 ? through_body : 0);
  }
}

TEST(Passages, LinksAtPinsMayBeAnywhere) {
  for (const bool is_pinned : {false, true}) {
    test_support::CoupledWorld world({}, {});
    ribbon::CordDef def = rope();
    if (is_pinned) def.pins = {0};
    world.add(def);
    world.add_edges({{0.25, 1.0}, {0.25, -1.0}}, 0.0);
    EXPECT_EQ(PassageWatch().look(world.world, world.coupling, {})[0], is_pinned ? 0 : through_body);
  }
}

TEST(Passages, CordsCrossOnlyWhatTheyDeclare) {
  for (const bool declared : {false, true}) {
    test_support::CoupledWorld world({}, {});
    ribbon::CordDef across = rope();
    across.cord_contact = declared;
    world.add(across);
    ribbon::CordDef loop = rope();
    loop.positions = {{1.1, -0.5}, {1.1, 0.5}, {1.35, 0.75}, {0.9, 0.3}, {1.4, 0.3}};
    loop.self_contact = loop.cord_contact = declared;
    world.add(loop);
    const Passages seen = PassageWatch().look(world.world, world.coupling, {});
    EXPECT_EQ(declared_contacts(world.coupling)[1] & ~through_body, declared ? through_itself | through_cord : 0);
    EXPECT_EQ(seen[0], declared ? through_cord : 0);
    EXPECT_EQ(seen[1], declared ? through_cord + through_itself : 0);
  }
}

/// Returns the passages of two cords without any event in 100 ticks.
std::vector<Passages> nothing() { return std::vector<Passages>(100, Passages(2, 0)); }

TEST(Passages, WhatTheReferenceShowsTooIsNoFailure) {
  std::vector<Passages> run = nothing();
  std::vector<Passages> reference = nothing();
  const Passages all(2, through_body | through_itself | through_cord);
  EXPECT_EQ(let_through(run, reference, all, 50), "");
  run[30][1] = through_body;
  EXPECT_EQ(let_through(run, reference, all, 50), "cord 2 went through a body in tick 31");
  reference[40][0] = through_body;    // another cord
  reference[34][1] = through_itself;  // something else
  EXPECT_NE(let_through(run, reference, all, 50), "");
  reference[46][1] = through_body;  // too late
  EXPECT_NE(let_through(run, reference, all, 50), "");
  reference[45][1] = through_body;
  EXPECT_EQ(let_through(run, reference, all, 50), "");
  run[80][0] = through_cord;
  EXPECT_EQ(let_through(run, reference, all, 50), "cord 1 went through another cord in tick 81");
  reference[55][0] = through_cord;  // after tick 50 the order is random
  EXPECT_EQ(let_through(run, reference, all, 50), "");
  run[90][1] = through_itself;
  reference[30][1] = through_itself;
  EXPECT_EQ(let_through(run, reference, all, 50), "cord 2 went through itself in tick 91");
  EXPECT_EQ(let_through(run, reference, {through_itself, through_body | through_cord}, 50), "");
}

}  // namespace
}  // namespace study
