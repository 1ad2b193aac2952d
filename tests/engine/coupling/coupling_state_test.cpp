#include "ribbon/box2d/coupling_state.h"

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"

// What Coupling::restore refuses, and how it treats bodies that are created or destroyed. That a restored coupling
// continues with the same bits is tested in tests/bits/restore_test.cpp.

namespace engine {
namespace {

using ribbon::Cord;
using ribbon::CordDef;
using ribbon::DefinitionError;
using State = ribbon::box2d::Coupling::State;

using constants::dt;
using constants::nan;

/// A rope of the direct solver with a holder at its end and a ball on its middle, and one of the thesis's.
struct Scene {
  Scene() {
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.pins = {0, 20};
    coupling.add(Cord(def));
    ribbon::ThesisDef thesis;
    thesis.pins = {0, 1};
    coupling.add(ribbon::ThesisCord(thesis));
    holder = &add_circle({1.0F, -0.2F}, 0.1F);
    ball = &add_circle({0.8F, 0.12F}, 0.1F);
    grip = coupling.hold(*holder, {.cord = 0, .arc = 1.23, .local_anchor = {0.2F, 0.2F}});
  }
  b2Body& add_circle(b2Vec2 position, float radius) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = position;
    b2CircleShape circle;
    circle.m_radius = radius;
    b2Body* body = world.CreateBody(&definition);
    body->CreateFixture(&circle, 10.0F);
    return *body;
  }
  void tick(int times = 1) {
    for (int k = 0; k < times; ++k) {
      coupling.tick(world, dt);
    }
  }

