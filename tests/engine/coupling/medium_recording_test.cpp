#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "engine/replay/solver_step.h"
#include "engine/tick/workers.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/box2d/step_watcher.h"
#include "ribbon/direct_solver.h"
#include "ribbon/weather.h"
#include "tests/engine/coupling/blown_world.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/support/allocations.h"
#include "tests/support/dice.h"

// Recorded steps of cords in a medium.

namespace engine {
namespace {

using ribbon::Weather;
using ribbon::WeatherDef;

/// A step in a Weather is recorded whole: its repetition has the same bits.
class Recorder : public ribbon::box2d::StepWatcher {
 public:
  void before(const ribbon::box2d::SolverInput& input) noexcept override { capture(input, step); }
  void after(const ribbon::box2d::SolverInput& input, std::span<const ribbon::IslandReport> /*islands*/,
             const ribbon::IslandReport& total) noexcept override {
    step.outcome.work = total.work;
    step.outcome.unconverged = total.unconverged;
    step.outcome.positions = hash_of_positions(input.cords);
  }
  SolverStep step;
};

/// Takes a recorded step again.
std::uint64_t hash_of_repetition(const SolverStep& step) {
  std::vector<Cord> cords;
  std::vector<Weather> media;
  for (const WeatherDef& def : step.media) media.emplace_back(def);
  for (const SolverStep::Cord& cord : step.cords) {
    cords.emplace_back(cord.def);
    cords.back().restore(cord.state);
  }
  std::vector<ribbon::IslandCord> members;
  for (std::size_t k = 0; k < cords.size(); ++k) {
    const int medium = step.cords[k].medium;
    members.push_back({&cords[k], {}, step.cords[k].id});
    if (medium >= 0) members[k].surroundings.medium = &media[static_cast<std::size_t>(medium)];
    members[k].surroundings.time = step.cords[k].time;
  }
  std::vector<ribbon::CordReport> reports(cords.size());
  ribbon::DirectSolver solver;
  solver.step(members, {}, step.dt, step.gravity, reports);
  return hash_of_positions(members);
}

TEST(CouplingMedium, IsRecordedInASolverStep) {
  Blown scene;
  scene.coupling.add(Cord(feeling(hanging())));
  scene.coupling.add(Cord(hanging(5.0)));
  Recorder recorder;
  scene.coupling.watch(&recorder);
  scene.tick(40);
  ASSERT_EQ(recorder.step.media.size(), 1U);
  EXPECT_EQ(recorder.step.media[0], gusts_over_water());
  EXPECT_NEAR(recorder.step.cords[0].time, 39.0 * dt, 1e-12);
  const SolverStep read = read_solver_step(to_text(recorder.step), "a step");
  EXPECT_EQ(to_text(read), to_text(recorder.step));
  EXPECT_EQ(hash_of_repetition(read), recorder.step.outcome.positions);
  SolverStep other = read;
  other.media[0].wind.x += 0.1;
  EXPECT_NE(hash_of_repetition(other), recorder.step.outcome.positions);
  other = read;
  other.cords[0].medium = 1;
  EXPECT_THROW(check(other), SolverStepError);
  other = read;
  other.media[0].gusts = 2.0;
  EXPECT_THROW(check(other), SolverStepError);
}

/// Another medium is recorded as a uniform one.
class Breeze : public ribbon::Medium {
 public:
  ribbon::MediumSample at(Vec2 place, double /*half_height*/, double /*time*/) const override {
    return {{place.y, 0.0}, 1.2};
  }
};

TEST(CouplingMedium, OfAUsersClassIsRecordedRoughly) {
  GripWorld scene;
  const Breeze breeze;
  scene.coupling.set_medium(&breeze);
  scene.coupling.add(Cord(feeling(hanging())));
  Recorder recorder;
  scene.coupling.watch(&recorder);
  scene.tick();
  ASSERT_EQ(recorder.step.media.size(), 1U);
  EXPECT_NEAR(recorder.step.media[0].wind.x, -5.0, 0.2) << "in the middle of the cord";
}

}  // namespace
}  // namespace engine
