#include <chrono>

#include "ribbon/box2d/convert.h"
#include "tests/peers/runners.h"

namespace peers {

using test_support::CoupledWorld;

double parameter_or(const Parameters& parameters, const std::string& name, double fallback) {
  for (const Parameter& parameter : parameters) {
    if (parameter.name == name) return parameter.value;
  }
  return fallback;
}

Recording run_coupled(const SetUp& set_up, const Plan& plan, const test_support::CordMethod& method) {
  CoupledWorld world(method, plan.gravity);
  set_up(world);
  const std::vector<b2Body*> moving_bodies = moving_bodies_of(world.world);
  world.settle(plan.settling_ticks);
  Recording recording;
  for (int tick = 0; tick < plan.ticks; ++tick) {
    const auto start = std::chrono::steady_clock::now();
    world.tick();
    Frame frame;
    frame.us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    for (int c = 0; c < world.cords(); ++c) frame.cords.push_back(world.points(c));
    for (const b2Body* body : moving_bodies)
      frame.moving_bodies.push_back(ribbon::box2d::to_double(body->GetPosition()));
    recording.push_back(std::move(frame));
    if (!is_in_bounds(recording.back())) break;
  }
  return recording;
}

}  // namespace peers
