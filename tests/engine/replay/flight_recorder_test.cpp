#include "engine/replay/flight_recorder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "tests/support/allocations.h"
#include "tests/support/contact_scenes.h"

namespace engine {
namespace {

namespace fs = std::filesystem;

/// A folder of this test.
class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }

  std::string prefix() const { return path_ + "/"; }
  int files() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(path_)) count += entry.is_regular_file();
    return count;
  }

 private:
  std::string path_ = testing::TempDir() + "flight_recorder_" + std::to_string(getpid());
};

/// A moving ball on a rope.
struct Bridge {
  Bridge() : ball(test_support::hang_bridge(world, 10.0, 20)) {}

  test_support::CoupledWorld world{{}};
  b2Body& ball;
};

TEST(FlightRecorder, WritesExactlyTheTicksOfWhichAConditionHolds) {
  const Folder folder;
  Bridge bridge;
  FlightConditions conditions;
  conditions.max_work = 1000;
  FlightRecorder recorder(conditions, folder.prefix(), 1000);
  bridge.world.coupling.watch(&recorder);
  int bad = 0;
  for (int k = 0; k < 60; ++k) {
    if (k == 30) bridge.ball.SetLinearVelocity({0.0F, -8.0F});
    bridge.world.tick();
    const ribbon::IslandReport& report = bridge.world.coupling.last_step().report();
    if (report.work <= *conditions.max_work) continue;
    ++bad;
    ASSERT_EQ(recorder.written(), bad) << recorder.failure();
    const SolverStep step = load_solver_step(recorder.last_file());
    EXPECT_EQ(step.outcome.work, report.work);
    EXPECT_EQ(step.outcome.why, "work " + std::to_string(report.work) + ", above 1000");
  }
  EXPECT_EQ(recorder.written(), bad);
  EXPECT_EQ(folder.files(), bad);
  EXPECT_GT(bad, 0);
  EXPECT_LT(bad, 60);
}

TEST(FlightRecorder, ChecksTheConditionsThatAreSet) {
  const auto written = [](const FlightConditions& conditions) {
    const Folder folder;
    Bridge bridge;
    bridge.ball.SetLinearVelocity({0.0F, -2.0F});
    FlightRecorder recorder(conditions, folder.prefix(), 3);
    bridge.world.coupling.watch(&recorder);
    for (int k = 0; k < 5; ++k) bridge.world.tick();
    EXPECT_EQ(folder.files(), recorder.written());
    EXPECT_EQ(recorder.is_armed(), recorder.written() < 3);
    return recorder.written();
  };
  EXPECT_EQ(written({}), 0);
  EXPECT_EQ(written({.max_speed = 1e3}), 0);
  EXPECT_EQ(written({.max_speed = 0.1}), 3) << "and no more than it may";
  EXPECT_EQ(written({.max_stretch = 0.5}), 0);
  EXPECT_EQ(written({.max_stretch = -0.5}), 3);
  EXPECT_EQ(written({.unconverged = true}), 0);
  EXPECT_EQ(written({.not_finite = true}), 0);
}

TEST(FlightRecorder, AllocatesNothingInTicksThatAreNotWritten) {
  const Folder folder;
  test_support::CoupledWorld world{{}};
  test_support::hang_bridge(world, 10.0, 600);
  FlightConditions conditions;
  conditions.max_work = 1'000'000'000;
  conditions.unconverged = conditions.not_finite = true;
  conditions.max_speed = conditions.max_stretch = 1e6;
  FlightRecorder recorder(conditions, folder.prefix(), 5);
  world.coupling.watch(&recorder);
  for (int k = 0; k < 3; ++k) world.step_cords(), world.step_world();
  for (int k = 0; k < 30; ++k) {
    const test_support::AllocationCount count;
    world.step_cords();
    EXPECT_EQ(count.so_far(), 0) << "tick " << k;
    world.step_world();
  }
  EXPECT_EQ(folder.files(), 0);
  world.coupling.watch(nullptr);
  world.tick();
}

TEST(FlightRecorder, ChangesNoBitOfWhatIsRecorded) {
  const Folder folder;
  Bridge plain;
  Bridge recorded;
  FlightConditions conditions;
  conditions.max_work = 0;
  FlightRecorder recorder(conditions, folder.prefix(), 5);
  recorded.world.coupling.watch(&recorder);
  for (int k = 0; k < 20; ++k) {
    plain.world.tick();
    recorded.world.tick();
    ASSERT_TRUE(plain.world.coupling.save(plain.world.world) == recorded.world.coupling.save(recorded.world.world));
  }
  EXPECT_EQ(recorder.written(), 5);
}

TEST(FlightRecorder, KeepsTheFilesOfAnEarlierRun) {
  const Folder folder;
  for (int run = 1; run <= 2; ++run) {
    Bridge bridge;
    FlightConditions conditions;
    conditions.max_work = 0;
    FlightRecorder recorder(conditions, folder.prefix(), 2);
    bridge.world.coupling.watch(&recorder);
    for (int k = 0; k < 4; ++k) bridge.world.tick();
    EXPECT_EQ(recorder.written(), 2);
    EXPECT_EQ(folder.files(), 2 * run);
  }
}

TEST(FlightRecorder, ReportsWriteErrorsAndContinues) {
  Bridge bridge;
  FlightConditions conditions;
  conditions.max_work = 0;
  const std::string prefix = testing::TempDir() + "there/is/no/such/folder/";
  FlightRecorder recorder(conditions, prefix, 5);
  bridge.world.coupling.watch(&recorder);
  for (int k = 0; k < 4; ++k) bridge.world.tick();
  EXPECT_EQ(recorder.failure(), prefix + "1.json: cannot be written: No such file or directory");
  EXPECT_FALSE(recorder.is_armed());
  EXPECT_EQ(recorder.written(), 0);
}

TEST(FlightRecorder, LeavesNoPartialFileOnAFullDisk) {
  const SolverStep step;
  EXPECT_THROW(save_solver_step(step, "/dev/full"), SolverStepError);
}

}  // namespace
}  // namespace engine
