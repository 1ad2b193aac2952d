#include "engine/tick/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "tests/support/allocations.h"
#include "tests/support/contact_scenes.h"

namespace engine {
namespace {

using test_support::CoupledWorld;

TEST(Workers, EachTaskRunsOnce) {
  for (const int count : {1, 2, 5}) {
    Workers workers(count);
    const ribbon::ParallelFor parallel_for = workers.parallel_for();
    for (const int things : {0, 1, 2, 100}) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(things));
      parallel_for.run(
          parallel_for.context, things,
          [](void* all, int k) { ++(*static_cast<std::vector<std::atomic<int>>*>(all))[static_cast<std::size_t>(k)]; },
          &done);
      EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](const std::atomic<int>& times) { return times == 1; }))
          << count << " workers, " << things << " things";
    }
  }
}

/// What a worker has worked on is in the cache of its core. Of four tasks the first and the third are the first ones of
/// the shares of two workers. Each of them waits for the other one, so that both workers take part.
TEST(Workers, EachBeginsWithItsOwnShare) {
  struct Call {
    std::array<std::atomic<bool>, 4> begun{};
    std::array<std::thread::id, 4> by;
    std::array<std::atomic<int>, 4> turn{};
    std::atomic<int> turns{0};
  };
  Workers workers(2);
  const ribbon::ParallelFor parallel_for = workers.parallel_for();
  for (int repeat = 0; repeat < 20; ++repeat) {
    Call call;
    const auto task = [](void* data, int k) {
      auto& [begun, by, turn, turns] = *static_cast<Call*>(data);
      const auto index = static_cast<std::size_t>(k);
      turn[index] = turns++;
      by[index] = std::this_thread::get_id();
      begun[index] = true;
      while (k % 2 == 0 && !begun[2 - index]) std::this_thread::yield();
    };
    parallel_for.run(parallel_for.context, 4, task, &call);
    EXPECT_EQ(call.by[0], std::this_thread::get_id());
    EXPECT_NE(call.by[2], std::this_thread::get_id());
    EXPECT_LT(std::max<int>(call.turn[0], call.turn[2]), std::min<int>(call.turn[1], call.turn[3]));
  }
}

/// Hanging cords, with balls at rest on half of them. There are enough of them for several workers.
TEST(Workers, ASteadyTickAllocatesNothing) {
  for (const int count : {2, 3}) {
    Workers workers(count);
    CoupledWorld world{test_support::CordMethod{}};
    test_support::hang_hall(world);
    world.coupling.use(workers.parallel_for());
    world.settle(300);
    int touched = 0;
    for (int tick = 0; tick < 60; ++tick) {
      const test_support::AllocationCount allocations;
      world.step_cords();
      ASSERT_EQ(allocations.so_far(), 0) << count << " workers, tick " << tick;
      world.step_world();
      for (int c = 0; c < world.cords(); ++c) touched += world.coupling.cord(c).direct().touches().empty() ? 0 : 1;
    }
    EXPECT_GT(touched, 600);
  }
}

}  // namespace
}  // namespace engine
