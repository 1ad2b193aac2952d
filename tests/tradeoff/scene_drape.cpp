#include <algorithm>

#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using test_support::CoupledWorld;

constexpr int drape_ticks = 120;
constexpr double falling_target = 200.0;  // µs
constexpr double resting_target = 60.0;

double fastest(const CoupledWorld& world) {
  double speed = 0.0;
  if (world.method().chain) {
    for (const b2Body* body = world.world.GetBodyList(); body != nullptr; body = body->GetNext()) {
      speed = std::max(speed, static_cast<double>(body->GetLinearVelocity().Length()));
    }
    return speed;
  }
  const auto velocities = world.method().thesis ? world.coupling.cord(0).thesis().velocities()
                                                : world.coupling.cord(0).direct().velocities();
  for (const ribbon::Vec2 v : velocities) speed = std::max(speed, length(v));
  return speed;
}

std::vector<double> with_speed(CoupledWorld& world, double target_us) {
  std::vector<double> figures = figures_of(world, run(world, drape_ticks), target_us);
  figures.push_back(fastest(world));
  return figures;
}

/// The first two seconds; two more after eight, when only the ends still swing; and two after it has settled. The timed
/// ticks follow these.
std::vector<Variant> drape_variants() {
  std::vector<Variant> list;
  for (const double friction : {0.0, 0.5}) {
    std::vector<NamedMethod> methods = together(presets({"fast", "balanced", "accurate"}), chains({1, 4, 16}));
    if (friction == 0.0)
      methods = together(methods, together(thesis_cords({8, 32, 128}, 0.45), thesis_cords({8, 32}, 0.9)));
    for (const NamedMethod& method : methods) {
      const auto set_up = [=](CoupledWorld& world) { test_support::lay_over_circles(world, friction); };
      const std::string setting = "friction=" + number(friction);
      list.push_back(variant({method, setting + " falling", set_up, false, {0.0, -9.81}, [](CoupledWorld& world) {
                                return with_speed(world, falling_target);
                              }}));
      if (friction == 0.0) continue;  // the cord slides off
      list.push_back(variant({method, setting + " swinging", set_up, true, {0.0, -9.81}, [](CoupledWorld& world) {
                                for (int k = 0; k < 480; ++k) world.tick();
                                return with_speed(world, falling_target);
                              }}));
      list.push_back(variant({method, setting + " at rest", set_up, true, {0.0, -9.81}, [](CoupledWorld& world) {
                                world.settle(900);
                                return with_speed(world, resting_target);
                              }}));
    }
  }
  return list;
}

}  // namespace

Scene drape_scene() {
  return {"drape",
          "a cord of 50 points that falls over 20 static circles, and rests on them",
          drape_ticks,
          drape_variants,
          contact_columns({"speed_m_s"}),
          {},
          {std::string(thesis_strip) + " It is included where there is no friction.", no_b2_rope}};
}

}  // namespace tradeoff
