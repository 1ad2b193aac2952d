#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/pulley.h"
#include "ribbon/weather.h"
#include "tests/support/constants.h"

// Random scenes of cords around wheels, with everything that a cord can have and meet.

namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::PulleyDef;
using ribbon::Vec2;
using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using ribbon::box2d::PulleyId;

using constants::dt;
constexpr int seeds = 12;
constexpr int ticks = 200;
using constants::infinity;

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double within(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0; }
  double log_within(double low, double high) { return std::exp(within(std::log(low), std::log(high))); }
  int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  bool chance(double share) { return within(0.0, 1.0) < share; }

 private:
  std::mt19937 engine_;
};

/// A cord over one to four wheels, of which every second one hangs in a block; a body at each end that is not pinned.
class Machine {
 public:
  Machine(unsigned seed, const Accuracy& accuracy) : dice_(seed), accuracy_(accuracy) {
    add_wheels();
    lay_cord();
    add_others();
  }

  void tick(int number) {
    if (number % 10 == 9) act();
    coupling.tick(world, dt);
    unconverged += coupling.last_step().report().unconverged;
  }
  /// Returns the highest speed of a point, m/s; infinity if a value is not finite.
  double highest_speed() const {
    double highest = 0.0;
    for (const CordId id : coupling.cords()) {
      for (const Vec2 x : coupling.cord(id).positions()) {
        if (!is_finite(x)) return infinity;
      }
      for (const Vec2 v : coupling.cord(id).direct().velocities()) highest = std::max(highest, length(v));
    }
    return highest;
  }
  /// Returns the largest strain of a link of an inextensible cord that is off the wheels.
  double strain() const {
    double largest = 0.0;
    for (const CordId id : coupling.cords()) {
      const Cord& cord = coupling.cord(id).direct();
      if (std::isfinite(cord.def().stretch_stiffness)) continue;
      for (int link = 0; link + 1 < cord.size(); ++link) {
        const bool on_wheel = std::any_of(pulleys_of(cord).begin(), pulleys_of(cord).end(), [link](const auto& pulley) {
          return link >= pulley.def.before && link < pulley.def.after;
        });
        const auto p = static_cast<std::size_t>(link);
        if (!on_wheel) {
          largest =
              std::max(largest, length(cord.positions()[p + 1] - cord.positions()[p]) / cord.rest_length(link) - 1.0);
        }
      }
    }
    return largest;
  }

  b2World world{b2Vec2(0.0F, -9.81F)};
  Coupling coupling;
  int unconverged = 0;

 private:
  b2Body& add_body(Vec2 position, double mass, b2BodyType type, double radius, bool collides) {
    b2BodyDef definition;
    definition.type = type;
    definition.position = ribbon::box2d::to_float(position);
    b2Body* const body = world.CreateBody(&definition);
    b2CircleShape circle;
    circle.m_radius = static_cast<float>(radius);
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.density = static_cast<float>(mass / (std::numbers::pi * radius * radius));
    fixture.friction = 0.5F;
    if (!collides) fixture.filter.maskBits = 0;
    body->CreateFixture(&fixture);
    return *body;
  }

  void add_wheels() {
    const int count = dice_.whole(1, 4);
    double x = 0.0;
    for (int k = 0; k < count; ++k) {
      PulleyDef wheel;
      const bool hangs = k % 2 == 1;
      wheel.radius = dice_.within(0.08, 0.3);
      wheel.center = {x, hangs ? dice_.within(1.0, 2.5) : dice_.within(5.0, 6.0)};
      wheel.counterclockwise = hangs;
      wheel.inertia = dice_.chance(0.5) ? dice_.log_within(1e-3, 3.0) : 0.0;
      if (dice_.chance(0.5)) wheel.friction = dice_.within(0.0, 0.6);
      if (dice_.chance(0.2)) wheel.turns = dice_.whole(1, 3);
      if (dice_.chance(0.3)) {
        wheel.motor_speed = dice_.within(-4.0, 4.0);
        wheel.motor_torque = dice_.log_within(1.0, 300.0);
      }
      wheels_.push_back(wheel);
      x += wheel.radius + dice_.within(0.65, 1.3);
    }
    width_ = x;
  }

  void lay_cord() {
    const bool up = wheels_.size() % 2 == 0;
    const Vec2 first =
        wheels_.front().center + Vec2{-wheels_.front().radius, dice_.within(1.0, 3.0) - wheels_.front().center.y};
    const Vec2 last{wheels_.back().center.x + wheels_.back().radius,
                    up ? dice_.within(5.0, 6.0) : dice_.within(0.5, 3.0)};
    const int points = dice_.whole(60, 200);
    const ribbon::ReevedCord reeved = ribbon::reeve(first, wheels_, last, points);
    CordDef def;
    def.points = points;
    def.length = reeved.length;
    def.positions = reeved.positions;
    def.mass_per_length = dice_.log_within(1e-2, 0.5);
    def.radius = dice_.within(0.005, 0.03);
    if (dice_.chance(0.5)) def.stretch_stiffness = dice_.log_within(1e4, 1e6);
    def.tension_only = dice_.chance(0.3);
    if (dice_.chance(0.3)) def.damping = dice_.log_within(1e-4, 1e-1);
    if (dice_.chance(0.3)) def.drag = dice_.within(0.0, 1.0);
    def.friction = dice_.within(0.0, 1.0);
    def.self_contact = dice_.chance(0.3);
    def.cord_contact = dice_.chance(0.3);
    if (up) def.pins = {points - 1};
    def.accuracy = accuracy_;
    if (dice_.chance(0.3)) {
      ribbon::WeatherDef windy;
      windy.wind = {dice_.within(-15.0, 15.0), 0.0};
      windy.gusts = 0.5;
      windy.water_level = 1.0;
      weather_.emplace(windy);
      coupling.set_medium(&*weather_);
      def.drag_across = 1.2;
      def.drag_along = 0.02;
      def.displaced_area = 1e-4;
    }
    cord_ = coupling.add(Cord(def));
    b2Body& wall = add_body({0.0, 10.0}, 1.0, b2_staticBody, 0.1, false);
    b2Body* block = nullptr;
    for (std::size_t k = 0; k < wheels_.size(); ++k) {
      const bool hangs = k % 2 == 1;
      if (hangs && block == nullptr) {
        block = &add_body(wheels_[k].center, dice_.within(5.0, 30.0), b2_dynamicBody, 0.05, false);
      }
      pulleys_.push_back(coupling.add_pulley(cord_, hangs ? *block : wall, reeved.pulleys[k]));
    }
    b2Body& left = add_body(first, dice_.within(3.0, 12.0), b2_dynamicBody, 0.1, true);
    coupling.hold(left, {.cord = cord_, .arc = 0.0});
    if (up) return;
    b2Body& right = add_body(last, dice_.within(3.0, 12.0), b2_dynamicBody, 0.1, true);
    coupling.hold(right, {.cord = cord_, .arc = reeved.length});
  }

