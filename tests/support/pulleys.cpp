#include "tests/support/pulleys.h"

namespace test_support {

using ribbon::Axle;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::PulleyDef;
using ribbon::ReevedCord;
using ribbon::Vec2;

Cord Atwood::cord() const {
  const double side = wheel.counterclockwise ? -1.0 : 1.0;
  const Vec2 first = wheel.center + Vec2{-side * wheel.radius, -depth};
  const Vec2 last = wheel.center + Vec2{side * wheel.radius, -depth};
  const ReevedCord reeved = ribbon::reeve(first, {&wheel, 1}, last, points);
  CordDef def;
  def.points = points;
  def.length = reeved.length;
  def.positions = reeved.positions;
  def.mass_per_length = mass_per_length;
  def.accuracy = accuracy;
  Cord cord(def);
  cord.attach_mass(0, left);
  cord.attach_mass(points - 1, right);
  add_pulley(cord, reeved.pulleys[0]);
  return cord;
}

ReevedCord reeve_tackle(int points) {
  std::vector<PulleyDef> wheels;
  for (const double x : {0.0, 0.2, 0.4, 0.6}) {
    const bool moves = wheels.size() % 2 == 1;
    wheels.push_back({.center = {x, moves ? 2.0 : 6.0}, .radius = 0.1, .counterclockwise = moves});
  }
  return ribbon::reeve({-0.1, 3.0}, wheels, {0.7, 5.5}, points);
}

CordDef tackle_def(int points, const ribbon::Accuracy& accuracy) {
  const ReevedCord reeved = reeve_tackle(points);
  CordDef def;
  def.points = points;
  def.length = reeved.length;
  def.positions = reeved.positions;
  def.mass_per_length = 1e-5;
  def.pins = {points - 1};
  def.accuracy = accuracy;
  return def;
}

Cord tackle_cord(const CordDef& def) {
  Cord cord(def);
  for (const PulleyDef& pulley : reeve_tackle(def.points).pulleys) add_pulley(cord, pulley);
  return cord;
}

std::vector<ribbon::RigidBody> tackle_blocks(double load) {
  std::vector<ribbon::RigidBody> blocks(2);
  blocks[0].position = fixed_block;
  blocks[1].position = moving_block;
  blocks[1].inverse_mass = 1.0 / load;
  blocks[1].acceleration = {0.0, -9.81};
  return blocks;
}

std::vector<Axle> axles_of_tackle() { return {{0, {-0.2, 0.0}}, {1, {-0.2, 0.0}}, {0, {0.2, 0.0}}, {1, {0.2, 0.0}}}; }

}  // namespace test_support
