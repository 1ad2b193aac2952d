#include <algorithm>

#include "engine/convert.h"
#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using ribbon::Vec2;
using test_support::CoupledWorld;

/// Ten seconds: how far the ball goes from where it was, and the most that it moves in a tick of the last second.
std::vector<double> figures(CoupledWorld& world) {
  const b2Body& ball = *world.world.GetBodyList();  // the last made is the first there
  const Vec2 start = engine::to_double(ball.GetPosition());
  Vec2 before = start;
  double drift = 0.0;
  double jitter = 0.0;
  int tick = 0;
  const ContactFigures of_run = run(world, 600, [&](CoupledWorld&) {
    const Vec2 here = engine::to_double(ball.GetPosition());
    drift = std::max(drift, length(here - start));
    if (++tick > 540) jitter = std::max(jitter, length(here - before));
    before = here;
  });
  std::vector<double> all = figures_of(world, of_run);
  all.push_back(drift);
  all.push_back(jitter);
  return all;
}

std::vector<Contestant> contestants() {
  std::vector<Contestant> list;
  for (const double ratio : {0.01, 0.1, 1.0, 10.0, 100.0}) {
    for (const NamedMethod& method : 
         together(together(presets({"fast", "balanced", "accurate"}), chains({1, 4, 16})), thesis_cords({8, 32, 128}))) {
      list.push_back(contestant({method,
                                 "ratio=" + number(ratio),
                                 [ratio](CoupledWorld& world) { test_support::hang_bridge(world, ratio); },
                                 true,
                                 {0.0, -9.81},
                                 figures}));
    }
  }
  return list;
}

}  // namespace

Scene bridge_scene() {
  return {"bridge", "a ball of 0.01 to 100 times a cord's mass that rests on it: drift and jitter in ten seconds", 120,
          contestants, contact_columns({"drift_m", "jitter_m"}), {},
          {"The thesis's cord is a strip of square cells, a link wide, without friction.", no_b2_rope}};
}

}  // namespace tradeoff