  void add_others() {
    for (int k = dice_.whole(0, 2); k > 0; --k) {
      add_body({dice_.within(-1.0, width_), dice_.within(6.8, 9.0)}, dice_.log_within(0.1, 10.0), b2_dynamicBody,
               dice_.within(0.05, 0.2), true);
    }
    if (!dice_.chance(0.4)) return;
    CordDef def;
    def.points = dice_.whole(5, 30);
    def.length = dice_.within(0.5, 2.0);
    for (int p = 0; p < def.points; ++p) def.positions.push_back({def.length * p / (def.points - 1), 7.0});
    def.mass_per_length = dice_.log_within(0.01, 1.0);
    def.radius = 0.02;
    def.friction = 0.5;
    def.cord_contact = true;
    def.accuracy = accuracy_;
    coupling.add(Cord(def));
  }

  /// A cut, a motor, a grip that climbs, or a wheel that the cord is taken off.
  void act() {
    const std::vector<CordId> ids(coupling.cords().begin(), coupling.cords().end());
    const CordId id = ids[static_cast<std::size_t>(dice_.whole(0, static_cast<int>(ids.size()) - 1))];
    const PulleyId pulley = pulleys_[static_cast<std::size_t>(dice_.whole(0, static_cast<int>(pulleys_.size()) - 1))];
    const Cord& cord = coupling.cord(id).direct();
    double rest = 0.0;
    for (int link = 0; link + 1 < cord.size(); ++link) rest += cord.rest_length(link);
    const double arc = dice_.within(0.05, 0.95) * rest;
    try {
      switch (dice_.whole(0, 9)) {
        case 0: coupling.cord(id).cut(arc); break;
        case 1:
        case 2: coupling.pulley(pulley).set_motor(dice_.within(-5.0, 5.0), dice_.log_within(1.0, 300.0)); break;
        case 3: {
          const auto point = static_cast<std::size_t>(arc / rest * (cord.size() - 1));
          b2Body& climber = add_body(cord.positions()[point], dice_.within(1.0, 10.0), b2_dynamicBody, 0.1, false);
          const auto grip = coupling.hold(climber, {.cord = id, .arc = arc});
          coupling.grip(grip).climb(dice_.within(0.0, rest), dice_.within(0.2, 2.0));
          break;
        }
        case 4: coupling.pulley(pulley).remove(); break;
        case 5: tie(id, ids); break;
        default: break;
      }
    } catch (const ribbon::CallError&) {  // the pulley is gone, or the place is on a wheel
    }
  }

  /// Ties the ends of two cords that are near each other.
  void tie(CordId id, const std::vector<CordId>& ids) {
    const CordId other = ids[static_cast<std::size_t>(dice_.whole(0, static_cast<int>(ids.size()) - 1))];
    const int point = dice_.whole(0, coupling.cord(id).direct().size() - 1);
    const Vec2 x = coupling.cord(id).positions()[static_cast<std::size_t>(point)];
    if (length(x - coupling.cord(other).positions()[0]) < 0.5) coupling.tie({id, point, other, 0});
  }

  Dice dice_;
  Accuracy accuracy_;
  std::optional<ribbon::Weather> weather_;
  std::vector<PulleyDef> wheels_;
  std::vector<PulleyId> pulleys_;
  CordId cord_ = 0;
  double width_ = 0.0;
};

class PulleysInRandomScenes : public testing::TestWithParam<int> {};

TEST_P(PulleysInRandomScenes, StayBounded) {
  const std::vector<Accuracy> presets{Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()};
  int unconverged = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    Machine machine(static_cast<unsigned>(seed), presets[static_cast<std::size_t>(GetParam())]);
    for (int number = 0; number < ticks; ++number) {
      machine.tick(number);
      ASSERT_LT(machine.highest_speed(), 300.0) << seed << ", tick " << number;
    }
    EXPECT_LT(machine.strain(), 0.01) << seed;
    unconverged += machine.unconverged;
  }
  EXPECT_LT(unconverged, seeds * ticks / 10);  // mostly where a block meets the wheel above it
}

INSTANTIATE_TEST_SUITE_P(Presets, PulleysInRandomScenes, testing::Values(0, 1, 2));

}  // namespace
