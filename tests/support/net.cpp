#include "tests/support/net.h"

#include <algorithm>
#include <numbers>

#include "ribbon/cord.h"
#include "tests/support/points.h"

namespace test_support {
namespace {

constexpr double width = Net::mesh * (Net::cords - 1);  // m
constexpr int narrowing_ticks = 60;
constexpr double narrowing = 0.005;  // m, of each side in a tick
constexpr double radius = 0.2;       // m, of the ball

}  // namespace

Net::Net(const ribbon::Accuracy& accuracy) {
  ribbon::CordDef def;
  def.points = cords;
  def.length = width;
  def.radius = 0.01;
  def.accuracy = accuracy;
  for (int k = 0; k < 2 * cords; ++k) {
    def.positions = k < cords ? equally_spaced(cords, {0.0, -mesh * k}, {mesh, 0.0})
                              : equally_spaced(cords, {mesh * (k - cords), 0.0}, {0.0, -mesh});
    def.pins.clear();
    if (k == 0) def.pins = {0, cords - 1};
    coupling.add(ribbon::Cord(def));
  }
  for (int i = 0; i < cords; ++i) {
    for (int j = 0; j < cords; ++j) coupling.tie({i, j, cords + j, i});
  }
}

void Net::tick_cords() {
  if (ticks < narrowing_ticks) {
    const double inwards = narrowing * (ticks + 1);
    coupling.cord(0).drag(0, {inwards, 0.0});
    coupling.cord(0).drag(cords - 1, {width - inwards, 0.0});
  }
  ++ticks;
  coupling.gather(world, dt);
  coupling.step();
  coupling.apply();
}

void Net::tick() {
  tick_cords();
  tick_world();
}

void Net::drop_ball(double mass) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position.Set(static_cast<float>(0.5 * width), 1.0F);
  ball = world.CreateBody(&def);
  b2CircleShape circle;
  circle.m_radius = static_cast<float>(radius);
  ball->CreateFixture(&circle, static_cast<float>(mass / (std::numbers::pi * radius * radius)));
}

double Net::strain() const {
  double largest = 0.0;
  for (const ribbon::box2d::CordId cord : coupling.cords()) {
    const auto x = coupling.cord(cord).positions();
    for (std::size_t i = 1; i < x.size(); ++i) largest = std::max(largest, length(x[i] - x[i - 1]) / mesh - 1.0);
  }
  return largest;
}

}  // namespace test_support
