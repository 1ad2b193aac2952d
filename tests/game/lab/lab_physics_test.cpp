// The lab shows the physics that it claims, against exact references.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "game/lab/experiment.h"
#include "game/lab/figures.h"
#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"
#include "tests/game/lab/cords_of.h"

namespace game::lab {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

double reading(const Experiment& experiment, Reading::Kind kind) {
  for (const Reading& each : experiment.scene().readings(cords_of(experiment), experiment.values())) {
    if (each.kind == kind) return each.value;
  }
  ADD_FAILURE() << "the scene has no such reading";
  return 0.0;
}

void run(Experiment& experiment, int ticks) {
  for (int k = 0; k < ticks; ++k) experiment.tick();
}

TEST(LabHeavyLoad, AMillionTimesItsMassStretchesTheCordLessThanAMillionth) {
  Experiment experiment(scene_named("heavy_load"));
  experiment.set(Knob::load_ratio, 1e6);
  experiment.restart();
  double cord = 0.0;
  double chain = 0.0;
  for (int tick = 0; tick < 600; ++tick) {
    experiment.tick();
    cord = std::max(cord, std::abs(greatest_stretch(*experiment.benches()[0])));
    chain = std::max(chain, greatest_stretch(*experiment.benches()[1]));
  }
  EXPECT_LT(cord, 1e-6);
  EXPECT_GT(chain, 1.0) << "Box2D's chain is more than twice as long";
}

/// At rest each link bears the load and the weight of the points below it: half a link's mass for the last one.
TEST(LabHeavyLoad, AnElasticCordAtRestStretchesByTheExactSum) {
  for (const double ratio : {1.0, 1000.0, 1e6}) {
    Experiment experiment(scene_named("heavy_load"));
    experiment.set(Knob::start_angle, 0.0);
    experiment.set(Knob::load_ratio, ratio);
    const double stiffness = 1e2 * 9.81 * (1.0 + ratio);
    experiment.set(Knob::stretch, stiffness);
    experiment.restart();
    for (int k = 0; k < 30 * 60; ++k) experiment.tick();
    constexpr int links = 30;
    double exact = 0.0;  // relative
    for (int link = 0; link < links; ++link) {
      const double below = (links - 1 - link + 0.5) / links;  // kg of the cord's 1 kg
      exact += 9.81 * (ratio + below) / stiffness / links;
    }
    EXPECT_NEAR(greatest_stretch(cords_of(experiment)) / exact, 1.0, 1e-3) << ratio;
  }
}

TEST(LabHeavyLoad, MoreSubstepsOfBox2DStretchItsChainLess) {
  const auto stretch_with = [](double substeps) {
    Experiment experiment(scene_named("heavy_load"));
    experiment.set(Knob::chain_substeps, substeps);
    double most = 0.0;
    for (int k = 0; k < 300; ++k) {
      experiment.tick();
      most = std::max(most, greatest_stretch(*experiment.benches()[1]));
    }
    return most;
  };
  EXPECT_LT(stretch_with(16.0), 0.5 * stretch_with(1.0));
}

/// The weights hold below the ratio e^(μ·angle), and slip beyond it.
TEST(LabCapstan, HoldsUpToTheExactRatio) {
  for (const double turns : {0.0, 1.0}) {
    const double limit = std::exp(0.3 * std::numbers::pi * (2.0 * turns + 1.0));
    const auto drop = [&](double share) {
      Experiment experiment(scene_named("capstan"));
      experiment.set(Knob::turns, turns);
      experiment.set(Knob::weight_ratio, share * limit);
      experiment.restart();
      const b2Body& heavy = *cords_of(experiment).bodies().back().body;
      const double start = to_double(heavy.GetPosition()).y;
      run(experiment, 120);
      EXPECT_NEAR(reading(experiment, Reading::Kind::holding_limit) / limit, 1.0, 1e-12);
      return start - to_double(heavy.GetPosition()).y;
    };
    EXPECT_LT(drop(0.9), 0.01) << turns;
    EXPECT_GT(drop(1.1), 0.1) << turns;
  }
}

TEST(LabBuckling, ColumnsBendAboveTheCriticalLoadOnly) {
  Experiment experiment(scene_named("buckling"));
  run(experiment, 60 * 60);
  for (int column = 0; column < 5; ++column) {
    const auto x = cords_of(experiment).coupling().cord(column).positions();
    const double aside = std::abs(x.back().x - x.front().x);
    if (column < 2) {
      EXPECT_LT(aside, 0.05) << column;
    } else {
      EXPECT_GT(aside, 0.3) << column;
    }
  }
  experiment.set(Knob::load_share, 0.5);
  run(experiment, 60 * 30);
  for (int column = 0; column < 5; ++column) {
    const auto x = cords_of(experiment).coupling().cord(column).positions();
    EXPECT_LT(std::abs(x.back().x - x.front().x), 0.05) << "with half the loads all stand straight again: " << column;
  }
}

TEST(LabBridge, TheBallRestsOnTheCord) {
  for (const double ratio : {0.01, 30.0, 1e4}) {
    Experiment experiment(scene_named("bridge"));
    experiment.set(Knob::load_ratio, ratio);
    run(experiment, 600);
    const b2Body& ball = *cords_of(experiment).bodies().back().body;
    const auto x = cords_of(experiment).coupling().cord(0).positions();
    const double lowest = std::min_element(x.begin(), x.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; })->y;
    EXPECT_GT(to_double(ball.GetPosition()).y, lowest) << ratio;
  }
}

