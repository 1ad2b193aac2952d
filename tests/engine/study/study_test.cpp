#include "ribbon/study/study.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "ribbon/definition.h"
#include "ribbon/layout.h"
#include "tests/support/refusal.h"

namespace ribbon::study {
namespace {

using test_support::refusal;
using test_support::says;

/// A weight of 50 kg that swings on a rope of 4 m, from 45 degrees on.
struct Pendulum {
  explicit Pendulum(const Accuracy& accuracy = {}) {
    b2BodyDef at;
    at.type = b2_dynamicBody;
    at.position.Set(3.0F, -3.0F);
    b2CircleShape circle;
    circle.m_radius = 0.2F;
    weight = world.CreateBody(&at);
    weight->CreateFixture(&circle, 400.0F);
    CordDef def;
    def.points = 21;
    def.accuracy = accuracy;
    def.pins = {0};
    lay_along(def, {{0.0, 0.0}, {3.0, -3.0}});
    rope = coupling.add(Cord(def));
    coupling.hold(rope, 20, *weight, {0.0F, 0.0F});
  }

  b2World world{{0.0F, -9.81F}};
  box2d::Coupling coupling;
  b2Body* weight = nullptr;
  box2d::CordId rope = 0;
};

using Act = std::function<void(Pendulum&, int tick)>;

/// Calls `act` before each tick, and with −1 when the scene is made.
MakeScene pendulum(const Accuracy& accuracy = {}, Act act = nullptr) {
  return [accuracy, act = std::move(act)] {
    const auto scene = std::make_shared<Pendulum>(accuracy);
    if (act) act(*scene, -1);
    return Scene{scene->world, scene->coupling, [scene, act](int tick) {
                   if (act) act(*scene, tick);
                   scene->coupling.tick(scene->world, 1.0 / 60.0);
                 }};
  };
}

Setting substeps(Integrator integrator, int count) { return {"", Accuracy{integrator, count, 20, 1e-7, 1'000'000}}; }

Options options_of(std::vector<Setting> settings, int windows = 0) { return {std::move(settings), windows, 1}; }

TEST(Study, ErrorsFallWithTheOrderOfTheIntegrator) {
  const Study study =
      measure(pendulum(), 40,
              options_of({substeps(Integrator::implicit_euler, 2), substeps(Integrator::implicit_euler, 4),
                          substeps(Integrator::tr_bdf2, 2), substeps(Integrator::tr_bdf2, 4)}));
  EXPECT_EQ(study.compared_ticks, 40);
  const auto error = [&study](std::size_t k) { return study.settings[k].error_m; };
  EXPECT_NEAR(error(0) / error(1), 2.0, 0.3);
  EXPECT_GT(error(2) / error(3), 2.5);  // below 4: the rope is light, and its waves are fast
  EXPECT_LT(10.0 * error(2), error(0));
}

TEST(Study, ConvergedRunHasNoErrorButTheResolution) {
  const Study study = measure(pendulum(), 40, options_of({substeps(Integrator::tr_bdf2, 64)}, 2));
  EXPECT_GT(study.agreement_m, 0.0);
  EXPECT_LT(study.agreement_m, 1e-4);
  EXPECT_DOUBLE_EQ(study.settings[0].error_m, 10.0 * study.agreement_m);
}

TEST(Study, CountedFiguresRepeat) {
  const Study a = measure(pendulum(), 40, options_of(settings(), 2));
  const Study b = measure(pendulum(), 40, options_of(settings(), 2));
  ASSERT_EQ(a.settings.size(), 7U);
  for (std::size_t k = 0; k < a.settings.size(); ++k) {
    EXPECT_EQ(a.settings[k].error_m, b.settings[k].error_m) << k;
    EXPECT_EQ(a.settings[k].work, b.settings[k].work) << k;
    EXPECT_EQ(a.settings[k].most_work, b.settings[k].most_work) << k;
    EXPECT_GT(a.settings[k].median_us, 0.0) << k;
    EXPECT_GE(a.settings[k].most_us, a.settings[k].median_us) << k;
  }
  EXPECT_EQ(a.cheapest_within(1e-2), b.cheapest_within(1e-2));
}

TEST(Study, WithoutAnAccuracyTheCordsHaveTheirOwn) {
  const Study study =
      measure(pendulum(Accuracy::fast()), 20,
              options_of({{"own", {}}, {"fast", Accuracy::fast()}, {"balanced", Accuracy::balanced()}}));
  EXPECT_EQ(study.settings[0].work, study.settings[1].work);
  EXPECT_EQ(study.settings[0].error_m, study.settings[1].error_m);
  EXPECT_NE(study.settings[0].work, study.settings[2].work);
}

/// A cord that is added in the run has the setting from its second tick on.
TEST(Study, SettingsAreThoseOfNewCordsToo) {
  std::set<int> seen;  // substeps of the new cord
  const MakeScene make = pendulum({}, [&seen](Pendulum& scene, int tick) {
    if (tick == 5) scene.coupling.add(Cord(CordDef{}));
    if (tick > 5) seen.insert(scene.coupling.cord(1).direct().def().accuracy.substeps);
  });
  measure(make, 10, options_of({substeps(Integrator::tr_bdf2, 7)}));
  EXPECT_EQ(seen, (std::set<int>{1, 4, 7, 32, 64}));  // own, probes, setting, converged runs
}

/// A ball on top of another one falls to the side to which it is kicked. From there on only windows compare it.
TEST(Study, SensitiveMotionIsComparedInWindows) {
  const MakeScene make = pendulum({}, [](Pendulum& scene, int tick) {
    if (tick >= 0) return;
    b2BodyDef at;
    b2CircleShape circle;
    circle.m_radius = 0.5F;
    at.position.Set(10.0F, 0.0F);
    scene.world.CreateBody(&at)->CreateFixture(&circle, 1.0F);
    at.position.Set(10.001F, 1.0F);
    at.type = b2_dynamicBody;
    at.allowSleep = false;
    scene.world.CreateBody(&at)->CreateFixture(&circle, 1.0F);
  });
  const Study study = measure(make, 90, options_of({{"own", {}}}, 3));
  EXPECT_LT(study.compared_ticks, 80);
  EXPECT_GT(study.compared_ticks, 20);
  EXPECT_EQ(study.compared_cords, 1.0);
  EXPECT_GT(study.compared_bodies, 0.5);
}

/// The weight is let go in the last eighth, so that errors of all ticks are a mean of little. The window is there.
TEST(Study, ErrorIsTheLargerOfWholeRunAndWindows) {
  const MakeScene make = pendulum({}, [](Pendulum& scene, int tick) {
    if (tick == 0) scene.coupling.cord(scene.rope).pin(20, {3.0, -3.0});
    if (tick == 105) scene.coupling.cord(scene.rope).free(20);
  });
  const std::vector<Setting> euler = {substeps(Integrator::implicit_euler, 1)};
  const double whole = measure(make, 120, options_of(euler)).settings[0].error_m;
  const double with_window = measure(make, 120, options_of(euler, 1)).settings[0].error_m;
  EXPECT_GT(whole, 1e-4);
  EXPECT_GT(with_window, 1.5 * whole);
}

TEST(Study, WhatBlowsUpFails) {
  const MakeScene make = pendulum({}, [](Pendulum& scene, int tick) {
    if (tick == 5 && scene.coupling.cord(scene.rope).direct().def().accuracy.substeps == 3)
      scene.weight->SetTransform({2e6F, 0.0F}, 0.0F);
  });
  const Study study = measure(make, 10, options_of({substeps(Integrator::tr_bdf2, 3), {"own", {}}}));
  EXPECT_EQ(study.settings[0].failure, "blew up in tick 6");
  EXPECT_EQ(study.settings[1].failure, "");
  EXPECT_EQ(study.front(), (std::vector<std::size_t>{1}));
}

// --- choices
// ----------------------------------------------------

Measured measured(const char* name, double work, double error, std::string failure = {}) {
  Measured m{{name}};
  m.work = work;
  m.error_m = error;
  m.failure = std::move(failure);
  return m;
}

Study study_of(std::vector<Measured> settings) {
  Study study;
  study.settings = std::move(settings);
  return study;
}

TEST(Study, FrontLeavesOutWhatFailedOrIsBeaten) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Study study =
      study_of({measured("a", 30.0, 0.001), measured("b", 10.0, 0.02), measured("c", 20.0, 0.02),
                measured("d", 5.0, 0.001, "blew up in tick 3"), measured("e", 15.0, 0.008), measured("f", 1.0, nan)});
  EXPECT_EQ(study.front(), (std::vector<std::size_t>{1, 4, 0}));
  EXPECT_EQ(study.cheapest_within(0.01), 4U);
  EXPECT_EQ(study.cheapest_within(0.0099), 0U);  // 8 mm leave a fifth of 1 cm
  EXPECT_EQ(study.cheapest_within(0.001), std::nullopt);
  EXPECT_TRUE(says(study.table(), "d: blew up in tick 3\n"));
  EXPECT_TRUE(says(study.table(), "e: 0.008 m, front\n"));
}

TEST(Study, TheWorstInputDecides) {
  const Study calm = study_of({measured("a", 10.0, 0.001), measured("b", 20.0, 0.0001), measured("c", 30.0, 0.0)});
  const Study wild = study_of({measured("a", 12.0, 0.05), measured("b", 15.0, 0.002), measured("c", 40.0, 0.0, "x")});
  const Study worst = worst_of({calm, wild, calm});
  EXPECT_EQ(calm.cheapest_within(0.01), 0U);
  EXPECT_EQ(worst.cheapest_within(0.01), 1U);
  EXPECT_EQ(worst.settings[0].work, 12.0);
  EXPECT_EQ(worst.settings[1].work, 20.0);
  EXPECT_EQ(worst.settings[2].failure, "x");
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { worst_of({}); }), "number of studies is 0"));
  EXPECT_TRUE(says(refusal<DefinitionError>([&] {
                     worst_of({calm, study_of({measured("a", 1.0, 1.0)})});
                   }),
                   "the studies have different settings"));
}

