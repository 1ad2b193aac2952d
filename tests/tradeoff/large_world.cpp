#include "tests/tradeoff/large_world.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "tests/support/dice.h"
#include "tests/tradeoff/measure.h"

namespace tradeoff {
namespace {

constexpr double spacing = 3.0;           // m, from cord to cord
constexpr double far_away = 2000.0;       // m
constexpr double box_half = 0.1;          // m
constexpr double least_clearance = 0.02;  // m, from a box to a cord
constexpr int many_boxes = 10'000;
constexpr int many_edges = 20'000;
constexpr int many_sleepers = 10'000;
constexpr int many_fast = 100;
constexpr int settling_ticks_of_sleepers = 60;
constexpr int measured_ticks = 60;

/// One metre apart, a hundred per row.
Vec2 far_place(int k) {
  const int row = k / 100;
  return {far_away + k % 100, static_cast<double>(row)};
}

double processor_time() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double LargeWorld::microseconds(const std::function<void()>& work) {
  const double start = processor_time();
  work();
  return processor_time() - start;
}

LargeWorld::LargeWorld(int cords, bool may_sleep) : columns_(static_cast<int>(std::ceil(std::sqrt(cords)))) {
  for (int k = 0; k < cords; ++k) hang_cord(k, may_sleep);
  unsettled_ticks_ = may_sleep ? settling_ticks_of_sleepers : 2;
}

Vec2 LargeWorld::pin(int k) const {
  const int row = k / columns_;
  return {spacing * (k % columns_), -spacing * row};
}

void LargeWorld::add_boxes_far_away() {
  for (int k = 0; k < many_boxes; ++k) add_box(far_place(k));
}

void LargeWorld::settle() {
  for (; unsettled_ticks_ > 0; --unsettled_ticks_) {
    gather();
    rest();
  }
}

std::array<double, 3> LargeWorld::median_times() {
  std::array<std::vector<double>, 3> times;
  for (int k = 0; k < measured_ticks; ++k) {
    times[0].push_back(microseconds([this] { gather(); }));
    times[1].push_back(microseconds([this] { step(); }));
    times[2].push_back(microseconds([this] { step_world(); }));
    turn_the_fast();
  }
  return {quantile(times[0], 0.5), quantile(times[1], 0.5), quantile(times[2], 0.5)};
}

void LargeWorld::add_boxes_among() {
  test_support::Dice dice(1);
  const double side = spacing * columns_;
  for (int k = 0; k < many_boxes;) {
    const Vec2 place{dice(-0.5 * spacing, side - 0.5 * spacing), dice(-side + 0.5 * spacing, 0.5 * spacing)};
    if (is_clear(place)) {
      add_box(place);
      ++k;
    }
  }
}

void LargeWorld::add_chain() {
  std::vector<b2Vec2> vertices;
  for (int k = 0; k <= many_edges; ++k) {
    const double x = 0.5 * (k - 0.5 * many_edges);
    vertices.push_back(ribbon::box2d::to_float(Vec2{x, -(points * link) - 0.05 - 0.02 * (k % 2)}));
  }
  b2ChainShape chain;
  chain.CreateChain(vertices.data(), many_edges + 1, vertices.front() - b2Vec2(1.0F, 0.0F),
                    vertices.back() + b2Vec2(1.0F, 0.0F));
  b2BodyDef def;
  world_.CreateBody(&def)->CreateFixture(&chain, 0.0F);
}

void LargeWorld::add_sleepers() {
  for (int k = 0; k < many_sleepers; ++k) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.awake = false;
    def.position = ribbon::box2d::to_float(far_place(k));
    add_circle(def);
  }
}

void LargeWorld::add_fast() {
  for (int k = 0; k < many_fast; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / many_fast;
    const Vec2 place = 6.0 * Vec2{std::cos(angle), std::sin(angle)};
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.gravityScale = 0.0F;
    def.allowSleep = false;
    def.position = ribbon::box2d::to_float(place);
    fast_.push_back(add_circle(def));
  }
}

void LargeWorld::turn_the_fast() {
  for (b2Body* body : fast_) {
    const Vec2 place = ribbon::box2d::to_double(body->GetPosition());
    body->SetLinearVelocity(ribbon::box2d::to_float((20.0 / length(place)) * perp(place)));
  }
}

void LargeWorld::hold_by_a_body() {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = ribbon::box2d::to_float(Vec2{0.0, -link * (points - 1) - box_half});
  coupling_.hold(0, points - 1, *add_circle(def), {0.0F, static_cast<float>(box_half)});
}

void LargeWorld::hang_cord(int k, bool may_sleep) {
  ribbon::CordDef def;
  def.points = points;
  def.length = link * (points - 1);
  def.radius = 0.01;
  def.allow_sleep = may_sleep;
  for (int p = 0; p < points; ++p) def.positions.push_back(pin(k) - Vec2{0.0, link * p});
  def.pins = {0};
  coupling_.add(ribbon::Cord(def));
}

bool LargeWorld::is_clear(Vec2 place) const {
  for (int k = 0; k < coupling_.size(); ++k) {
    const Vec2 off = place - pin(k);
    const double below = std::clamp(off.y, -link * (points - 1), 0.0);
    if (std::max(std::abs(off.x), std::abs(off.y - below)) < box_half + least_clearance) return false;
  }
  return true;
}

void LargeWorld::add_box(Vec2 place) {
  b2PolygonShape shape;
  shape.SetAsBox(static_cast<float>(box_half), static_cast<float>(box_half));
  b2BodyDef def;
  def.position = ribbon::box2d::to_float(place);
  world_.CreateBody(&def)->CreateFixture(&shape, 0.0F);
}

b2Body* LargeWorld::add_circle(const b2BodyDef& def) {
  b2CircleShape circle;
  circle.m_radius = static_cast<float>(box_half);
  b2Body* body = world_.CreateBody(&def);
  b2FixtureDef fixture;
  fixture.shape = &circle;
  fixture.density = 10.0F;
  fixture.filter.groupIndex = -1;
  body->CreateFixture(&fixture);
  return body;
}

}  // namespace tradeoff
