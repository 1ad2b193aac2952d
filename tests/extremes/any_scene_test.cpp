#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/extremes/any_scene/code.h"
#include "tests/extremes/any_scene/figures.h"
#include "tests/extremes/any_scene/generate.h"
#include "tests/extremes/any_scene/oracles.h"
#include "tests/extremes/any_scene/play.h"
#include "tests/extremes/any_scene/runs.h"
#include "tests/extremes/any_scene/shrink.h"
#include "tests/extremes/any_scene/world.h"

// Generator, shrinker and printer of random scenes. The solver's results do not matter here.

namespace any_scene {
namespace {

class AnyFamily : public testing::TestWithParam<Family> {};

TEST_P(AnyFamily, TheSameSeedGivesTheSameScene) {
  for (const Difficulty difficulty : {Difficulty::gentle, Difficulty::wild}) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      const SceneId which{seed, GetParam(), difficulty, {}};
      EXPECT_EQ(generate(which), generate(which)) << seed;
      const SceneId next{seed + 1, GetParam(), difficulty, {}};
      EXPECT_FALSE(generate(which) == generate(next)) << seed;
    }
  }
}

TEST_P(AnyFamily, NothingOverlapsAtTheStartOfAGentleScene) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Scene scene = generate({seed, GetParam(), Difficulty::gentle, {}});
    ASSERT_FALSE(scene.cords.empty()) << seed;
    EXPECT_TRUE(starts_clear(scene)) << seed;
    EXPECT_TRUE(GetParam() == Family::belts || !is_driven(scene)) << seed;
  }
}

TEST_P(AnyFamily, LinksOfAGentleSceneHaveTheirRestLength) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const World world(generate({seed, GetParam(), Difficulty::gentle, {}}));
    const Lengths worst = lengths(world);
    EXPECT_LT(worst.stretch, 1e-12) << seed;
    for (int c = 0; c < world.coupling().size(); ++c) {
      // The rows of a ribbon on an arc have different lengths.
      if (world.coupling().cord(c).direct().def().rows == 1) continue;
      EXPECT_LT(worst.strain, 0.5) << seed;
    }
    EXPECT_EQ(inverted(world.coupling()), 0) << seed;
    EXPECT_LT(world.grip_gaps().free, 1e-6) << seed;
  }
}

TEST_P(AnyFamily, EveryWildSceneIsAccepted) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Scene scene = generate({seed, GetParam(), Difficulty::wild, {}});
    EXPECT_NO_THROW(World{scene}) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(All, AnyFamily, testing::ValuesIn(all_families),
                         [](const auto& family) { return std::string(name(family.param)); });

/// Cuts across and along keep mass and momentum of the cords, and all pieces move on.
TEST(AnySceneOfCuts, KeepsMassAndMomentumAtCuts) {
  int along = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    Scene scene = generate({seed, Family::cut, Difficulty::gentle, Preset::fast});
    scene.ticks = 100;
    for (const SceneCord& cord : scene.cords) along += cord.def.rows > 2 ? 1 : 0;
    const Outcome outcome = play(scene, 20.0);
    EXPECT_EQ(outcome.end, End::completed) << seed;
    for (const Sample& tick : outcome.ticks) EXPECT_LE(tick.imbalance, 1e-13) << seed;
  }
  EXPECT_GT(along, 3) << "ribbons to cut along";
}

