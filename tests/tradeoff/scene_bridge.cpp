#include <algorithm>

#include "ribbon/box2d/convert.h"
#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using ribbon::Vec2;
using test_support::CoupledWorld;

bool is_below(const b2Body& ball, const CoupledWorld& world) {
  const std::vector<Vec2> x = world.points(0);
  return std::all_of(x.begin(), x.end(), [&](Vec2 p) { return ribbon::box2d::to_double(ball.GetPosition()).y < p.y; });
}

/// Returns the ball's greatest displacement in ten seconds from rest, and its greatest motion per tick in the last one.
std::vector<double> figures(CoupledWorld& world) {
  world.settle(1800);
  const b2Body& ball = *world.world.GetBodyList();  // the newest body is the first
  const Vec2 start = ribbon::box2d::to_double(ball.GetPosition());
  Vec2 before = start;
  double drift = 0.0;
  double jitter = 0.0;
  int tick = 0;
  const ContactFigures of_run = run(world, 600, [&](CoupledWorld&) {
    const Vec2 here = ribbon::box2d::to_double(ball.GetPosition());
    drift = std::max(drift, length(here - start));
    if (++tick > 540) jitter = std::max(jitter, length(here - before));
    before = here;
  });
  std::vector<double> all = figures_of(world, of_run);
  all.push_back(drift);
  all.push_back(jitter);
  all.push_back(is_below(ball, world) ? 1.0 : 0.0);
  return all;
}

std::vector<Variant> bridge_variants() {
  const auto stiff_and_soft = together(thesis_cords({8, 32}, 0.45), thesis_cords({8}, 0.9));
  std::vector<Variant> list;
  for (const double ratio : {0.01, 0.1, 1.0, 10.0, 100.0}) {
    for (const NamedMethod& method :
         together(together(presets({"fast", "balanced", "accurate"}), chains({1, 4, 16})), stiff_and_soft)) {
      list.push_back(variant({method,
                              "ratio=" + number(ratio),
                              [ratio](CoupledWorld& world) { test_support::hang_bridge(world, ratio, 0); },
                              true,
                              {0.0, -9.81},
                              figures}));
    }
  }
  return list;
}

}  // namespace

Scene bridge_scene() {
  return {"bridge",
          "a ball of 0.01 to 100 times a cord's mass that rests on it: drift and jitter in ten seconds",
          120,
          bridge_variants,
          contact_columns({"drift_m", "jitter_m", "tunnelled"}),
          {},
          {"tunnelled is 1 if the ball is below the cord at the end.", thesis_strip, no_b2_rope},
          {"substeps=32 k=0.45"}};
}

}  // namespace tradeoff
