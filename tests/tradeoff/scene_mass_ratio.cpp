#include <algorithm>
#include <cmath>

#include "ribbon/box2d/convert.h"

#include "tests/study/figures.h"
#include "tests/support/constants.h"
#include "tests/support/contact_figures.h"
#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using constants::infinity;
using ribbon::Vec2;
using study::unavailable;
using test_support::CoupledWorld;
constexpr double cord_length = 3.0;  // m, as in hang_load

/// Ten seconds from the start, and one more for the jitter: the maximum motion of the body in a tick, and the mean
/// pull.
std::vector<double> figures(CoupledWorld& world, double ratio, double stiffness) {
  const auto run_figures = run(world, 600);
  const b2Body& load = *world.world.GetBodyList();  // the newest body is the first
  const int last = world.def(0).points - 1;
  Vec2 before = ribbon::box2d::to_double(load.GetPosition());
  double jitter = 0.0;
  double pull = 0.0;
  run(world, 60, [&](CoupledWorld& now) {
    const Vec2 here = ribbon::box2d::to_double(load.GetPosition());
    jitter = std::max(jitter, length(here - before));
    before = here;
    pull += now.tension(0, last) / 60.0;
  });
  const double link_share = world.method().chain ? 0.0 : 0.5 / (last);  // kg, of the cord's last point
  const bool chain = world.method().chain;
  const double elastic = std::isinf(stiffness) ? 0.0 : 2.0 / stiffness;
  return {100.0 * run_figures.max_stretch,
          100.0 * elastic,
          jitter,
          100.0 * (pull / ((ratio + link_share) * 9.81) - 1.0),
          100.0 * run_figures.energy_gain,
          chain ? unavailable : run_figures.corrected,
          chain ? unavailable : run_figures.unconverged,
          cord_length * std::abs(run_figures.max_stretch - elastic)};
}

std::vector<Variant> mass_ratio_variants() {
  std::vector<Variant> list;
  for (const double ratio : {168.0, 200.0, 672.0, 1000.0, 1800.0, 1e6}) {
    const auto add = [&](const NamedMethod& method, double stiffness) {
      NamedMethod elastic = method;
      if (!method.how.chain) elastic.setting += " EA/Mg=" + number(stiffness);
      list.push_back(variant({elastic,
                              "ratio=" + number(ratio),
                              [=](CoupledWorld& world) { test_support::hang_load(world, ratio, stiffness); },
                              false,
                              {0.0, -9.81},
                              [=](CoupledWorld& world) { return figures(world, ratio, stiffness); }}));
    };
    for (const NamedMethod& method : presets({"fast", "balanced"})) add(method, infinity);
    for (const NamedMethod& method : presets({"balanced"})) add(method, 1e3);
    for (const NamedMethod& method : chains({4, 16, 64})) add(method, infinity);
  }
  return list;
}

}  // namespace

Scene mass_ratio_scene() {
  return {
      "mass_ratio",
      "a cord of 31 points that holds a body of 168 to 1,000,000 times its mass: stretch, jitter, pull",
      120,
      mass_ratio_variants,
      {us_per_tick(), p99_us(), cords_us(), cords_max_us(), world_step_us(), figure("max_stretch_pct", 0),
       figure("elastic_pct", 1), figure("jitter_m", 2), figure("pull_error_pct", 3), figure("energy_gain_pct", 4),
       figure("corrected", 5), figure("unconverged", 6), figure("stretch_error_m", 7)},
      {},
      {"stretch_error_m is by how much the cord is longer than it should become at the most, or shorter.", no_b2_rope}};
}

}  // namespace tradeoff
