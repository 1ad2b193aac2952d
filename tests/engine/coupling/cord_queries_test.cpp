#include "ribbon/box2d/cord_queries.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "ribbon/layout.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/support/allocations.h"
#include "tests/support/dice.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using ribbon::box2d::CordId;
using ribbon::box2d::CordPoint;
using ribbon::box2d::CordQueries;
using ribbon::box2d::Coupling;
using ribbon::box2d::QueryFilter;
using ribbon::box2d::RayHit;
using test_support::Dice;

/// A rope of ten links from (0, y) to (1, y).
CordDef level_rope(double y, double radius = 0.05) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.radius = radius;
  def.positions = test_support::equally_spaced(def.points, {0.0, y}, {0.1, 0.0});
  return def;
}

TEST(CordQueries, ARayMeetsTheSurfaceOfTheFirstRope) {
  Coupling coupling;
  coupling.add(Cord(level_rope(0.0)));
  coupling.add(Cord(level_rope(1.0)));
  CordQueries queries;
  queries.update(coupling);
  const auto hit = queries.ray_cast({0.33, 3.0}, {0.33, -1.0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->cord, 1);
  EXPECT_EQ(hit->point, 3);
  EXPECT_NEAR(hit->along, 0.3, 1e-12);
  EXPECT_NEAR(hit->position.y, 1.05, 1e-12);
  EXPECT_NEAR(hit->fraction, 1.95 / 4.0, 1e-12);
  EXPECT_NEAR(hit->normal.y, 1.0, 1e-12);
  const auto end = queries.ray_cast({-1.0, 0.03}, {0.5, 0.03});  // the round end
  ASSERT_TRUE(end);
  EXPECT_EQ(end->cord, 0);
  EXPECT_NEAR(end->position.x, -0.04, 1e-12);
  EXPECT_NEAR(end->normal.x, -0.8, 1e-12);
  EXPECT_FALSE(queries.ray_cast({0.5, 0.5}, {0.5, 0.94}));
  EXPECT_FALSE(queries.ray_cast({2.0, 2.0}, {3.0, -2.0}));
}

TEST(CordQueries, ARayThatBeginsInACordMeetsItThere) {
  Coupling coupling;
  coupling.add(Cord(level_rope(0.0)));
  CordQueries queries;
  queries.update(coupling);
  for (const Vec2 to : {Vec2{0.5, 3.0}, Vec2{0.5, 0.02}}) {
    const auto hit = queries.ray_cast({0.5, 0.02}, to);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->fraction, 0.0);
    EXPECT_EQ(length(hit->normal), 1.0);
  }
  EXPECT_FALSE(queries.ray_cast({0.5, 0.2}, {0.5, 0.2}));
}

TEST(CordQueries, ARayMeetsTheOutlineOfARibbon) {
  Coupling coupling;
  CordDef def;
  def.points = 11;
  def.rows = 3;
  def.length = 2.0;
  def.width = 1.0;
  def.radius = 0.0;
  def.stretch_stiffness = 1e3;
  def.bending_stiffness = 1.0;
  coupling.add(Cord(def));  // 0 … 2 by 0 … 1
  CordQueries queries;
  queries.update(coupling);
  const auto above = queries.ray_cast({0.5, 4.0}, {0.5, -4.0});
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->position.y, 1.0, 1e-12);
  EXPECT_NEAR(above->normal.y, 1.0, 1e-12);
  EXPECT_EQ(above->point % 3, 2) << "the upper row";
  EXPECT_EQ(above->point / 3, 2);
  EXPECT_NEAR(above->along, 0.5, 1e-12);
  const auto end = queries.ray_cast({5.0, 0.7}, {1.0, 0.7});
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->position.x, 2.0, 1e-12);
}

