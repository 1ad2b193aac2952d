#include <box2d/box2d.h>

#include <algorithm>
#include <memory>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

using ribbon::Vec2;
using test_support::earth_gravity;
using test_support::frame_dt;

constexpr int lamps_count = 100;
constexpr int ticks_of_lamps = 120;
constexpr int ticks_to_rest = 1200;

/// Lamps of 1 kg on ropes of 2 m, one metre apart, at rest after a small initial push.
struct Lamps {
  explicit Lamps(bool may_sleep) {
    for (int k = 0; k < lamps_count; ++k) add_lamp(static_cast<double>(k), may_sleep);
    for (int k = 0; k < ticks_to_rest; ++k) tick();
  }

  void add_lamp(double x, bool may_sleep) {
    ribbon::CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.02;
    def.drag = 1.0;
    def.allow_sleep = may_sleep;
    for (int p = 0; p < def.points; ++p) def.positions.push_back({x, -0.1 * p});
    def.pins = {0};
    const ribbon::box2d::CordId cord = coupling.add(ribbon::Cord(def));
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.position = ribbon::box2d::to_float(Vec2{x, -2.1});
    body.linearDamping = 1.0F;
    body.angularDamping = 5.0F;
    b2CircleShape circle;
    circle.m_radius = 0.1F;
    b2Body* lamp = world.CreateBody(&body);
    lamp->CreateFixture(&circle, 31.8F);
    lamp->ApplyLinearImpulseToCenter({0.2F, 0.0F}, true);
    coupling.hold(cord, def.points - 1, *lamp, {0.0F, 0.1F});
  }

  void tick() { coupling.tick(world, frame_dt); }

  b2World world{ribbon::box2d::to_float(earth_gravity)};
  ribbon::box2d::Coupling coupling;
};

double iterations(const ribbon::box2d::Coupling& coupling) {
  double sum = 0.0;
  for (int c = 0; c < coupling.size(); ++c) sum += coupling.cord(c).island_report().iterations;
  return sum / coupling.size();
}

/// Returns the largest distance between the same points of both, m.
double max_distance(const ribbon::box2d::Coupling& a, const ribbon::box2d::Coupling& b) {
  double most = 0.0;
  for (int c = 0; c < a.size(); ++c) {
    for (std::size_t p = 0; p < a.cord(c).positions().size(); ++p) {
      most = std::max(most, length(a.cord(c).positions()[p] - b.cord(c).positions()[p]));
    }
  }
  return most;
}

std::vector<Variant> lamps() {
  const auto awake = std::make_shared<Lamps>(false);
  std::vector<Variant> list;
  for (const bool may_sleep : {false, true}) {
    const auto hung = may_sleep ? std::make_shared<Lamps>(true) : awake;
    list.push_back(
        {"coupling",
         may_sleep ? "asleep" : "awake",
         lamps_count * 21,
         [] {},
         [hung] { hung->tick(); },
         [hung, awake] {
           hung->tick();
           return std::vector{iterations(hung->coupling), 1e3 * max_distance(hung->coupling, awake->coupling)};
         },
         {},
         {},
         [hung] { return hung->coupling.last_step().report().work; }});
  }
  return list;
}

}  // namespace

std::vector<Scene> lamp_scenes() {
  return {{"lamps",
           "100 lamps that hang on ropes at rest: their cost awake and asleep, and the displacement by sleep",
           ticks_of_lamps,
           lamps,
           {us_per_tick(), p99_us(), figure("iterations_per_tick", 0), figure("difference_from_awake_mm", 1)}}};
}

}  // namespace tradeoff
