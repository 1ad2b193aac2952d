#include "tests/study/tunnelling.h"

#include <gtest/gtest.h>

#include "tests/support/coupled_world.h"
#include "tests/support/points.h"

namespace study {
namespace {

using ribbon::Vec2;

/// A rope of 2 m along x at height 0, 2 cm thick, without gravity.
ribbon::CordDef weightless_rope(double y = 0.0) {
  ribbon::CordDef def;
  def.points = 5;
  def.length = 2.0;
  def.positions = test_support::equally_spaced(def.points, {0.0, y}, {0.5, 0.0});
  return def;
}

TEST(Tunnelling, FindsALinkThatCrossesAPoint) {
  const LinkAndPoint before{{0.0, 0.0}, {1.0, 0.0}, {0.5, 1.0}};
  EXPECT_TRUE(crosses(before, {{0.0, 0.0}, {1.0, 0.0}, {0.5, -1.0}}));   // the point moves
  EXPECT_TRUE(crosses(before, {{0.0, 2.0}, {1.0, 2.0}, {0.5, 1.0}}));    // the link does
  EXPECT_TRUE(crosses(before, {{0.0, 3.0}, {1.0, 1.5}, {0.5, 1.0}}));    // the link also rotates
  EXPECT_FALSE(crosses(before, {{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.5}}));   // it stays above
  EXPECT_FALSE(crosses(before, {{0.0, 0.0}, {1.0, 0.0}, {3.5, -1.0}}));  // it passes beyond the end
  EXPECT_FALSE(crosses(before, before));
}

TEST(Tunnelling, FindsACircleOnTheOtherSideAfterATick) {
  test_support::CoupledWorld world({}, {});
  world.add(weightless_rope());
  b2Body& ball = world.add_circle(b2_dynamicBody, {0.75, 0.3}, 0.1, 1.0, 0.0);
  TunnellingDetector watch;
  const auto detect = [&] { return watch.detect(world.world, world.coupling, {})[0]; };
  EXPECT_EQ(detect(), 0);
  ball.SetTransform({0.75F, 0.09F}, 0.0F);  // only penetrates
  EXPECT_EQ(detect(), 0);
  ball.SetTransform({0.75F, -0.3F}, 0.0F);
  EXPECT_EQ(detect(), through_body);
  EXPECT_EQ(detect(), 0);
  watch.reset();
  ball.SetTransform({0.75F, 0.3F}, 0.0F);
  EXPECT_EQ(detect(), 0);                    // a new start
  ball.SetTransform({0.75F, 0.005F}, 0.0F);  // nearer to the line than the cord's radius
  EXPECT_EQ(detect(), through_body);
  b2Filter none;
  none.maskBits = 0;
  EXPECT_EQ(TunnellingDetector().detect(world.world, world.coupling, none)[0], 0);
}

TEST(Tunnelling, FindsACordThatCrossesAnEdge) {
  for (const double lowest : {-1.0, 0.005}) {
    test_support::CoupledWorld world({}, {});
    world.add(weightless_rope());
    world.add_edges({{0.75, 1.0}, {0.75, lowest}}, 0.0);
    EXPECT_EQ(TunnellingDetector().detect(world.world, world.coupling, {})[0], lowest < 0.0 ? through_body : 0);
  }
}

TEST(Tunnelling, FindsACordWhoseWholeThicknessIsInAPolygon) {
  for (const double depth : {0.005, 0.015}) {  // m, of the middle line; the radius is 0.01
    test_support::CoupledWorld world({}, {});
    world.add(weightless_rope());
    b2PolygonShape shape;
    shape.SetAsBox(0.1F, 0.1F, {0.75F, static_cast<float>(depth - 0.1)}, 0.0F);
    const b2BodyDef def;
    world.world.CreateBody(&def)->CreateFixture(&shape, 0.0F);
    EXPECT_EQ(TunnellingDetector().detect(world.world, world.coupling, {})[0], depth > 0.01 ? through_body : 0);
  }
}

TEST(Tunnelling, ExcludesLinksAtPins) {
  for (const bool is_pinned : {false, true}) {
    test_support::CoupledWorld world({}, {});
    ribbon::CordDef def = weightless_rope();
    if (is_pinned) def.pins = {0};
    world.add(def);
    world.add_edges({{0.25, 1.0}, {0.25, -1.0}}, 0.0);
    EXPECT_EQ(TunnellingDetector().detect(world.world, world.coupling, {})[0], is_pinned ? 0 : through_body);
  }
}

TEST(Tunnelling, ExcludesTheBodyThatHoldsTheCord) {
  for (const bool is_held : {false, true}) {
    test_support::CoupledWorld world({}, {});
    world.add(weightless_rope());
    b2Body& ball = world.add_circle(b2_dynamicBody, {2.0, 0.0}, 0.7, 1.0, 0.0);
    if (is_held) world.hold(0, 4, ball);
    EXPECT_EQ(TunnellingDetector().detect(world.world, world.coupling, {})[0], is_held ? 0 : through_body);
  }
}

/// Why the detector excludes it: a rope that a ball holds at its rim hangs through the ball.
TEST(Tunnelling, ACordDoesNotCollideWithTheBodyThatHoldsIt) {
  test_support::CoupledWorld world({});
  ribbon::CordDef def = weightless_rope(0.5);
  def.points = 21;
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.5}, {0.1, 0.0});
  def.damping = 0.1;
  def.drag = 2.0;
  world.add(def);
  b2Body& ball = world.add_circle(b2_staticBody, {0.0, 0.0}, 0.5, 1.0, 0.0);
  world.hold(0, 0, ball);
  for (int k = 0; k < 600; ++k) world.tick();
  EXPECT_LT(length(world.coupling.cord(0).positions()[5]), 0.25);  // deep in it
}

