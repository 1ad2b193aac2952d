#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "ribbon/pulley.h"
#include "tests/support/constants.h"
#include "tests/support/pulleys.h"
#include "tests/tradeoff/measure.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

using constants::dt;
using constants::g;
constexpr int ticks = 120;

/// A cord around wheels that a wall and a block carry.
struct Run {
  ribbon::Cord cord;
  std::vector<ribbon::RigidBody> bodies;
  std::vector<ribbon::Axle> axles;
  int unconverged = 0;

  void step() {
    ribbon::Surroundings surroundings;
    surroundings.bodies = bodies;
    surroundings.axles = axles;
    for (ribbon::RigidBody& body : bodies) body.impulse = {};
    unconverged += cord.step(dt, {0.0, -g}, surroundings).unconverged;
    for (ribbon::RigidBody& body : bodies) {
      if (body.inverse_mass == 0.0) continue;
      body.velocity += dt * body.acceleration + body.inverse_mass * body.impulse;
      body.position += body.moved;
    }
  }
};

/// A machine, and the velocity that its last or first point has after all ticks.
struct Machine {
  std::string name;
  Run (*make)(const ribbon::Accuracy&);
  double (*speed)(const Run&);
  double exact;
};

Run atwood(const ribbon::Accuracy& accuracy) {
  test_support::Atwood of;
  of.accuracy = accuracy;
  ribbon::RigidBody wall;
  wall.position = of.wheel.center;
  return {of.cord(), {wall}, {{0, {}}}};
}

/// A drum that holds still under a cord that slips.
Run capstan(const ribbon::Accuracy& accuracy) {
  test_support::Atwood of;
  of.accuracy = accuracy;
  of.wheel.friction = 0.3;
  of.right = 50.0;
  of.depth = 12.0;
  of.points = 201;
  ribbon::RigidBody wall;
  wall.position = of.wheel.center;
  Run run{of.cord(), {wall}, {{0, {}}}};
  set_motor(run.cord, 0, 0.0, 1e12);
  return run;
}

Run tackle(const ribbon::Accuracy& accuracy) {
  Run run{test_support::tackle_cord(test_support::tackle_def(181, accuracy)), test_support::tackle_blocks(40.0),
          test_support::axles_of_tackle()};
  run.cord.attach_mass(0, 11.0);
  return run;
}

double fall(const Run& run) { return -run.cord.velocities().back().y; }
double lift(const Run& run) { return run.bodies[1].velocity.y; }

std::vector<Machine> machines() {
  const double time = ticks * dt;
  const double ratio = std::exp(0.3 * 3.14159265358979323846);
  return {{"Atwood's machine", atwood, fall, time * 2.0 * g / (22.0 + 0.5 / 0.04)},
          {"a drum, slipping", capstan, fall, time * g * (50.0 - 10.0 * ratio) / (50.0 + 10.0 * ratio)},
          {"a tackle 4:1", tackle, lift, time * g * (44.0 - 40.0) / (16.0 * 11.0 + 40.0)}};
}

Variant variant(const Machine& machine, const std::string& setting, const ribbon::Accuracy& accuracy) {
  const auto run = std::make_shared<std::unique_ptr<Run>>();
  const auto renew = [=] { *run = std::make_unique<Run>(machine.make(accuracy)); };
  const auto figures = [=] {
    Run measured = machine.make(accuracy);
    for (int k = 0; k < ticks; ++k) measured.step();
    const double error = 100.0 * std::abs(machine.speed(measured) / machine.exact - 1.0);
    return std::vector<double>{error, static_cast<double>(measured.unconverged)};
  };
  return {"ribbon",     setting, machine.make(accuracy).cord.size(), renew, [run] { (*run)->step(); }, figures, [] {},
          machine.name, {}};
}

std::vector<Variant> pulleys() {
  std::vector<Variant> list;
  for (const Machine& machine : machines()) {
    list.push_back(variant(machine, "fast", ribbon::Accuracy::fast()));
    list.push_back(variant(machine, "balanced", ribbon::Accuracy::balanced()));
    list.push_back(variant(machine, "accurate", ribbon::Accuracy::accurate()));
  }
  return list;
}

}  // namespace

std::vector<Scene> pulley_scenes() {
  return {{"pulley",
           "a cord around wheels, 2 s: the error of the speed against the formula",
           ticks,
           pulleys,
           {cords_us(), p99_us(), cords_max_us(), figure("speed_error_percent", 0), figure("unconverged", 1)}}};
}

}  // namespace tradeoff