/// Returns a scene in which every field differs from its default.
Scene full_scene() {
  Scene scene;
  scene.gravity = {0.5, -3.0};
  scene.preset = Preset::accurate;
  scene.ticks = 7;
  scene.calm_ticks = 8;
  scene.sleeping = true;
  SceneCord cord;
  cord.velocity = {1.0 / 3.0, 2.0};
  ribbon::CordDef& def = cord.def;
  def.points = 3;
  def.rows = 2;
  def.length = 2.25;
  def.width = 0.7;
  def.radius = 0.033;
  def.mass_per_length = 0.77;
  def.stretch_stiffness = 1234.5;
  def.bending_stiffness = 0.2;
  def.poisson_ratio = 0.3;
  def.cell_stiffness = 0.5;
  def.area_stiffness = 0.9;
  def.damping = 0.01;
  def.drag = 0.7;
  def.drag_across = 1.1;
  def.drag_along = 0.013;
  def.displaced_area = 0.0031;
  def.tension_only = true;
  def.breaking_force = 88.0;
  def.friction = 0.4;
  def.restitution = 0.6;
  def.self_contact = true;
  def.cord_contact = true;
  def.allow_sleep = true;
  def.elements = ribbon::Elements::bars;
  def.positions = {{0.1, 0.0}, {1.0 / 7.0, 1e-9}, {-1e20, 3.0}, {0.0, 1.0}, {1.0, 1.0}, {2.0, 2.0}};
  def.pins = {0, 3};
  scene.cords = {cord, {}};
  scene.solids = {{Motion::kinematic, Shape::box, {1.0, 2.0}, 0.1, {0.3, 0.4}, 3.0, 0.5, 0.7, {1.0, -1.0}, 2.0}};
  scene.holds = {{2, 3, 0.5, 1, {0.1, 0.2}, 44.0, true, 0.75, 3.0}};
  scene.wheels = {{5, 4, {{0.5, 6.0}, 0.25, false, 2, 7, 9, 0.375, 0.35, -3.5, 12.5}}};
  scene.drags = {{1, 4, 6, 2.5, {{1.0, 2.0}, {3.0, 4.0}}}};
  scene.reels = {{4, 3, 5, 6, 0.25, 0.125}};
  scene.cuts = {{19, 0.25, 0.75, true, true}};
  return scene;
}

TEST(AnySceneCode, NamesEveryFieldThatDiffersFromItsDefault) {
  const std::string code = to_code(full_scene(), "some_scene");
  for (const char* part : {
           "any_scene::Scene some_scene() {",
           "scene.gravity = {0.5, -3.0};",
           "scene.preset = any_scene::Preset::accurate;",
           "scene.ticks = 7;",
           "scene.calm_ticks = 8;",
           "scene.sleeping = true;",
           "scene.cords.resize(2);",
           "[0].velocity = {0.3333333333333333, 2.0};",
           ".def.points = 3;",
           ".def.rows = 2;",
           ".def.length = 2.25;",
           ".def.width = 0.7;",
           ".def.radius = 0.033;",
           ".def.mass_per_length = 0.77;",
           ".def.stretch_stiffness = 1234.5;",
           ".def.bending_stiffness = 0.2;",
           ".def.poisson_ratio = 0.3;",
           ".def.cell_stiffness = 0.5;",
           ".def.area_stiffness = 0.9;",
           ".def.damping = 0.01;",
           ".def.drag = 0.7;",
           ".def.drag_across = 1.1;",
           ".def.drag_along = 0.013;",
           ".def.displaced_area = 0.0031;",
           ".def.tension_only = true;",
           ".def.breaking_force = 88.0;",
           ".def.friction = 0.4;",
           ".def.restitution = 0.6;",
           ".def.self_contact = true;",
           ".def.cord_contact = true;",
           ".def.allow_sleep = true;",
           ".def.elements = ribbon::Elements::bars;",
           ".def.positions = {{0.1, 0.0}, {0.14285714285714285, 1e-09}, {-1e+20, 3.0}",
           ".def.pins = {0, 3};",
           "solids[0].motion = any_scene::Motion::kinematic;",
           "solids[0].shape = any_scene::Shape::box;",
           "solids[0].position = {1.0, 2.0};",
           "solids[0].angle = 0.1;",
           "solids[0].half = {0.3, 0.4};",
           "solids[0].density = 3.0;",
           "solids[0].friction = 0.5;",
           "solids[0].restitution = 0.7;",
           "solids[0].velocity = {1.0, -1.0};",
           "solids[0].angular_velocity = 2.0;",
           "holds[0].solid = 2;",
           "holds[0].cord = 3;",
           "holds[0].arc = 0.5;",
           "holds[0].row = 1;",
           "holds[0].local_anchor = {0.1, 0.2};",
           "holds[0].strength = 44.0;",
           "holds[0].lets_go = true;",
           "holds[0].climb_to = 0.75;",
           "holds[0].climb_speed = 3.0;",
           "wheels[0].cord = 5;",
           "wheels[0].solid = 4;",
           "wheels[0].def.center = {0.5, 6.0};",
           "wheels[0].def.radius = 0.25;",
           "wheels[0].def.counterclockwise = false;",
           "wheels[0].def.turns = 2;",
           "wheels[0].def.before = 7;",
           "wheels[0].def.after = 9;",
           "wheels[0].def.inertia = 0.375;",
           "wheels[0].def.friction = 0.35;",
           "wheels[0].def.motor_speed = -3.5;",
           "wheels[0].def.motor_torque = 12.5;",
           "drags[0].cord = 1;",
           "drags[0].point = 4;",
           "drags[0].from_tick = 6;",
           "drags[0].speed = 2.5;",
           "drags[0].path = {{1.0, 2.0}, {3.0, 4.0}};",
           "cuts[0].tick = 19;",
           "cuts[0].cord = 0.25;",
           "cuts[0].place = 0.75;",
           "cuts[0].weakens = true;",
           "cuts[0].along = true;",
           "reels[0].cord = 4;",
           "reels[0].first = 3;",
           "reels[0].last = 5;",
           "reels[0].from_tick = 6;",
           "reels[0].length = 0.25;",
           "reels[0].speed = 0.125;",
           "return scene;",
       }) {
    EXPECT_NE(code.find(part), std::string::npos) << part << "\n" << code;
  }
}

