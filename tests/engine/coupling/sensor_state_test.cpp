#include <gtest/gtest.h>

#include <functional>
#include <tuple>
#include <vector>

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/thesis/thesis_cord.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/engine/coupling/sensor_world.h"
#include "tests/support/allocations.h"

// Overlaps of cords with sensors in the state of a coupling.

namespace engine {
namespace {

using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using ribbon::box2d::SensorEvent;

/// A state restores overlaps, events and what is about to end: nothing is told twice or not at all.
TEST(Sensors, AreSavedAndRestored) {
  for (const int ticks : {22, 23, 24, 26, 30, 31, 32}) {
    for (const bool removes : {false, true}) {
      SensorWorld scene;
      scene.add_box({0.0, -1.0}, 0.3F);
      const CordId rope = scene.add_rope(0.0, 0.0);
      scene.add_rope(0.1, 0.3);
      scene.run(ticks);
      if (removes) scene.coupling.remove(rope);
      const Coupling::State state = scene.coupling.save(scene.world);
      const std::vector<SensorEvent> events(scene.coupling.last_step().sensor_events().begin(),
                                            scene.coupling.last_step().sensor_events().end());
      const std::vector<Seen> first = scene.run(15);
      const auto hash = [&] {
        ribbon::box2d::Hasher hasher;
        add_to(hasher, scene.coupling.save(scene.world));
        return hasher.value();
      };
      const auto end = hash();
      scene.coupling.restore(state, scene.world);
      EXPECT_EQ(scene.coupling.save(scene.world), state);
      const auto restored = scene.coupling.last_step().sensor_events();
      ASSERT_EQ(restored.size(), events.size());
      for (std::size_t k = 0; k < events.size(); ++k) {
        EXPECT_EQ(std::tie(restored[k].cord, restored[k].begins, restored[k].fixture, restored[k].number),
                  std::tie(events[k].cord, events[k].begins, events[k].fixture, events[k].number));
      }
      EXPECT_EQ(scene.run(15), first) << ticks << " " << removes;
      EXPECT_EQ(hash(), end) << ticks << " " << removes;
    }
  }
}

/// An overlap is part of the hash, and a state with a wrong one is refused.
TEST(Sensors, AreHashedAndChecked) {
  SensorWorld scene;
  scene.add_box({0.0, 0.0}, 0.3F);
  const CordId rope = scene.add_rope(0.0, 0.0, {}, true);
  scene.run(1);
  const Coupling::State state = scene.coupling.save(scene.world);
  const auto hash = [](const Coupling::State& of) {
    ribbon::box2d::Hasher hasher;
    add_to(hasher, of);
    return hasher.value();
  };
  const std::vector<std::function<void(Coupling::State&)>> changes{
      [](Coupling::State& s) { s.cords[0].sensing.clear(); },
      [](Coupling::State& s) { s.sensor_events.clear(); },
      [](Coupling::State& s) {
        s.ending_sensors.push_back({0, false, 1});
      },
  };
  for (const auto& change : changes) {
    Coupling::State other = state;
    change(other);
    EXPECT_NE(hash(other), hash(state));
    EXPECT_FALSE(other == state);
    scene.coupling.restore(other, scene.world);
  }
  const std::vector<std::function<void(Coupling::State&)>> faults{
      [](Coupling::State& s) { s.cords[0].sensing.push_back(s.cords[0].sensing[0]); },
      [](Coupling::State& s) { s.cords[0].sensing = {s.next_fixture}; },
      [](Coupling::State& s) { s.sensor_events[0].cord = 7; },
      [](Coupling::State& s) { s.sensor_events[0].fixture = s.next_fixture; },
      [](Coupling::State& s) {
        s.ending_sensors = {{0, false, 0}};
      },
      [](Coupling::State& s) {
        s.ending_sensors = {{0, false, 1}, {0, false, 1}};
      },
  };
  for (const auto& fault : faults) {
    Coupling::State other = state;
    fault(other);
    EXPECT_THROW(scene.coupling.restore(other, scene.world), ribbon::DefinitionError);
  }
  scene.coupling.restore(state, scene.world);
  EXPECT_EQ(scene.coupling.cord(rope).sensors().size(), 1U);
}

TEST(Sensors, AllocateNothingInASteadyTick) {
  SensorWorld scene;
  scene.add_box({0.0, 0.0}, 0.3F);
  scene.add_box({0.2, 0.0}, 0.3F);
  scene.add_rope(0.0, 0.0, {}, true);
  b2Fixture* const passing = scene.add_box({0.0, 0.0}, 0.3F, b2_kinematicBody);
  const auto pass = [&](int k) {
    passing->GetBody()->SetTransform({0.0F, k % 2 == 0 ? 0.0F : 2.0F}, 0.0F);
    scene.tick();
    EXPECT_EQ(scene.coupling.last_step().sensor_events().size(), 1U);
  };
  scene.tick();
  for (int k = 1; k < 6; ++k) pass(k);
  const test_support::AllocationCount allocations;
  for (int k = 6; k < 30; ++k) pass(k);
  EXPECT_EQ(allocations.so_far(), 0);
}

}  // namespace
}  // namespace engine
