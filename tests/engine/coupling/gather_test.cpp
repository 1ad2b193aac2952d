#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/engine/coupling/gather_oracle.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"
#include "tests/support/shape_world.h"

// What Coupling::gather finds by the world's tree, compared with a search of all children of all fixtures.

namespace engine {
namespace {

using constants::dt;
using ribbon::Box;
using ribbon::CordDef;
using ribbon::Vec2;
using test_support::Dice;
using test_support::filter;

/// A world with random changes between ticks.
class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : dice_(seed) {
    const int cords = 1 + below(dice_.coin() ? 3 : 40);
    for (int k = 0; k < cords; ++k) add_cord();
    const int bodies = below(dice_.coin() ? 12 : 60);
    for (int k = 0; k < bodies; ++k) add_body();
    coupling.trust_forget(trusts_ = dice_.coin());
  }

  void disturb() {
    for (int k = below(6); k > 0; --k) disturb_one();
  }
  void tick() { coupling.tick(world, dt); }
  const b2Filter& filter(ribbon::box2d::CordId cord) const { return filters_[static_cast<std::size_t>(cord)]; }

  b2World world{b2Vec2(0.0F, -9.81F)};
  ribbon::box2d::Coupling coupling;

 private:
  int below(int n) { return std::min(n - 1, static_cast<int>(dice_() * n)); }
  Vec2 place() { return {dice_(-spread, spread), dice_(-spread, spread)}; }

  void add_cord() {
    CordDef def;
    def.points = 4 + below(8);
    def.length = dice_(0.5, 2.0);
    def.radius = 0.02;
    def.allow_sleep = dice_.coin();
    const Vec2 start = place();
    const double link = def.length / (def.points - 1);
    for (int p = 0; p < def.points; ++p) def.positions.push_back(start - Vec2{0.0, link * p});
    def.pins = {0};
    b2Filter filter;
    filter.maskBits = dice_.coin() ? 0xFFFF : 0x0001;
    coupling.add(ribbon::Cord(def), filter);
    filters_.push_back(filter);
  }
  void add_body() {
    b2BodyDef def;
    def.type = std::array{b2_staticBody, b2_kinematicBody, b2_dynamicBody}[static_cast<std::size_t>(below(3))];
    def.position = ribbon::box2d::to_float(place());
    def.angle = static_cast<float>(dice_(-3.0, 3.0));
    def.bullet = dice_.coin();
    b2Body* const body = world.CreateBody(&def);
    for (int k = 1 + below(2); k > 0; --k) add_fixture(*body);
    if (dice_.coin()) set_velocity(*body);
    bodies_.push_back(body);
  }
  void add_fixture(b2Body& body) {
    b2FixtureDef def;
    def.density = dice_() < 0.1 ? 0.0F : 1.0F;
    def.isSensor = dice_() < 0.1;
    def.filter.categoryBits = dice_.coin() ? 0x0001 : 0x0002;
    const b2CircleShape circle = test_support::circle(dice_(0.05, 0.5));
    const b2PolygonShape box = test_support::box(dice_(0.05, 0.8), dice_(0.05, 0.8));
    const b2EdgeShape edge = test_support::edge({-dice_(0.1, 3.0), 0.0}, {dice_(0.1, 3.0), dice_()});
    std::vector<b2Vec2> vertices;
    for (int k = 0; k < 12; ++k) vertices.push_back({static_cast<float>(0.4 * k), static_cast<float>(dice_(0.0, 0.3))});
    b2ChainShape chain;
    chain.CreateChain(vertices.data(), 12, vertices.front() - b2Vec2(1.0F, 0.0F), vertices.back() + b2Vec2(1.0F, 0.0F));
    const std::array<const b2Shape*, 4> shapes{&circle, &box, &edge, &chain};
    def.shape = shapes[static_cast<std::size_t>(below(4))];
    body.CreateFixture(&def);
  }
  void set_velocity(b2Body& body) {
    const double fast = dice_.coin() ? 3.0 : 200.0;
    body.SetLinearVelocity(ribbon::box2d::to_float(Vec2{dice_(-fast, fast), dice_(-fast, fast)}));
    if (dice_.coin()) body.SetAngularVelocity(static_cast<float>(dice_(-20.0, 20.0)));
  }
  void destroy(std::size_t k) {
    if (trusts_) {
      coupling.destroy(world, *bodies_[k]);
    } else {
      world.DestroyBody(bodies_[k]);
    }
    bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(k));
  }
  void disturb_one() {
    if (bodies_.empty()) {
      add_body();
      return;
    }
    const auto k = static_cast<std::size_t>(below(static_cast<int>(bodies_.size())));
    b2Body& body = *bodies_[k];
    switch (below(9)) {
      case 0: add_body(); break;
      case 1: destroy(k); break;
      case 2:
        destroy(k);
        add_body();  // often at the address of the last one
        break;
      case 3: body.SetTransform(ribbon::box2d::to_float(place()), static_cast<float>(dice_(-3.0, 3.0))); break;
      case 4: body.SetEnabled(!body.IsEnabled()); break;
      case 5: set_velocity(body); break;
      case 6: add_fixture(body); break;
      case 7: body.SetType(body.GetType() == b2_staticBody ? b2_dynamicBody : b2_staticBody); break;
      default:
        if (body.GetType() == b2_dynamicBody && body.GetMass() > 0.0F && body.IsEnabled() &&
            !coupling.body(body).held_place()) {
          const ribbon::box2d::CordId cord = below(coupling.size());
          coupling.hold(cord, coupling.cord(cord).shape().columns - 1, body, {0.0F, 0.0F});
        } else if (coupling.body(body).held_place()) {
          coupling.body(body).release();
        }
    }
  }

