#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "ribbon/box2d/state_hash.h"
#include "tests/bits/bit_scenes.h"

// The bits of every scene are the same with any compiler and machine, in repeated runs, and in threads.

namespace bits {
namespace {

class SameBits : public testing::TestWithParam<BitScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, SameBits, testing::ValuesIn(bit_scenes().begin(), bit_scenes().end()),
                         [](const auto& scene) { return std::string(scene.param.name); });

/// A change of a method changes these. Once the change is understood, copy what the test prints.
TEST_P(SameBits, OnEveryCompilerAndMachine) {
  EXPECT_EQ("0x" + ribbon::box2d::to_hex(hash_of_run(GetParam())), "0x" + ribbon::box2d::to_hex(GetParam().golden));
}

/// Each of several threads runs all scenes, starting with a different one, so that equal and different scenes run at
/// the same time.
TEST(SameBitsThreads, OfAnyNumberOfThreads) {
  const std::size_t count = bit_scenes().size();
  for (const std::size_t threads : {2U, 3U}) {
    std::vector<std::vector<std::uint64_t>> found(threads, std::vector<std::uint64_t>(count));
    std::vector<std::thread> running;
    for (std::size_t t = 0; t < threads; ++t) {
      running.emplace_back([&found, t, count] {
        for (std::size_t k = 0; k < count; ++k) found[t][(t + k) % count] = hash_of_run(bit_scenes()[(t + k) % count]);
      });
    }
    for (std::thread& thread : running) thread.join();
    for (std::size_t t = 0; t < threads; ++t) {
      for (std::size_t k = 0; k < count; ++k) {
        EXPECT_EQ(ribbon::box2d::to_hex(found[t][k]), ribbon::box2d::to_hex(bit_scenes()[k].golden))
            << bit_scenes()[k].name << " in thread " << t << " of " << threads;
      }
    }
  }
}

/// The golden hashes cover only what the scenes use.
TEST(BitScenes, CoverEveryPathThroughTheSolvers) {
  ribbon::IslandReport direct;
  ribbon::StepReport thesis;
  std::size_t begun = 0;
  std::size_t sensed = 0;
  std::size_t slipped = 0;
  std::size_t slept = 0;
  std::size_t woken = 0;
  std::size_t off = 0;
  std::size_t cuts = 0;
  for (const BitScene& scene : bit_scenes()) {
    BitWorld world;
    scene.build(world);
    std::vector<bool> was_asleep;
    for (int k = 0; k < scene.ticks; ++k) {
      tick(scene, world, k);
      for (const ribbon::box2d::CordId c : world.coupling.cords()) {
        was_asleep.resize(std::max(was_asleep.size(), static_cast<std::size_t>(c) + 1));
        off += world.coupling.cord(c).is_enabled() ? 0U : 1U;
        if (world.coupling.cord(c).solver() != ribbon::box2d::Solver::direct) continue;
        const bool is_asleep = world.coupling.cord(c).direct().is_asleep();
        slept += is_asleep ? 1U : 0U;
        woken += was_asleep[static_cast<std::size_t>(c)] && !is_asleep ? 1U : 0U;
        was_asleep[static_cast<std::size_t>(c)] = is_asleep;
      }
      begun += world.coupling.last_step().touch_events().size();
      cuts += world.coupling.last_step().cut_events().size();
      sensed += world.coupling.last_step().sensor_events().size();
      for (int grip = 1; grip < 20; ++grip) {
        const auto held = world.coupling.grip(grip);
        slipped += held.is_valid() && held.state().slips ? 1U : 0U;
      }
    }
    for (const ribbon::box2d::CordId c : world.coupling.cords()) {
      direct += world.coupling.cord(c).island_total();
      thesis += world.coupling.cord(c).thesis_total();
    }
  }
  EXPECT_GT(direct.searches, 0);
  EXPECT_GT(direct.fallbacks, 0);
  EXPECT_GT(direct.energy_gains, 0);
  EXPECT_GT(direct.halvings, 0);
  EXPECT_GT(direct.impacts, 0);
  EXPECT_GT(direct.unlocked, 0);
  EXPECT_GT(thesis.motion_limited, 0);
  EXPECT_GT(thesis.self_contacts, 0);
  EXPECT_GT(thesis.circle_contacts, 0);
  EXPECT_GT(begun, 20U);
  EXPECT_GT(sensed, 4U);
  EXPECT_GT(slipped, 0U);
  EXPECT_GT(slept, 60U);
  EXPECT_GT(woken, 1U);
  EXPECT_GT(off, 0U);
  EXPECT_GT(cuts, 5U);
}

}  // namespace
}  // namespace bits