TEST(CordQueries, FindsOnlyWhatTheFilterAccepts) {
  Coupling coupling;
  b2Filter second;
  second.categoryBits = 0x0004;
  coupling.add(Cord(level_rope(0.0)));
  coupling.add(Cord(level_rope(1.0)), second);
  CordQueries queries;
  queries.update(coupling);
  const auto first_hit = [&](const QueryFilter& filter) {
    const auto hit = queries.ray_cast({0.5, 3.0}, {0.5, -3.0}, filter);
    return hit ? hit->cord : -1;
  };
  EXPECT_EQ(first_hit({}), 1);
  EXPECT_EQ(first_hit({.mask = 0x0001}), 0);
  EXPECT_EQ(first_hit({.mask = 0x0004}), 1);
  EXPECT_EQ(first_hit({.mask = 0x0008}), -1);
  const std::array<CordId, 1> except{1};
  EXPECT_EQ(first_hit({.except = except}), 0);
  coupling.cord(1).set_enabled(false);
  queries.update(coupling);
  EXPECT_EQ(first_hit({}), 0);
}

TEST(CordQueries, FindsWhatAShapeOverlaps) {
  Coupling coupling;
  for (const double y : {0.0, 1.0, 2.0}) coupling.add(Cord(level_rope(y)));
  CordQueries queries;
  queries.update(coupling);
  std::vector<CordPoint> found;
  b2CircleShape circle;
  circle.m_radius = 0.5F;
  queries.find_overlaps(circle, b2Transform({0.5F, 0.5F}, b2Rot(0.0F)), found);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].cord, 0);
  EXPECT_EQ(found[1].cord, 1);
  circle.m_radius = 0.44F;
  queries.find_overlaps(circle, b2Transform({0.5F, 0.5F}, b2Rot(0.0F)), found);
  EXPECT_TRUE(found.empty()) << "the ropes are 5 cm thick on each side";
  b2PolygonShape box;
  box.SetAsBox(2.0F, 0.1F);
  queries.find_overlaps(box, b2Transform({0.5F, 1.0F}, b2Rot(1.57079F)), found);  // upright
  EXPECT_EQ(found.size(), 3U);
  b2EdgeShape edge;
  edge.SetTwoSided({-1.0F, 0.0F}, {1.0F, 0.0F});
  queries.find_overlaps(edge, b2Transform({0.5F, 1.02F}, b2Rot(0.0F)), found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].cord, 1);
}