  static constexpr double spread = 6.0;  // m
  Dice dice_;
  bool trusts_ = false;
  std::vector<b2Filter> filters_;
  std::vector<b2Body*> bodies_;
};

void check_scenes(unsigned first, unsigned last) {
  std::size_t all = 0;
  for (unsigned seed = first; seed < last; ++seed) {
    RandomWorld random(seed);
    for (int k = 0; k < 3; ++k) {
      random.disturb();
      const gather_oracle::Speeds speeds = gather_oracle::speeds_in(random.world);
      random.coupling.gather(random.world, dt);
      for (ribbon::box2d::CordId c = 0; c < random.coupling.size(); ++c) {
        const gather_oracle::Found wanted = gather_oracle::by_looking_at_all(
            random.world, speeds, random.coupling.cord(c).swept_aabb(), random.filter(c), dt);
        ASSERT_EQ(gather_oracle::by_gather(random.coupling, c), wanted)
            << "seed " << seed << ", tick " << k << ", cord " << c;
        all += wanted.size();
      }
      random.tick();
    }
  }
  EXPECT_GT(all, 10U * (last - first));
}

TEST(Gather, FindsTheSameAsASearchOfAllFixtures) { check_scenes(0, 1000); }

TEST(LongGather, FindsTheSameAsASearchOfAllFixtures) { check_scenes(1000, 10'000); }

/// Cords that hang among boxes, with a given number of distant objects.
struct Clearing : test_support::ShapeWorld {
  Clearing() {
    for (int k = 0; k < 6; ++k) {
      CordDef def;
      def.points = 11;
      def.length = 1.0;
      def.radius = 0.02;
      def.friction = 0.3;
      def.cord_contact = true;
      def.positions = test_support::equally_spaced(def.points, {0.4 * k, 0.3 * k}, {0.1, 0.0});
      def.pins = {0};
      coupling.add(ribbon::Cord(def));
    }
    for (int k = 0; k < 5; ++k)
      test_support::add_shape(add_body({0.3 + 0.5 * k, -0.6}, b2_staticBody), box(), 0.0, 0.5);
  }
  void add_balls() {
    for (int k = 0; k < 4; ++k) add_ball({0.5 + 0.6 * k, 1.5 + 0.2 * k}, 0.1, 0.3);
  }
  void add_far_away(int count) {
    for (int k = 0; k < count; ++k) {
      b2Body* const body = add_body({500.0 + k % 100, 0.5 * k}, k % 3 == 0 ? b2_dynamicBody : b2_staticBody);
      test_support::add_shape(body, box(), 1.0, 0.5);
      if (k % 3 == 0) body->SetLinearVelocity({5.0F, 0.0F});
    }
  }
  static b2PolygonShape box() { return test_support::box(0.1, 0.1); }
};

/// Neither the search order nor the ids may depend on distant objects: they are created before, between and after the
/// near ones.
TEST(Gather, DistantObjectsChangeNoBitOfACord) {
  Clearing alone;
  alone.add_balls();
  Clearing among;
  among.add_far_away(5000);
  among.add_balls();
  among.add_far_away(5000);
  std::size_t touches = 0;
  for (int k = 0; k < 90; ++k) {
    alone.tick();
    among.tick();
    for (ribbon::box2d::CordId c = 0; c < alone.coupling.size(); ++c) {
      const auto a = alone.coupling.cord(c).positions();
      const auto b = among.coupling.cord(c).positions();
      ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << "tick " << k << ", cord " << c;
      touches += alone.coupling.cord(c).touching().size();
    }
  }
  EXPECT_GT(touches, 90U);
}

/// A body that holds the end of a rope.
struct Held : test_support::ShapeWorld {
  Held() {
    CordDef def;
    def.points = 5;
    def.length = 1.0;
    def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.25});
    def.pins = {0};
    coupling.add(ribbon::Cord(def));
    ball = add_ball({0.0, -1.1}, 0.1, 1.0);
    coupling.hold(0, 4, *ball, {0.0F, 0.1F});
  }
  b2Body* ball;
};

TEST(Gather, ReportedDestructionsAreTrusted) {
  Held held;
  held.coupling.trust_forget(true);
  held.tick(5);
  EXPECT_TRUE(held.coupling.body(*held.ball).held_place());
  EXPECT_LT(held.ball->GetLinearVelocity().Length(), 0.1F);
  held.coupling.destroy(held.world, *held.ball);
  b2Body* const next = held.add_ball({0.0, -1.1}, 0.1, 1.0);
  held.tick(5);
  EXPECT_FALSE(held.coupling.body(*next).held_place());
}