TEST(LabLamps, FallAsleepAndOnlyTheTouchedOneWakes) {
  Experiment experiment(scene_named("lamps"));
  experiment.set(Knob::count, 100.0);
  run(experiment, 20 * 60);
  EXPECT_EQ(reading(experiment, Reading::Kind::awake), 0.0);
  EXPECT_EQ(cords_of(experiment).coupling().last_step().report().work, 0);
  engine::TickInput input;
  input.buttons = button_drag;
  engine::set_pointer(input, to_double(cords_of(experiment).bodies()[7].body->GetPosition()) + Vec2{0.05, 0.0});
  for (int k = 0; k < 10; ++k) experiment.tick(input);
  EXPECT_EQ(reading(experiment, Reading::Kind::awake), 1.0);
}

/// A drag moves what is nearest to the pointer: a point, a pin, a disc, a static post, a link of a chain.
TEST(LabDrag, MovesAnything) {
  const auto drag_from = [](Experiment& experiment, Vec2 from, Vec2 to) {
    engine::TickInput input;
    input.buttons = button_drag;
    for (int k = 0; k <= 60; ++k) {
      engine::set_pointer(input, from + (std::min(k, 30) / 30.0) * (to - from));
      experiment.tick(input);
    }
  };
  {
    Experiment experiment(scene_named("thesis_a"));
    const Vec2 tip = cords_of(experiment).coupling().cord(0).positions().back();
    drag_from(experiment, tip, {-0.3, -0.6});
    EXPECT_LT(length(cords_of(experiment).coupling().cord(0).positions().back() - Vec2{-0.3, -0.6}), 0.05);
  }
  {
    Experiment experiment(scene_named("bridge"));
    const Vec2 pin = cords_of(experiment).coupling().cord(0).positions().front();
    drag_from(experiment, pin, pin + Vec2{0.5, 0.5});
    EXPECT_LT(length(cords_of(experiment).coupling().cord(0).positions().front() - pin - Vec2{0.5, 0.5}), 0.02);
  }
  {
    Experiment experiment(scene_named("capstan"));
    const b2Body& post = *cords_of(experiment).bodies().front().body;
    drag_from(experiment, {0.0, 0.0}, {0.3, 0.2});
    EXPECT_LT(length(to_double(post.GetPosition()) - Vec2{0.3, 0.2}), 0.03);
  }
  {
    Experiment experiment(scene_named("heavy_load"));
    const b2Body& link = *experiment.benches()[1]->bodies()[15].body;
    const Vec2 at = to_double(link.GetPosition());
    drag_from(experiment, at, at + Vec2{0.0, 0.5});
    EXPECT_EQ(experiment.benches()[1]->drag().body(), &link);
    EXPECT_EQ(experiment.benches()[0]->drag().body(), nullptr) << "the other bench is too far";
  }
}

}  // namespace
}  // namespace game::lab