TEST(AnySceneRuns, AreParsedFromTheirLineOfCsv) {
  const SceneId which{3, Family::ribbons_both, Difficulty::wild, Preset::fast};
  Scene scene = generate(which);
  scene.ticks = 20;
  const Summary run = run_guarded(which, scene, 20.0);
  EXPECT_EQ(to_csv(from_csv(to_csv(run))), to_csv(run));
  EXPECT_GT(run.ticks, 0);
  EXPECT_EQ(run.which, which);
  const std::string header = csv_header();
  const std::string line = to_csv(run);
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(line.begin(), line.end(), ','));
}

TEST(AnySceneRuns, SaveResidualsIfTheSolverReportsThem) {
  Summary run = sum_up({}, {}, {});
  run.work = {{0, 2}, {17, 1}};
  const std::string nothing_left = to_csv(run);
  EXPECT_EQ(from_csv(nothing_left).left, (std::map<int, int>{}));
  run.left = std::map<int, int>{{bin_of(1e-3), 3}, {bin_of(2.0), 1}};
  EXPECT_EQ(from_csv(to_csv(run)).left, run.left);
  EXPECT_EQ(from_csv(to_csv(run)).work, run.work);
  const std::string before = nothing_left.substr(0, nothing_left.rfind(','));
  EXPECT_EQ(from_csv(before).left, std::nullopt);
  EXPECT_EQ(from_csv(before).work, run.work);
  EXPECT_EQ(to_csv(from_csv(before)), before);
}

TEST(AnySceneRuns, CountResidualsThatTheSolverReports) {
  Outcome outcome;
  outcome.ticks.resize(4);
  outcome.ticks[1].left = 0.9e-3;
  outcome.ticks[2].left = 1e-3;
  outcome.ticks[3].left = 1.1e-3;
  const Summary run = sum_up({}, {}, outcome);
  EXPECT_EQ(run.left, (std::map<int, int>{{-12, 2}, {-11, 1}}));
  EXPECT_NEAR(end_of_bin(-12), 1e-3, 1e-12);
}

TEST(AnySceneRuns, CountTicksThatHangAndWhatIsLeftLate) {
  Outcome outcome;
  outcome.ticks.resize(6);
  for (const std::size_t k : {0U, 1U, 3U}) outcome.ticks[k].hangs = true;
  outcome.ticks[2].stretch = 0.5;
  outcome.ticks[5].late = true;
  outcome.ticks[5].stretch = 0.25;
  outcome.ticks[5].unconverged = 3;
  outcome.ticks[5].gaps.free = 0.125;
  const Summary run = sum_up({}, {}, outcome);
  EXPECT_EQ(run.hanging, 2);
  EXPECT_EQ(run.late_stretch, 0.25);
  EXPECT_EQ(run.late_unconverged, 3);
  EXPECT_EQ(run.late_gap, 0.125);
  EXPECT_EQ(to_csv(from_csv(to_csv(run))), to_csv(run));
}