// --- refusals
// ----------------------------------------------------

TEST(Study, RefusesWhatCannotBeStudied) {
  const auto complaint = [](const MakeScene& make, int ticks, const Options& options) {
    return refusal<std::logic_error>([&] { measure(make, ticks, options); });
  };
  EXPECT_TRUE(says(complaint(nullptr, 10, {}), "no function that makes the scene"));
  EXPECT_TRUE(says(complaint(pendulum(), 0, {}), "ticks is 0; accepted is 1 to"));
  EXPECT_TRUE(says(complaint(pendulum(), 10, options_of({})), "number of settings is 0"));
  EXPECT_TRUE(says(complaint(pendulum(), 10, options_of(settings(), -1)), "number of windows is -1"));
  EXPECT_TRUE(says(complaint(pendulum(), 10, {settings(), 0, 0}), "repeats is 0"));
  EXPECT_TRUE(says(complaint(pendulum(), 10, options_of({substeps(Integrator::tr_bdf2, 0)})), "substeps"));
  const MakeScene empty = pendulum({}, [](Pendulum& scene, int tick) {
    if (tick == 0) scene.coupling.remove(scene.rope);
  });
  EXPECT_TRUE(says(complaint(empty, 10, {}), "no tick has a cord of the direct solver"));
}

TEST(Study, RefusesASceneThatDiffersFromRunToRun) {
  float push = 0.0F;
  const MakeScene make = pendulum({}, [&push](Pendulum& scene, int tick) {
    if (tick == 3) scene.weight->ApplyForceToCenter({push += 1.0F, 0.0F}, true);
  });
  EXPECT_TRUE(says(refusal<CallError>([&] {
                     measure(make, 10, options_of({{"own", {}}}));
                   }),
                   "two runs of the scene differ from tick 3 on; accepted"));
}

}  // namespace
}  // namespace ribbon::study
