#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tests/extremes/any_scene/figures.h"
#include "tests/extremes/any_scene/oracles.h"
#include "tests/extremes/any_scene/play.h"

// The oracles report exactly the events planted between two ticks.

namespace any_scene {
namespace {

using ribbon::Vec2;

/// Returns a rope of 11 points and 1 m along +x from `start`.
SceneCord rope(Vec2 start) {
  SceneCord cord;
  cord.def.points = 11;
  cord.def.length = 1.0;
  cord.def.radius = 0.02;
  for (int i = 0; i < 11; ++i) cord.def.positions.push_back(start + Vec2{0.1 * i, 0.0});
  return cord;
}

Solid solid(Shape shape, Vec2 position, Vec2 half) {
  Solid made;
  made.shape = shape;
  made.position = position;
  made.half = half;
  return made;
}

Snapshot snapshot(const Scene& scene) {
  Snapshot now;
  for (const SceneCord& cord : scene.cords) now.cords.push_back(outline(cord.def, cord.def.positions));
  for (const Solid& made : scene.solids) {
    now.solids.push_back(pose_of(made));
    now.pressed.push_back(0);
  }
  return now;
}

Snapshot moved(Snapshot now, int cord, Vec2 by) {
  for (Vec2& p : now.cords[static_cast<std::size_t>(cord)].points) p += by;
  return now;
}

std::size_t crossings(const Scene& scene, const Snapshot& before, const Snapshot& after) {
  return Oracles(scene).crossings(before, after).size();
}

class Obstacle : public testing::TestWithParam<Solid> {};

/// A rope starts 0.3 m above the obstacle and moves down: into contact, into it, and through it.
TEST_P(Obstacle, IsCrossedByARopeThatEntersOrPassesIt) {
  Scene scene;
  scene.cords = {rope({-0.5, 0.3})};
  scene.solids = {GetParam()};
  const double top = GetParam().shape == Shape::edge ? 0.0 : 0.2;
  const Snapshot above = snapshot(scene);
  const Snapshot touching = moved(above, 0, {0.0, top + 0.02 - 0.3});
  EXPECT_EQ(crossings(scene, above, above), 0U);
  EXPECT_EQ(crossings(scene, above, touching), 0U);
  const Snapshot under = moved(above, 0, {0.0, -0.6});
  EXPECT_EQ(crossings(scene, above, under), 1U) << "through it in a tick";
  EXPECT_EQ(crossings(scene, under, under), 0U) << "not again";
  EXPECT_EQ(crossings(scene, above, moved(above, 0, {3.0, -0.6})), 0U) << "past it";
  if (GetParam().shape != Shape::edge) {
    EXPECT_EQ(crossings(scene, touching, moved(above, 0, {0.0, -0.25})), 1U) << "deep into it";
    EXPECT_EQ(crossings(scene, touching, moved(above, 0, {0.0, top - 0.03 - 0.3})), 0U) << "a little into it";
  }
  scene.holds = {{0, 0, 0.5, 0, {}}};
  EXPECT_EQ(crossings(scene, above, under), 0U) << "what holds the cord";
}

INSTANTIATE_TEST_SUITE_P(Of, Obstacle,
                         testing::Values(solid(Shape::circle, {0.03, 0.0}, {0.2, 0.2}),
                                         solid(Shape::box, {0.03, 0.0}, {0.3, 0.2}),
                                         solid(Shape::edge, {0.03, 0.0}, {0.4, 0.0})));

/// Its points are collinear but for rounding errors. At four of these angles, these make two links seem to cross.
TEST(AnySceneOracles, FindNothingWhereAStraightRopeTurns) {
  constexpr int points = 23;
  constexpr double link = 0.2662;  // m
  Scene scene;
  scene.cords.resize(1);
  scene.cords[0].def.self_contact = true;
  const auto at_angle = [&scene](int k) {
    const Vec2 along = link * Vec2{std::cos(0.0017 * k), std::sin(0.0017 * k)};
    std::vector<Vec2>& positions = scene.cords[0].def.positions;
    positions.clear();
    for (int i = 0; i < points; ++i) positions.push_back({4.183 + i * along.x, 1.3 + i * along.y});
    return snapshot(scene);
  };
  scene.cords[0].def.points = points;
  scene.cords[0].def.length = (points - 1) * link;
  Snapshot before = at_angle(0);
  const Oracles oracles(scene);
  for (int k = 1; k < 3600; ++k) {
    Snapshot after = at_angle(k);
    EXPECT_TRUE(oracles.crossings(before, after).empty()) << k;
    before = std::move(after);
  }
}

TEST(AnySceneOracles, FindACircleThatIsMovedThroughACord) {
  Scene scene;
  scene.cords = {rope({-0.5, 0.3})};
  scene.solids = {solid(Shape::circle, {0.03, 0.0}, {0.1, 0.1})};
  const Snapshot before = snapshot(scene);
  Snapshot after = before;
  after.solids[0].position = {0.03, 0.7};
  EXPECT_EQ(crossings(scene, before, after), 1U);
}

TEST(AnySceneOracles, FindCordsThatCrossOrPassOnlyIfBothDeclareContact) {
  Scene scene;
  scene.cords = {rope({0.0, 0.0}), rope({0.45, 0.06})};
  const Snapshot apart = snapshot(scene);
  const Snapshot through = moved(apart, 1, {0.0, -0.12});
  Snapshot crossed = apart;
  crossed.cords[1].points[3].y = -0.1;
  EXPECT_EQ(crossings(scene, apart, through), 0U);
  scene.cords[0].def.cord_contact = true;
  EXPECT_EQ(crossings(scene, apart, through), 0U);
  scene.cords[1].def.cord_contact = true;
  EXPECT_EQ(crossings(scene, apart, through), 1U);
  EXPECT_EQ(crossings(scene, apart, crossed), 1U);
  EXPECT_EQ(crossings(scene, crossed, crossed), 0U);
  EXPECT_EQ(crossings(scene, crossed, moved(crossed, 1, {0.05, 0.0})), 0U) << "it slides";
  EXPECT_EQ(crossings(scene, apart, moved(apart, 1, {2.0, -0.12})), 0U) << "past its end";
}

/// Where a tie was untied, two points coincide, and either rope may leave to either side.
TEST(AnySceneOracles, LetCordsPartThatCoincided) {
  Scene scene;
  scene.cords = {rope({0.0, 0.0}), rope({0.5, 0.0})};
  for (SceneCord& cord : scene.cords) cord.def.cord_contact = true;
  for (std::size_t i = 1; i < 11; ++i) scene.cords[1].def.positions[i].y += 0.1 * static_cast<double>(i);
  const Snapshot together = snapshot(scene);
  Snapshot parted = together;
  parted.cords[1].points[0].y -= 0.01;
  EXPECT_EQ(crossings(scene, together, parted), 0U);
  const Snapshot above = moved(together, 1, {0.0, 0.001});
  EXPECT_EQ(crossings(scene, above, parted), 1U) << "it was at a side";
}

TEST(AnySceneOracles, FindACordThatCrossesItselfButNotAtItsNeighbours) {
  Scene scene;
  scene.cords = {rope({0.0, 0.0})};
  scene.cords[0].def.self_contact = true;
  const Snapshot straight = snapshot(scene);
  Snapshot looped = straight;
  looped.cords[0].points = {{0.0, 0.0},  {0.1, 0.0},   {0.2, 0.0},    {0.3, 0.0},    {0.35, 0.08}, {0.3, 0.15},
                            {0.2, 0.12}, {0.15, 0.05}, {0.15, -0.05}, {0.15, -0.15}, {0.15, -0.25}};
  EXPECT_EQ(crossings(scene, straight, looped), 1U);
  scene.cords[0].def.self_contact = false;
  EXPECT_EQ(crossings(scene, straight, looped), 0U);
  scene.cords[0].def.self_contact = true;
  scene.cords[0].def.radius = 0.3;
  EXPECT_EQ(crossings(scene, straight, looped), 0U) << "all of it is its neighbourhood";
}

TEST(AnySceneOracles, MeasurePenetrationInContactDistances) {
  Scene scene;
  scene.cords = {rope({-0.5, 0.25})};
  scene.solids = {solid(Shape::circle, {0.0, 0.0}, {0.2, 0.2})};
  const Oracles oracles(scene);
  const Snapshot above = snapshot(scene);
  EXPECT_EQ(oracles.penetration(above).share, 0.0);
  EXPECT_NEAR(oracles.penetration(moved(above, 0, {0.0, -0.04})).share, 0.5, 1e-12);
  EXPECT_NEAR(oracles.penetration(moved(above, 0, {0.0, -0.05})).share, 1.0, 1e-12);
  EXPECT_NEAR(oracles.overlap(moved(above, 0, {0.0, -0.04})), 0.01, 1e-12);
}

TEST(AnySceneOracles, FindAStretchedLink) {
  Scene scene;
  scene.cords = {rope({0.0, 0.0}), rope({0.0, 1.0})};
  scene.cords[0].def.positions[10].x += 0.01;
  scene.cords[1].def.positions[10].x += 0.02;
  scene.cords[1].def.stretch_stiffness = 1e3;
  const Lengths worst = lengths(World(scene));
  EXPECT_NEAR(worst.stretch, 0.1, 1e-12);
  EXPECT_NEAR(worst.strain, 0.2, 1e-12);
}

TEST(AnySceneOracles, CountInvertedCorners) {
  Scene scene;
  SceneCord strip;
  strip.def.points = 3;
  strip.def.rows = 2;
  strip.def.length = 2.0;
  strip.def.width = 1.0;
  strip.def.stretch_stiffness = 1e3;
  strip.def.area_stiffness = 1.0;
  strip.def.positions = {{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}, {2.0, 1.0}};
  scene.cords = {strip};
  EXPECT_EQ(inverted(World(scene).coupling()), 0);
  scene.cords[0].def.positions[4] = {0.5, 0.0};
  scene.cords[0].def.positions[5] = {0.5, 1.0};
  EXPECT_EQ(inverted(World(scene).coupling()), 4);
}

TEST(AnySceneOracles, FindSpuriousEnergy) {
  const auto balance = [](double lost, double gained) {
    EnergyBalance energies({1.0, 0.0}, 10.0, {0.0, 2.0});
    energies.take({1.0 - lost, 0.5}, {0.0, 1.0});
    return energies.take({1.0 - lost + gained, 0.5}, {0.5, 2.0});
  };
  EXPECT_NEAR(balance(0.0, 0.205).in_tick, 0.01, 1e-9);
  EXPECT_NEAR(balance(0.0, 0.205).since_lowest, 0.01, 1e-9);
  EXPECT_EQ(balance(0.5, 0.0).in_tick, 0.0);
  EXPECT_NEAR(balance(0.5, 0.41).since_lowest, 0.02, 1e-9);
}

TEST(AnySceneOracles, FindNothingWhereABallFallsPastARope) {
  Scene scene;
  scene.ticks = 60;
  scene.cords = {rope({0.0, 0.0})};
  scene.cords[0].def.pins = {0};
  Solid ball = solid(Shape::circle, {1.5, 1.0}, {0.1, 0.1});
  ball.motion = Motion::dynamic;
  scene.solids = {ball};
  const Outcome outcome = play(scene, 10.0);
  ASSERT_EQ(outcome.ticks.size(), 60U);
  EXPECT_EQ(outcome.end, End::completed);
  for (const Sample& tick : outcome.ticks) {
    EXPECT_TRUE(tick.crossings.empty());
    EXPECT_EQ(tick.penetration.share, 0.0);
    EXPECT_LT(tick.stretch, 1e-3);
    EXPECT_LT(tick.rise, 1e-2);
    EXPECT_GT(tick.work, 0);
  }
}

}  // namespace
}  // namespace any_scene
