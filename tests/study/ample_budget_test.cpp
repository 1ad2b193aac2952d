#include <gtest/gtest.h>

#include "tests/study/level_file.h"
#include "tests/study/players.h"
#include "tests/study/setting.h"
#include "tests/study/trace.h"

namespace study {
namespace {

// Ribbons of curtains that a random player presses together, in variations of the level.
struct Case {
  unsigned variation;
  Setting setting;
};

/// A substep that does not converge is halved. Where the halves do not converge either, all of the step is solved with
/// contacts that are linearised once. Without that, one and two ticks stay unconverged.
TEST(AmpleBudget, WhatHalvesDoNotSolveIsLinearised) {
  const LevelFile curtains(TEST_ASSETS "/levels/curtains.tmj");
  for (const Case& some : {Case{8, {"direct", "implicit_euler", 1, 1e-2}}, Case{20, {"direct", "tr_bdf2", 4, 5e-4}}}) {
    const LevelFile varied = curtains.varied(some.variation);
    Setting setting = some.setting;
    setting.max_work = 20'000;
    const Inputs inputs = random_inputs_with_cords(varied.level(), some.variation + 1, 120);
    const Trace trace = run(varied.with(setting), inputs);
    EXPECT_EQ(trace.failure, "");
    EXPECT_EQ(trace.unconverged_ticks, 0) << name_of(setting);
    EXPECT_GT(trace.work.posed, 0) << "this scene no longer shows it";
  }
}

}  // namespace
}  // namespace study
