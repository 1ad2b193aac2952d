#include "tests/study/run_in_copy.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>

#include "game/simulation/buttons.h"
#include "tests/support/refusal.h"

namespace study {
namespace {

/// A run of first_swing in which the player jumps to a rope.
std::vector<engine::TickInput> jump() {
  engine::TickInput right;
  right.buttons = game::button_right | game::button_grab;
  std::vector<engine::TickInput> inputs(90, right);
  for (std::size_t k = 50; k < inputs.size(); ++k) inputs[k].buttons |= game::button_jump;
  return inputs;
}

TEST(RunInCopy, HasTheSameBitsAndLeavesTheRunWhereItIs) {
  const game::Level level = game::load_level("first_swing");
  const std::vector<engine::TickInput> inputs = jump();
  StartedRun start(level, inputs, 60);
  const PartSetting fast{ribbon::Accuracy::fast()};
  const Trace first = run_in_copy([&] { return start.finish(20, fast); });
  const Trace own = run_in_copy([&] { return start.finish(20, {}); });
  const Trace here = start.finish(20, fast);
  ASSERT_EQ(here.places.size(), 20U);
  EXPECT_EQ(first.places, here.places);
  EXPECT_EQ(first.player, here.player);
  EXPECT_EQ(first.tick_work, here.tick_work);
  EXPECT_NE(own.places, here.places);
}

TEST(RunInCopy, PassesOnWhatIsThrownAndNoticesACopyThatEnds) {
  const auto sentence_of = [](const std::function<Trace()>& run) {
    return test_support::refusal<std::runtime_error>([&] { run_in_copy(run); });
  };
  EXPECT_EQ(sentence_of([]() -> Trace { throw std::runtime_error("a sentence"); }), "a sentence");
  EXPECT_EQ(sentence_of([]() -> Trace { ::_exit(3); }), "a run in a copy of this process ended early");
}

}  // namespace
}  // namespace study