/// A kinematic body holds a rope's free end and pulls at its pin; then it is let go.
TEST(AnySceneRuns, EndWithoutDrives) {
  Scene scene;
  scene.ticks = 60;
  scene.calm_ticks = 90;
  SceneCord cord;
  cord.def.points = 11;
  cord.def.length = 1.0;
  cord.def.pins = {0};
  for (int p = 0; p < 11; ++p) cord.def.positions.push_back({0.1 * p, 0.0});
  scene.cords.push_back(cord);
  Solid puller;
  puller.motion = Motion::kinematic;
  puller.position = {1.0, 0.0};
  puller.velocity = {2.0, 0.0};
  scene.solids.push_back(puller);
  Hold hold;
  hold.arc = 1.0;
  scene.holds.push_back(hold);
  const Outcome outcome = play(scene, 20.0);
  ASSERT_EQ(outcome.ticks.size(), 150U);
  EXPECT_GT(outcome.ticks[59].stretch, 1.0);
  EXPECT_FALSE(outcome.ticks[119].late);
  EXPECT_TRUE(outcome.ticks[120].late);
  const Summary run = sum_up({}, scene, outcome);
  EXPECT_LT(run.late_stretch, 1e-2);
  EXPECT_EQ(run.late_unconverged, 0);
}

TEST(AnySceneRuns, AreReproducible) {
  Scene scene = generate({1, Family::mixed, Difficulty::gentle, Preset::fast});
  scene.ticks = 30;
  const Outcome once = play(scene, 20.0);
  const Outcome again = play(scene, 20.0);
  ASSERT_EQ(once.ticks.size(), again.ticks.size());
  for (std::size_t k = 0; k < once.ticks.size(); ++k) {
    EXPECT_EQ(once.ticks[k].energy, again.ticks[k].energy) << k;
    EXPECT_EQ(once.ticks[k].work, again.ticks[k].work) << k;
  }
}

TEST(AnySceneRuns, StopAtTheirTimeLimit) {
  Scene scene = generate({0, Family::mixed, Difficulty::gentle, Preset::accurate});
  scene.ticks = 1'000'000;
  EXPECT_EQ(run_guarded({}, scene, 0.2).end, End::timed_out);
}

TEST(AnySceneRuns, ReportARefusedDefinition) {
  Scene scene = generate({0, Family::rope_falls, Difficulty::gentle, {}});
  scene.cords[0].def.radius = -1.0;
  EXPECT_EQ(run_guarded({}, scene, 1.0).end, End::refused);
}

/// The planted failure is a fast heavy circle among many unrelated objects.
TEST(AnySceneShrink, LeavesOnlyWhatTheFailureNeeds) {
  Scene scene = generate({7, Family::mixed, Difficulty::gentle, {}});
  Solid planted;
  planted.motion = Motion::dynamic;
  planted.position = {3.0, 50.0};
  planted.density = 777.0;
  planted.velocity = {10.123, 20.0};
  scene.solids.push_back(planted);
  const auto fails = [](const Scene& played) {
    return std::any_of(played.solids.begin(), played.solids.end(),
                       [](const Solid& solid) { return solid.velocity.x > 5.0; }) &&
           played.ticks >= 17;
  };
  const Scene small = shrink(scene, fails);
  EXPECT_EQ(small.ticks, 17);
  ASSERT_EQ(small.solids.size(), 1U);
  ASSERT_EQ(small.cords.size(), 1U);
  EXPECT_TRUE(small.holds.empty());
  EXPECT_EQ(small.solids[0].motion, Motion::fixed);
  EXPECT_EQ(small.solids[0].velocity.x, 10.1);
  EXPECT_LE(small.cords[0].def.points, 4);
  EXPECT_TRUE(small.cords[0].def.pins.empty());
  EXPECT_NO_THROW(World{small});
}

/// References to removed cords and solids are removed; all others refer to the same ones as before.
TEST(AnySceneShrink, EveryIntermediateSceneIsValid) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Scene scene = generate({seed, Family::mixed, Difficulty::wild, {}});
    int kept = 0;
    shrink(scene, [&](const Scene& played) {
      EXPECT_NO_THROW(World{played}) << seed;
      return ++kept % 3 == 0;
    });
  }
}

}  // namespace
}  // namespace any_scene