  b2World world{b2Vec2(0.0F, -9.81F)};
  ribbon::box2d::Coupling coupling;
  b2Body* holder;
  b2Body* ball;
  ribbon::box2d::GripId grip;
};

std::uint64_t state_hash_of(const State& state) {
  ribbon::box2d::Hasher hasher;
  ribbon::box2d::add_to(hasher, state);
  return hasher.value();
}

/// Returns the message with which restore refuses a changed state; fails if restore changes anything.
std::string refusal(Scene& scene, const std::function<void(State&)>& spoil) {
  const State before = scene.coupling.save(scene.world);
  State state = before;
  spoil(state);
  EXPECT_NE(state_hash_of(state), state_hash_of(before)) << "the hash sees it";
  try {
    scene.coupling.restore(state, scene.world);
  } catch (const DefinitionError& error) {
    EXPECT_EQ(state_hash_of(scene.coupling.save(scene.world)), state_hash_of(before)) << error.what();
    return error.what();
  }
  return "accepted";
}

TEST(CouplingState, OfOtherCordsIsRefused) {
  Scene scene;
  scene.tick(20);
  EXPECT_EQ(refusal(scene, [](State& s) { std::swap(s.cords[0].state, s.cords[1].state); }),
            "state of cord 0 is of another solver; accepted is direct");
  EXPECT_EQ(refusal(scene, [](State& s) { s.cords[1].id = 7; }), "state.cords.id is 7; accepted is 0 to 1");
  EXPECT_EQ(refusal(scene,
                    [](State& s) {
                      s.cords[1].id = 7;
                      s.next_cord = 8;
                    }),
            "state has cord 7, which the coupling does not have; accepted is a state of the same cords or with their "
            "definitions");
  EXPECT_EQ(refusal(scene, [](State& s) { std::swap(s.cords[0], s.cords[1]); }),
            "state.cords.id are out of order, or some are there twice; accepted are rising numbers");
  EXPECT_NE(refusal(scene, [](State& s) { std::get<Cord::State>(s.cords[0].state).rest.pop_back(); })
                .find("state is of another cord"),
            std::string::npos);
  EXPECT_NE(refusal(scene, [](State& s) { std::get<ribbon::ThesisCord::State>(s.cords[1].state).positions[3].x = nan; })
                .find("accepted are coordinates"),
            std::string::npos);
  EXPECT_NE(refusal(scene,
                    [](State& s) {
                      std::get<ribbon::ThesisCord::State>(s.cords[1].state).kinds[3] =
                          static_cast<ribbon::PointKind>(77);
                    })
                .find("state.kinds is 77"),
            std::string::npos);
}

TEST(CouplingState, OfAnotherWorldIsRefused) {
  Scene scene;
  scene.tick(20);
  const State state = scene.coupling.save(scene.world);
  EXPECT_EQ(state.bodies, 2);
  scene.add_circle({9.0F, 9.0F}, 0.1F);
  EXPECT_THROW(scene.coupling.restore(state, scene.world), DefinitionError);
  b2World empty{b2Vec2(0.0F, 0.0F)};
  EXPECT_THROW(scene.coupling.restore(state, empty), DefinitionError);
}

TEST(CouplingState, InvalidNumbersAreRefused) {
  Scene scene;
  scene.tick(20);
  const State state = scene.coupling.save(scene.world);
  ASSERT_EQ(state.grips.size(), 1U);
  ASSERT_EQ(state.carries.size(), 2U);
  ASSERT_EQ(state.fixtures.size(), 2U);
  ASSERT_EQ(state.cords[0].touching.size(), 1U);
  const std::vector<std::pair<const char*, std::function<void(State&)>>> spoilt = {
      {"state.grips.body", [](State& s) { s.grips[0].body = 2; }},
      {"state.grips.body", [](State& s) { s.grips[0].body = -1; }},
      {"state.grips.cord", [](State& s) { s.grips[0].memory.cord = 2; }},
      {"state.grips.cord is 0; accepted is the id of an enabled cord", [](State& s) { s.cords[0].enabled = false; }},
      {"state.grips.point", [](State& s) { s.grips[0].memory.point = 21; }},
      {"state.grips.point", [](State& s) { s.grips[0].memory.point = -1; }},
      {"state.grips.along", [](State& s) { s.grips[0].memory.along = 1.5; }},
      {"state.grips.along", [](State& s) { s.grips[0].memory.point = 20; }},
      {"state.grips.along", [](State& s) { s.grips[0].memory.cord = 1; }},
      {"state.grips.strength", [](State& s) { s.grips[0].memory.strength = nan; }},
      {"state.grips.most_pull", [](State& s) { s.grips[0].memory.most_pull = -1.0; }},
      {"state.grips.climb_to", [](State& s) { s.grips[0].memory.climb_to = 21.0; }},
      {"state.grips.climb_speed", [](State& s) { s.grips[0].memory.climb_speed = -1.0; }},
      {"state.grips.local_anchor", [](State& s) { s.grips[0].memory.local_anchor.x = 2e9F; }},
      {"state.grips.next_anchor", [](State& s) { s.grips[0].memory.next_anchor.y = static_cast<float>(nan); }},
      {"state.grips.pull", [](State& s) { s.grips[0].memory.pull.x = nan; }},
      {"state.grips.id", [](State& s) { s.grips[0].memory.id = s.next_grip; }},
      {"state.grips.id", [](State& s) { s.grips.push_back(s.grips[0]); }},
      {"state.next_grip", [](State& s) { s.next_grip = 0; }},
      {"state.carries.body", [](State& s) { s.carries[1].body = 2; }},
      {"state.carries.body", [](State& s) { std::swap(s.carries[0], s.carries[1]); }},
      {"state.carries", [](State& s) { s.carries[0].memory.expected_delta_v.x = nan; }},
      {"state.carries", [](State& s) { s.carries[0].memory.support_delta_v.y = nan; }},
      {"state.carries.carry", [](State& s) { s.carries[0].memory.carry.y = 2e9; }},
      {"state.carries.angular_carry", [](State& s) { s.carries[0].memory.angular_carry = 2e9; }},
      {"state.carries.angular_carry", [](State& s) { s.carries[0].memory.angular_carry = nan; }},
      {"state.carries.angular_velocity", [](State& s) { s.carries[0].memory.angular_velocity = nan; }},
      {"state.carries.dt", [](State& s) { s.carries[0].memory.dt = -1.0; }},
      {"state.fixtures.body", [](State& s) { s.fixtures[0].body = 2; }},
      {"state.fixtures.place", [](State& s) { s.fixtures[0].place = 1; }},
      {"state.fixtures.place", [](State& s) { s.fixtures[0].body = s.fixtures[1].body; }},
      {"state.fixtures.id", [](State& s) { s.fixtures[1].id = s.next_fixture; }},
      {"state.fixtures are", [](State& s) { s.fixtures[1].id = s.fixtures[0].id; }},
      {"state.next_fixture", [](State& s) { s.next_fixture = std::uint64_t{1} << 60U; }},
      {"state.cords.touching are", [](State& s) { s.cords[0].touching.push_back(s.cords[0].touching[0]); }},
      {"state.cords.touching.fixture", [](State& s) { s.cords[0].touching[0].fixture = 0; }},
      {"state.cords.touching.impulse", [](State& s) { s.cords[0].touching[0].impulse = nan; }},
      {"state.cords.touching.most", [](State& s) { s.cords[0].touching[0].most = nan; }},
      {"state.cords.touching", [](State& s) { s.cords[0].touching[0].normal.y = nan; }},
      {"state.cords.error", [](State& s) { s.cords[0].error = nan; }},
      {"state.next_cord", [](State& s) { s.next_cord = -1; }},
      {"state.cords.id", [](State& s) { s.next_cord = 1; }},
      {"state.ending.cord",
       [](State& s) {
         s.ending.push_back({2, s.cords[0].touching[0]});
       }},
      {"state.ending.touch.fixture",
       [](State& s) {
         s.ending.push_back({0, {0, 0.0, 0.0, {}, {}}});
       }},
      {"state.ending are",
       [](State& s) {
         s.ending.push_back({0, s.cords[0].touching[0]});
         s.ending.push_back(s.ending[0]);
       }},
      {"state.events.cord",
       [](State& s) {
         s.events.push_back({7, true, 0, 0.0, {}, {}});
       }},
      {"state.events.fixture",
       [](State& s) {
         s.events.push_back({0, true, 99, 0.0, {}, {}});
       }},
      {"state.events.impulse",
       [](State& s) {
         s.events.push_back({0, true, 0, nan, {}, {}});
       }},
      {"state.events",
       [](State& s) {
         s.events.push_back({0, true, 0, 0.0, {nan, 0.0}, {}});
       }},
  };
  for (const auto& [field, spoil] : spoilt) {
    EXPECT_EQ(refusal(scene, spoil).rfind(field, 0), 0U) << field << " and not: " << refusal(scene, spoil);
  }
}

/// While the world is inside its Step, a callback cannot restore.
TEST(CouplingState, ALockedWorldIsRefused) {
  Scene scene;
  scene.tick(20);
  struct Listener : b2ContactListener {
    void BeginContact(b2Contact*) override {
      try {
        scene->coupling.restore(scene->coupling.save(scene->world), scene->world);
      } catch (const ribbon::CallError&) {
        ++refused;
      }
    }
    Scene* scene = nullptr;
    int refused = 0;
  };
  Listener listener;
  listener.scene = &scene;
  scene.world.SetContactListener(&listener);
  scene.add_circle({0.8F, 0.15F}, 0.1F);
  scene.tick(2);
  EXPECT_GT(listener.refused, 0);
}

/// The grip of a body that was destroyed without a call of the coupling is not saved.
TEST(CouplingState, LeavesOutBodiesThatAreNoLongerInTheWorld) {
  Scene scene;
  scene.tick(20);
  scene.world.DestroyBody(scene.holder);
  const State state = scene.coupling.save(scene.world);
  EXPECT_EQ(state.grips.size(), 0U);
  ASSERT_EQ(state.carries.size(), 1U);
  EXPECT_EQ(state.carries[0].body, 0) << "the ball is the first of those that are there";
  scene.coupling.restore(state, scene.world);
  EXPECT_FALSE(scene.coupling.grip(scene.grip).is_valid());
  scene.tick(5);
}

/// The events of a tick are restored with it, and so is the number of the next grip.
TEST(CouplingState, EventsAndReportsAreRestoredToo) {
  Scene scene;
  const State start = scene.coupling.save(scene.world);
  State touched;
  for (int k = 0; k < 60 && touched.events.empty(); ++k) {
    scene.tick();
    touched = scene.coupling.save(scene.world);
  }
  ASSERT_EQ(scene.coupling.last_step().touch_events().size(), 1U);
  const b2Fixture* fixture = scene.coupling.last_step().touch_events()[0].fixture;
  EXPECT_EQ(fixture, scene.ball->GetFixtureList());
  const ribbon::IslandReport total = scene.coupling.cord(0).island_total();
  scene.coupling.restore(start, scene.world);
  EXPECT_TRUE(scene.coupling.last_step().touch_events().empty());
  EXPECT_EQ(scene.coupling.cord(0).island_total().stages, 0);
  EXPECT_EQ(scene.coupling.hold(*scene.ball, {.cord = 0, .arc = 0.5}), 2);
  scene.coupling.restore(touched, scene.world);
  ASSERT_EQ(scene.coupling.last_step().touch_events().size(), 1U);
  EXPECT_EQ(scene.coupling.last_step().touch_events()[0].fixture, fixture);
  EXPECT_EQ(scene.coupling.cord(0).island_total(), total);
  EXPECT_FALSE(scene.coupling.grip(2).is_valid());
}

/// Whatever the object held before: nothing, fewer or more grips, contacts and cords, or the state of another coupling.
TEST(CouplingState, SavedIntoAnObjectIsTheSame) {
  State into;
  Scene other;
  other.coupling.hold(*other.ball, {.cord = 0, .arc = 0.5});
  other.tick(10);
  Scene scene;
  const auto check = [&into](const Scene& of) {
    of.coupling.save(of.world, into);
    EXPECT_TRUE(into == of.coupling.save(of.world));
  };
  check(scene);
  check(other);
  for (int k = 0; k < 30; ++k) {
    check(scene);
    scene.tick();
  }
  scene.coupling.cut({0.5, -9.0}, {0.5, 9.0});
  check(scene);
  scene.tick();
  check(scene);
  scene.coupling.remove(1);
  check(scene);
  scene.world.DestroyBody(scene.holder);
  check(scene);
}

TEST(CouplingState, IsSavedAndRestoredWithoutAllocations) {
  Scene scene;
  scene.tick(20);
  State state;
  scene.coupling.save(scene.world, state);
  scene.tick(5);
  scene.coupling.restore(state, scene.world);
  const test_support::AllocationCount count;
  for (int k = 0; k < 5; ++k) {
    scene.coupling.save(scene.world, state);
    scene.coupling.restore(state, scene.world);
  }
  EXPECT_EQ(count.so_far(), 0);
}

/// Places are those in the order of creation, also of bodies and fixtures among many others, and grips are by id.
TEST(CouplingState, FindsItsBodiesAndFixturesAmongMany) {
  Scene scene;
  std::vector<b2Body*> many;
  for (int k = 0; k < 500; ++k) many.push_back(&scene.add_circle({100.0F + static_cast<float>(k), 0.0F}, 0.1F));
  b2CircleShape circle;
  circle.m_radius = 0.05F;
  for (int k = 0; k < 3; ++k) {
    circle.m_p.Set(0.05F * static_cast<float>(k), 0.0F);
    scene.ball->CreateFixture(&circle, 1.0F);
  }
  b2Body& late = scene.add_circle({0.3F, -0.2F}, 0.1F);
  scene.coupling.hold(late, {.cord = 0, .arc = 0.3});
  scene.coupling.hold(*many[7], {.cord = 0, .arc = 1.7});
  scene.coupling.hold(late, {.cord = 0, .arc = 0.4});
  scene.tick(5);
  const State state = scene.coupling.save(scene.world);
  ASSERT_EQ(state.grips.size(), 4U);
  const std::vector<int> bodies = {state.grips[0].body, state.grips[1].body, state.grips[2].body, state.grips[3].body};
  EXPECT_EQ(bodies, (std::vector{0, 502, 9, 502}));
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(state.grips[k].memory.id, static_cast<int>(k) + 1);
  std::vector<const b2Fixture*> before;
  for (const State::Fixture& fixture : state.fixtures) before.push_back(scene.coupling.fixture(fixture.id));
  ASSERT_GT(before.size(), 4U) << "those of the ball, among others";
  scene.tick(5);
  scene.coupling.restore(state, scene.world);
  EXPECT_TRUE(scene.coupling.save(scene.world) == state);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(scene.coupling.fixture(state.fixtures[k].id), before[k]) << k;
  }
}

}  // namespace
}  // namespace engine
