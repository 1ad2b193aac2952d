#include "tests/study/reference.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/replay/replay.h"
#include "ribbon/study/conditions.h"
#include "tests/study/errors.h"
#include "tests/study/level_file.h"

namespace study {
namespace {

class Converged : public testing::Test {
 protected:
  Converged() { inputs.resize(200); }

  /// Expects both records to be those of single runs whose accuracy changes in that tick.
  void expect_change(const std::pair<Trace, Trace>& runs, std::size_t tick) const {
    const AccuracyChange change{tick, accuracy_of(probe({}))};
    EXPECT_EQ(runs.first.places, run(first, inputs, {}, change).places);
    EXPECT_EQ(runs.second.places, run(second, inputs, {}, change).places);
  }

  const LevelFile file{TEST_ASSETS "/levels/first_swing.tmj"};
  const game::Level first = file.with(Setting{"direct", "implicit_euler", 1, 1e-2});
  const game::Level second = file.with(Setting{"direct", "tr_bdf2", 4, 1e-4});
  Inputs inputs = inputs_of(engine::load_replay(TEST_ASSETS "/replays/first_swing.replay"));
};

TEST_F(Converged, RunsEndTheirComparisonTogetherWhereTheyPart) {
  const std::pair<Trace, Trace> runs = run_converged(first, second, inputs, {inputs.size(), accuracy_of(probe({}))});
  const std::size_t agreeing = agreeing_ticks(runs.first, runs.second, ribbon::study::max_reference_difference);
  ASSERT_LT(agreeing + 1, inputs.size());
  expect_change(runs, agreeing + 1);
}

TEST_F(Converged, RunsEndTheirComparisonWhereProbesPart) {
  expect_change(run_converged(first, second, inputs, {0, accuracy_of(probe({}))}), 0);
  const std::pair<Trace, Trace> same = run_converged(second, second, inputs, {20, accuracy_of(probe({}))});
  EXPECT_EQ(same.first.places, run(second, inputs, {}, AccuracyChange{20, accuracy_of(probe({}))}).places);
  EXPECT_EQ(same.second.places, same.first.places);
}

/// The same records as those of whole runs, up to the tick in which they part.
TEST_F(Converged, ProbesEndWhereTheyPart) {
  Inputs all = inputs_of(engine::load_replay(TEST_ASSETS "/replays/first_swing.replay"));
  const auto [left, right] = run_probes(first, all);
  const auto whole = [&](double kick) { return run_part(first, all, {0, all.size(), 0, {std::nullopt, kick}}); };
  const Trace whole_left = whole(-ribbon::study::probe_kick), whole_right = whole(ribbon::study::probe_kick);
  const std::size_t agreeing = agreeing_ticks(whole_left, whole_right, ribbon::study::max_probe_difference);
  ASSERT_GT(agreeing, 0U);
  ASSERT_LT(agreeing + 1, all.size());
  EXPECT_EQ(agreeing_ticks(left, right, ribbon::study::max_probe_difference), agreeing);
  ASSERT_EQ(left.places.size(), agreeing + 1);
  EXPECT_EQ(right.places.size(), agreeing + 1);
  EXPECT_EQ(left.places[agreeing], whole_left.places[agreeing]);
  EXPECT_EQ(right.places[agreeing], whole_right.places[agreeing]);
}

TEST_F(Converged, OnlyTheSecondRunGoesOnIfNothingElseIsWanted) {
  const AccuracyChange change{inputs.size(), accuracy_of(probe({}))};
  const std::pair<Trace, Trace> both = run_converged(first, second, inputs, change);
  const std::pair<Trace, Trace> one = run_converged(first, second, inputs, change, GoesOn::second);
  const std::size_t agreeing = agreeing_ticks(both.first, both.second, ribbon::study::max_reference_difference);
  ASSERT_LT(agreeing + 1, inputs.size());
  EXPECT_EQ(one.first.places.size(), agreeing + 1);
  EXPECT_EQ(one.second.places, both.second.places);
  EXPECT_EQ(one.second.crossings, both.second.crossings);
}

}  // namespace
}  // namespace study