/// Of everything that a tick can begin with: bodies that hold cords, hit things, appear, move away and are destroyed.
TEST(Gather, ASecondCallReplacesTheFirst) {
  std::size_t ends = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomWorld once(seed);
    RandomWorld twice(seed);
    for (int tick = 0; tick < 30; ++tick) {
      if (tick % 3 == 2) {
        once.disturb();
        twice.disturb();
      }
      twice.coupling.gather(twice.world, dt);
      once.tick();
      twice.tick();
      ASSERT_TRUE(once.coupling.save(once.world) == twice.coupling.save(twice.world))
          << "seed " << seed << ", tick " << tick;
      const auto events = once.coupling.last_step().touch_events();
      const auto repeated = twice.coupling.last_step().touch_events();
      ASSERT_EQ(events.size(), repeated.size());
      for (std::size_t k = 0; k < events.size(); ++k) {
        ASSERT_EQ(events[k].number, repeated[k].number) << "seed " << seed << ", tick " << tick;
        if (!events[k].begins && events[k].fixture != nullptr) ++ends;
      }
    }
  }
  EXPECT_GT(ends, 40U) << "or few fixtures were left";
}

/// A body that is no longer solver-driven continues with its momentary velocity, wherever it is.
TEST(Gather, ABodyThatIsRemovedGetsItsVelocityCarry) {
  for (const bool trusts : {false, true}) {
    Held held;
    held.coupling.trust_forget(trusts);
    held.ball->SetLinearVelocity({3.0F, 0.0F});
    held.tick(10);
    const Vec2 momentary = held.coupling.body(*held.ball).velocity();
    ASSERT_GT(length(momentary - ribbon::box2d::to_double(held.ball->GetLinearVelocity())), 0.01);
    held.coupling.cord(0).set_enabled(false);
    EXPECT_LT(length(momentary - ribbon::box2d::to_double(held.ball->GetLinearVelocity())), 1e-5);
    EXPECT_EQ(held.coupling.body(*held.ball).velocity(), ribbon::box2d::to_double(held.ball->GetLinearVelocity()));
  }
}

/// A cord that is moved while it sleeps searches its new surroundings.
TEST(Gather, ASleepingCordThatIsMovedFindsItsNewSurroundings) {
  const auto hanging = [](double x) {
    CordDef def;
    def.points = 5;
    def.length = 1.0;
    def.radius = 0.02;
    def.drag = 1.0;
    def.allow_sleep = true;
    def.positions = test_support::equally_spaced(def.points, {x, 0.0}, {0.0, -0.25});
    def.pins = {0};
    return ribbon::Cord(def);
  };
  test_support::ShapeWorld here;
  here.coupling.add(hanging(0.0));
  test_support::ShapeWorld there;
  there.coupling.add(hanging(5.0));
  test_support::add_shape(here.add_body({5.3, -0.5}, b2_staticBody), test_support::box(0.2, 0.2), 0.0, 0.5);
  for (int k = 0; k < 600; ++k) {
    here.tick();
    there.tick();
  }
  ASSERT_TRUE(here.coupling.cord(0).direct().is_asleep() && there.coupling.cord(0).direct().is_asleep());
  ASSERT_EQ(here.coupling.cord(0).near_count(), 0);
  here.coupling.cord(0).direct().restore(there.coupling.cord(0).direct().save());
  ASSERT_TRUE(here.coupling.cord(0).direct().is_asleep());
  here.tick();
  EXPECT_NEAR(here.coupling.cord(0).swept_aabb().low.x, 5.0, 0.5);
  EXPECT_GT(here.coupling.cord(0).near_count(), 0);
}

TEST(Gather, FewerWorkersThanOneAreRefused) {
  ribbon::box2d::Coupling coupling;
  EXPECT_EQ(test_support::refusal<ribbon::DefinitionError>([&] {
              coupling.use({nullptr, nullptr, 0});
            }),
            "workers is 0; accepted is 1 or more");
}

#ifndef NDEBUG
TEST(GatherDeathTest, AParallelForThatSkipsATaskIsReported) {
  const auto run_all_but_one = [](void* /*context*/, int count, ribbon::ParallelFor::Task task, void* things) {
    for (int k = 1; k < count; ++k) task(things, k);
  };
  EXPECT_DEATH(
      {
        test_support::ShapeWorld world;
        for (int k = 0; k < 40; ++k) {
          CordDef def;
          def.points = 21;
          def.positions = test_support::equally_spaced(def.points, {2.0 * k, 0.0}, {0.0, -0.05});
          world.coupling.add(ribbon::Cord(def));
        }
        world.coupling.use({run_all_but_one, nullptr, 4});
        world.tick();
      },
      "once before it returned");
}
#endif

}  // namespace
}  // namespace engine
