#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "engine/tick/workers.h"
#include "tests/bits/bit_scenes.h"

// The bits do not depend on the number of workers, nor on the order of their tasks.

namespace bits {
namespace {

constexpr int ticks = 40;

/// Enough cords for parallel gathering, some of them in contact with each other, and falling balls: many islands, some
/// of them large.
void build(BitWorld& made) {
  for (int k = 0; k < 160; ++k) {
    ribbon::CordDef def;
    def.points = 21;
    def.length = 1.0;
    def.radius = 0.02;
    def.cord_contact = k % 8 < 2;
    def.allow_sleep = k % 3 == 0;
    for (int p = 0; p < def.points; ++p) def.positions.push_back({0.75 * k + 0.05 * p, 0.1 * (k % 7)});
    def.pins = {0};
    made.coupling.add(ribbon::Cord(def));
  }
  for (int k = 0; k < 120; ++k) {
    b2BodyDef def;
    def.type = k % 5 == 0 ? b2_staticBody : b2_dynamicBody;
    def.position.Set(0.5F * static_cast<float>(k), k % 5 == 0 ? -0.75F : 1.0F + 0.125F * static_cast<float>(k % 3));
    b2CircleShape circle;
    circle.m_radius = 0.1F;
    made.world.CreateBody(&def)->CreateFixture(&circle, 5.0F);
  }
}

std::vector<std::uint64_t> hashes(const ribbon::ParallelFor& parallel_for) {
  BitWorld made;
  build(made);
  made.coupling.use(parallel_for);
  std::vector<std::uint64_t> found;
  for (int k = 0; k < ticks; ++k) {
    made.coupling.tick(made.world, dt);
    found.push_back(hash_of(made.coupling, made.world));
  }
  return found;
}

/// Runs tasks in an order shuffled by a seed, each in the next one of several threads.
struct Shuffled {
  static void run(void* context, int count, ribbon::ParallelFor::Task task, void* things) {
    auto& self = *static_cast<Shuffled*>(context);
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), self.random);
    ++self.calls;
    self.most = std::max(self.most, count);
    std::vector<std::thread> threads;
    for (int t = 0; t < self.threads; ++t) {
      threads.emplace_back([&, t] {
        for (int k = t; k < count; k += self.threads) task(things, order[static_cast<std::size_t>(k)]);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  int threads;
  std::mt19937 random;
  int calls = 0;
  int most = 0;
};

TEST(SameBitsWorkers, WithAnyNumberOfWorkers) {
  const std::vector<std::uint64_t> alone = hashes({});
  for (const int count : {1, 2, 3, 8}) {
    engine::Workers workers(count);
    EXPECT_EQ(hashes(workers.parallel_for()), alone) << count << " workers";
  }
}

TEST(SameBitsWorkers, InAnyOrderOfTasks) {
  const std::vector<std::uint64_t> alone = hashes({});
  for (const int threads : {1, 2, 5}) {
    Shuffled shuffled{threads, std::mt19937(static_cast<unsigned>(threads))};
    EXPECT_EQ(hashes({Shuffled::run, &shuffled, 8}), alone) << threads << " threads";
    EXPECT_GT(shuffled.calls, ticks);
    EXPECT_GT(shuffled.most, 3);
  }
}

}  // namespace
}  // namespace bits