TEST(Tunnelling, FindsOnlyDeclaredContacts) {
  for (const bool declared : {false, true}) {
    test_support::CoupledWorld world({}, {});
    ribbon::CordDef across = weightless_rope();
    across.cord_contact = declared;
    world.add(across);
    ribbon::CordDef loop = weightless_rope();
    loop.positions = {{1.1, -0.5}, {1.1, 0.5}, {1.35, 0.75}, {0.9, 0.3}, {1.4, 0.3}};
    loop.self_contact = loop.cord_contact = declared;
    world.add(loop);
    const Crossings seen = TunnellingDetector().detect(world.world, world.coupling, {});
    EXPECT_EQ(declared_contacts(world.coupling, 1) & ~through_body, declared ? through_itself | through_cord : 0);
    EXPECT_EQ(seen[0], declared ? through_cord : 0);
    EXPECT_EQ(seen[1], declared ? through_cord + through_itself : 0);
  }
}

/// Near a tie, cords do not touch each other, so that crossing there is not tunnelling.
TEST(Tunnelling, ExcludesWhatIsNearATie) {
  for (const std::size_t crossing : {1U, 2U}) {  // the link of the other rope, which begins 0.5 or 1 m from the tie
    test_support::CoupledWorld world({}, {});
    ribbon::CordDef def = weightless_rope();
    def.cord_contact = true;
    def.radius = 0.2;  // a third of the reach of a tie
    world.add(def);
    def.positions = {{0.0, 0.0}, {0.2, -0.3}, {0.2, -0.8}, {0.4, 0.3}, {0.4, 0.8}};
    if (crossing == 1) def.positions = {{0.0, 0.0}, {0.2, -0.3}, {0.4, 0.3}, {0.4, 0.8}, {0.4, 1.3}};
    world.add(def);
    const auto detect = [&] { return TunnellingDetector().detect(world.world, world.coupling, {})[0]; };
    EXPECT_EQ(detect(), through_cord);
    const ribbon::box2d::TieId tie = world.coupling.tie({1, 0, 0, 0});
    EXPECT_EQ(detect(), crossing == 1 ? 0 : through_cord);
    world.coupling.tie(tie).untie();
    EXPECT_EQ(detect(), through_cord);
  }
}

/// Cords of the thesis touch each other, but none of the direct solver.
TEST(Tunnelling, ExcludesCordsOfDifferentSolvers) {
  ribbon::ThesisDef across;
  across.w = 5;
  across.h = 2;
  for (int i = 0; i < across.w; ++i) {
    for (const double x : {0.7, 0.8}) across.positions.push_back({x, 0.5 - 0.3 * i});
  }
  ribbon::ThesisDef along = across;
  for (Vec2& p : along.positions) p = {p.y + 0.8, p.x - 0.75};
  for (const bool both : {false, true}) {
    test_support::CoupledWorld world({}, {});
    world.coupling.add(ribbon::ThesisCord(across));
    ribbon::CordDef rope = weightless_rope();
    rope.cord_contact = true;
    both ? world.coupling.add(ribbon::ThesisCord(along)) : world.add(rope);
    EXPECT_EQ(TunnellingDetector().detect(world.world, world.coupling, {})[0] & through_cord, both ? through_cord : 0);
  }
}

/// Returns the crossings of two cords without any event in 100 ticks.
std::vector<Crossings> nothing() { return std::vector<Crossings>(100, Crossings(2, 0)); }

TEST(Tunnelling, EventsOfTheReferenceAreNotFailures) {
  std::vector<Crossings> run = nothing();
  std::vector<Crossings> reference = nothing();
  const Crossings all(2, through_body | through_itself | through_cord);
  EXPECT_EQ(tunnelling_failure(run, reference, all, 50), "");
  run[30][1] = through_body;
  EXPECT_EQ(tunnelling_failure(run, reference, all, 50), "cord 2 went through a body in tick 31");
  reference[40][0] = through_body;    // another cord
  reference[34][1] = through_itself;  // something else
  EXPECT_NE(tunnelling_failure(run, reference, all, 50), "");
  reference[46][1] = through_body;  // too late
  EXPECT_NE(tunnelling_failure(run, reference, all, 50), "");
  reference[45][1] = through_body;
  EXPECT_EQ(tunnelling_failure(run, reference, all, 50), "");
  run[80][0] = through_cord;
  EXPECT_EQ(tunnelling_failure(run, reference, all, 50), "cord 1 went through another cord in tick 81");
  reference[55][0] = through_cord;  // after tick 50 the order is random
  EXPECT_EQ(tunnelling_failure(run, reference, all, 50), "");
  run[90][1] = through_itself;
  reference[30][1] = through_itself;
  EXPECT_EQ(tunnelling_failure(run, reference, all, 50), "cord 2 went through itself in tick 91");
  EXPECT_EQ(tunnelling_failure(run, reference, {through_itself, through_body | through_cord}, 50), "");
}

}  // namespace
}  // namespace study
