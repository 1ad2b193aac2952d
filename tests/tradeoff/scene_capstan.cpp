#include <cmath>
#include <limits>
#include <numbers>

#include "ribbon/box2d/convert.h"
#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using ribbon::Vec2;
using test_support::CoupledWorld;

constexpr double friction = 0.3;
constexpr double slack_pull = 10.0;  // N
constexpr double drag_speed = 0.05;  // m/s
constexpr double pi = std::numbers::pi;

int last_point(const CoupledWorld& world) { return world.def(0).points - 1; }

/// The outward direction of the cord's end.
Vec2 taut_direction(const CoupledWorld& world) {
  const std::vector<Vec2> x = world.points(0);
  const Vec2 along = x.back() - x[x.size() - 2];
  return (1.0 / length(along)) * along;
}

/// A kinematic body drags the last point.
void set_up(CoupledWorld& world, double angle) {
  test_support::wind_around_post(world, angle, friction);
  world.pull(0, 0, {0.0, -slack_pull});
  b2Body& hand = world.add_load(b2_kinematicBody, world.points(0).back(), 0.0, 0.0);
  hand.SetLinearVelocity(ribbon::box2d::to_float(drag_speed * taut_direction(world)));
  world.hold(0, last_point(world), hand);
}

/// Returns the displacement of the slack end in eight seconds after the first two, m. The pull at the other end is that
/// for slipping at a part of the angle, so the cord should stick.
double creep(const NamedMethod& method, double angle, double share) {
  CoupledWorld world(method.how, {});
  test_support::wind_around_post(world, angle, friction);
  world.pull(0, 0, {0.0, -slack_pull});
  world.pull(0, last_point(world), std::exp(share * friction * angle) * slack_pull * taut_direction(world));
  for (int k = 0; k < 120; ++k) world.tick();
  const Vec2 start = world.points(0).front();
  for (int k = 0; k < 480; ++k) world.tick();
  return length(world.points(0).front() - start);
}

/// Two seconds of slipping; the mean tensions are those of the last second.
std::vector<double> figures(CoupledWorld& world, const NamedMethod& method, double angle) {
  double taut = 0.0;
  int tick = 0;
  const auto of_run = run(world, 120, [&](CoupledWorld& now) {
    if (++tick > 60) taut += now.tension(0, last_point(now)) / 60.0;
  });
  std::vector<double> all = figures_of(world, of_run);
  all[2] = std::numeric_limits<double>::quiet_NaN();  // energy is not conserved: the end is dragged
  const double exact = std::exp(friction * angle);
  all.push_back(taut / slack_pull);
  all.push_back(exact);
  all.push_back(100.0 * (taut / slack_pull / exact - 1.0));
  for (const double share : {0.5, 0.95}) all.push_back(creep(method, angle, share));
  return all;
}

std::vector<Variant> capstan_variants() {
  std::vector<Variant> list;
  for (const int half_turns : {1, 2}) {
    const double angle = half_turns * pi;
    for (const NamedMethod& method : together(presets({"fast", "balanced", "accurate"}), chains({1, 4, 16}))) {
      list.push_back(variant({method,
                              "angle=" + std::to_string(half_turns) + "pi",
                              [angle](CoupledWorld& world) { set_up(world, angle); },
                              false,
                              {},
                              [=](CoupledWorld& world) { return figures(world, method, angle); }}));
    }
  }
  return list;
}

}  // namespace

Scene capstan_scene() {
  return {"capstan",
          "a cord dragged around a static circle, friction 0.3: the ratio of its pulls against e^(mu*angle)",
          120,
          capstan_variants,
          contact_columns({"slip_ratio", "exact_ratio", "ratio_error_pct", "creep_50pct_m", "creep_95pct_m"}),
          {},
          {"creep_95pct_m is how far the cord slips in eight seconds with its ends pulled at a ratio that 95 % of the "
           "angle would hold: it should stick. The thesis's cord has no friction, and is not included.",
           no_b2_rope}};
}

}  // namespace tradeoff
