#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "engine/tick/tick.h"
#include "ribbon/box2d/state_hash.h"
#include "tests/bits/bit_scenes.h"
#include "tests/bits/golden_replays.h"

// Each golden replay has one hash, with any loop around it.

namespace bits {
namespace {

class SameBitsReplay : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Golden, SameBitsReplay, testing::ValuesIn(golden_replays()), name_of_replay);

/// Returns the final hash, or why the replay does not verify.
std::string played(const GoldenRun& run) {
  game::Simulation simulation(run.level);
  engine::ReplayVerifier verifier(run.replay);
  while (!verifier.done()) {
    simulation.tick(verifier.input());
    verifier.check(simulation.hash());
  }
  return verifier.result().message();
}

std::string wanted(const GoldenRun& run) {
  return "verified " + std::to_string(run.replay.ticks.size()) + " ticks, hash " +
         ribbon::box2d::to_hex(run.replay.ticks.back().state.combined());
}

TEST_P(SameBitsReplay, RepeatedlyAndInThreads) {
  const GoldenRun run(GetParam());
  EXPECT_EQ(played(run), wanted(run));
  for (const std::size_t threads : {1U, 2U, 4U}) {
    std::vector<std::string> found(threads);
    std::vector<std::thread> running;
    for (std::string& result : found) running.emplace_back([&result, &run] { result = played(run); });
    for (std::thread& thread : running) thread.join();
    for (const std::string& result : found) EXPECT_EQ(result, wanted(run));
  }
}

/// Runs the game's loop at a frame rate, with drawing between ticks, and compares each tick with the recorded one.
std::string played_at(const GoldenRun& run, std::int64_t frames_per_second) {
  constexpr std::int64_t second = 1'000'000'000;  // ns
  game::Simulation simulation(run.level);
  engine::ReplayVerifier verifier(run.replay);
  engine::FixedTick clock(game::ticks_per_second);
  for (std::int64_t frame = 0; !verifier.done(); ++frame) {
    int due = clock.advance((frame + 1) * second / frames_per_second - frame * second / frames_per_second);
    for (; due > 0 && !verifier.done(); --due) {
      simulation.tick(verifier.input());
      verifier.check(simulation.hash());
    }
    interpolate(simulation.previous(), simulation.current(), clock.alpha());
  }
  return verifier.result().message();
}

TEST_P(SameBitsReplay, At20And60And144FramesASecond) {
  const GoldenRun run(GetParam());
  for (const int rate : {20, 60, 144}) EXPECT_EQ(played_at(run, rate), wanted(run)) << rate << " frames a second";
}

/// One hash of everything, in a few seconds: tests/bits/build compares builds by this line.
TEST(SameBitsAll, ScenesAndReplaysHaveOneHash) {
  ribbon::box2d::Hasher all;
  for (const BitScene& scene : bit_scenes()) {
    const std::uint64_t hash = hash_of_run(scene);
    EXPECT_EQ(ribbon::box2d::to_hex(hash), ribbon::box2d::to_hex(scene.golden)) << scene.name;
    all.add(hash);
  }
  for (const std::string& path : golden_replays()) {
    const GoldenRun run(path);
    EXPECT_EQ(played(run), wanted(run));
    for (const engine::RecordedTick& recorded : run.replay.ticks) all.add(recorded.state.combined());
  }
  std::printf("hash of everything: %s\n", ribbon::box2d::to_hex(all.value()).c_str());
}

}  // namespace
}  // namespace bits