TEST(CordQueries, FindCordsOfTheThesissSolver) {
  Coupling coupling;
  const CordId cord = coupling.add(ribbon::ThesisCord({}));
  CordQueries queries;
  queries.update(coupling);
  const auto x = coupling.cord(cord).positions();
  const Vec2 middle = 0.5 * (x[0] + x[x.size() - 1]);
  const auto hit = queries.ray_cast(middle + Vec2{0.0, 50.0}, middle - Vec2{0.0, 50.0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->cord, cord);
  EXPECT_LE(std::abs(hit->position.x - middle.x), 1e-9);
}

TEST(CordQueries, RefuseInvalidNumbers) {
  const CordQueries queries;
  EXPECT_THROW((void)queries.ray_cast({0.0, std::nan("")}, {}), ribbon::DefinitionError);
  EXPECT_THROW((void)queries.ray_cast({}, {1e10, 0.0}), ribbon::DefinitionError);
  EXPECT_THROW((void)queries.nearest_place({}, -1.0), ribbon::DefinitionError);
  EXPECT_FALSE(queries.ray_cast({}, {1.0, 0.0})) << "there are no cords";
}

/// Ropes that move among cuts and removals; queries are compared with those of a new object and of a walk over all
/// links.
TEST(CordQueries, AgreeWithAWalkOverAllLinks) {
  Dice dice(3);
  GripWorld scene;
  for (int k = 0; k < 12; ++k) {
    CordDef def = level_rope(0.0, dice(0.0, 0.05));
    const Vec2 from{dice(-3.0, 3.0), dice(0.0, 4.0)};
    ribbon::lay_along(def, {from, from + Vec2{dice(0.2, 3.0), dice(-2.0, 2.0)}});
    if (k % 2 == 0) def.pins = {0};
    scene.coupling.add(Cord(def));
  }
  CordQueries kept;
  int hits = 0;
  for (int tick = 0; tick < 40; ++tick) {
    scene.tick();
    if (tick % 7 == 3) scene.coupling.cut({dice(-3.0, 3.0), -5.0}, {dice(-3.0, 3.0), 5.0});
    if (tick % 11 == 5) scene.coupling.remove(scene.coupling.cords().front());
    kept.update(scene.coupling);
    CordQueries fresh;
    fresh.update(scene.coupling);
    for (int k = 0; k < 50; ++k) {
      const Vec2 from{dice(-5.0, 5.0), dice(-5.0, 6.0)};
      const Vec2 to{dice(-5.0, 5.0), dice(-5.0, 6.0)};
      const auto hit = kept.ray_cast(from, to);
      const auto again = fresh.ray_cast(from, to);
      ASSERT_EQ(hit.has_value(), again.has_value());
      // The ray in small steps, up to the first that is within a cord.
      double first = 2.0;
      double nearest = 1e9;
      for (const CordId id : scene.coupling.cords()) {
        const auto x = scene.coupling.cord(id).positions();
        const double radius = scene.coupling.cord(id).direct().def().radius;
        for (std::size_t p = 0; p + 1 < x.size(); ++p) {
          const auto apart = [&](Vec2 at) {
            const Vec2 link = x[p + 1] - x[p];
            const double share = std::clamp(dot(at - x[p], link) / dot(link, link), 0.0, 1.0);
            return length(at - (x[p] + share * link));
          };
          nearest = std::min(nearest, apart(from));
          for (int s = 0; s <= 2000 && radius > 0.01; ++s) {
            const double t = s / 2000.0;
            if (apart(from + t * (to - from)) > radius) continue;
            first = std::min(first, t);
            break;
          }
        }
      }
      if (hit) {
        ++hits;
        EXPECT_EQ(hit->cord, again->cord);
        EXPECT_EQ(hit->fraction, again->fraction);
        EXPECT_LE(hit->fraction, first + 1e-12);
        const auto place = scene.coupling.cord(hit->cord).position(hit->point, hit->along);
        const double radius = scene.coupling.cord(hit->cord).direct().def().radius;
        EXPECT_LE(length(place - hit->position), radius + 1e-9);
        if (hit->fraction == 0.0) continue;  // it begins in the cord
        EXPECT_NEAR(length(place - hit->position), radius, 1e-9);
      } else {
        EXPECT_EQ(first, 2.0);
      }
      const auto place = kept.nearest_place(from, 20.0);
      ASSERT_TRUE(place);
      EXPECT_NEAR(place->distance, nearest, 1e-12);
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(CordQueries, AllocateNothingInASteadyTick) {
  GripWorld scene;
  for (int k = 0; k < 20; ++k) scene.coupling.add(Cord(hanging(0.3 * k)));
  CordQueries queries;
  std::vector<CordPoint> found;
  found.reserve(20);
  b2CircleShape circle;
  circle.m_radius = 1.0F;
  for (int k = 0; k < 3; ++k) {
    scene.tick();
    queries.update(scene.coupling);
  }
  const test_support::AllocationCount allocations;
  for (int k = 0; k < 10; ++k) {
    scene.tick();
    queries.update(scene.coupling);
    EXPECT_TRUE(queries.ray_cast({-1.0, -3.0}, {20.0, -3.0}));
    EXPECT_TRUE(queries.nearest_place({-1.0, -3.0}, 5.0));
    queries.find_overlaps(circle, b2Transform({1.0F, -3.0F}, b2Rot(0.0F)), found);
    EXPECT_FALSE(found.empty());
  }
  EXPECT_EQ(allocations.so_far(), 0);
}

}  // namespace
}  // namespace engine
