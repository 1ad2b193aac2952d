#include "engine/replay/replay.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/engine/replay/recorded_replay.h"
#include "tests/support/refusal.h"

// Comparing a run with its replay.

namespace engine {
namespace {

using test_support::refusal;
using test_support::says;

TEST(ReplayHeader, MatchesAnEqualHeader) { EXPECT_NO_THROW(check_header(some_header(), some_header())); }

TEST(ReplayHeader, NamesTheFirstFieldThatDiffers) {
  const auto error = [](const ReplayHeader& current) {
    return refusal<ReplayError>([&] { check_header(some_header(), current); });
  };
  ReplayHeader other = some_header();
  other.settings["solver"] = "thesis";
  EXPECT_EQ(error(other),
            "the replay does not fit: setting \"solver\" differs (recorded \"implicit\", now \"thesis\")");
  other.settings["gravity"] = -1.62;
  EXPECT_TRUE(says(error(other), "setting \"gravity\" differs (recorded -9.81, now -1.62)"));
  other.settings.erase("gravity");
  EXPECT_TRUE(says(error(other), "setting \"gravity\" differs (recorded -9.81, now none)"));
  other.settings["friction"] = "0.5";
  EXPECT_TRUE(says(error(other), "setting \"friction\" differs (recorded none, now \"0.5\")"));
  other.players = 2;
  EXPECT_TRUE(says(error(other), "number of players differs (recorded 1, now 2)"));
  other.tick_rate = 120;
  EXPECT_TRUE(says(error(other), "tick rate differs (recorded 60, now 120)"));
  other.level_hash = 1;
  EXPECT_TRUE(says(error(other), "level hash differs (recorded 0123456789abcdef, now 0000000000000001)"));
  other.level = "b";
  EXPECT_TRUE(says(error(other), "level differs (recorded \"Lianen-Übung.tmj\", now \"b\")"));
}

TEST(ReplayVerifier, AllTicksEqualIsVerified) {
  const Replay replay = parse(recorded(3, true, "verified"));
  ReplayVerifier verifier(replay);
  for (std::uint16_t i = 0; i < 3; ++i) {
    ASSERT_FALSE(verifier.done());
    EXPECT_EQ(verifier.input(), some_input(i));
    EXPECT_TRUE(verifier.check(some_state(i)));
  }
  EXPECT_TRUE(verifier.done());
  EXPECT_EQ(verifier.result().outcome, VerifyOutcome::verified);
  EXPECT_EQ(verifier.result().message(), "verified 3 ticks, hash " + ribbon::box2d::to_hex(some_state(2).combined()));
  EXPECT_EQ(exit_status(verifier.result().outcome), 0);
}

TEST(ReplayVerifier, StopsAtTheFirstDifferenceAndNamesTickAndPart) {
  Replay replay = parse(recorded(5, true, "diverged"));
  const ribbon::box2d::StateHash first({{ribbon::box2d::Subsystem::cord, 2, 0x89abcdef}}, 1);
  const ribbon::box2d::StateHash now({{ribbon::box2d::Subsystem::cord, 2, 0x01234567}}, 2);
  replay.ticks[2].state = first;
  ReplayVerifier verifier(replay);
  EXPECT_TRUE(verifier.check(some_state(0)));
  EXPECT_TRUE(verifier.check(some_state(1)));
  EXPECT_FALSE(verifier.check(now));
  EXPECT_TRUE(verifier.done());
  EXPECT_EQ(verifier.result().outcome, VerifyOutcome::diverged);
  EXPECT_EQ(verifier.result().message(), "tick 3: cord 2 differs (recorded 89abcdef, now 01234567)");
  EXPECT_EQ(exit_status(verifier.result().outcome), 1);
}

TEST(ReplayVerifier, ATruncatedReplayIsReportedAfterItsTicks) {
  const Replay replay = parse(recorded(2, false, "cut"));
  ReplayVerifier agreeing(replay);
  EXPECT_TRUE(agreeing.check(some_state(0)));
  EXPECT_TRUE(agreeing.check(some_state(1)));
  EXPECT_TRUE(agreeing.done());
  EXPECT_EQ(agreeing.result().message(), "cut short after 2 ticks");
  EXPECT_EQ(exit_status(agreeing.result().outcome), 2);

  ReplayVerifier diverging(replay);
  EXPECT_FALSE(diverging.check(some_state(1)));
  EXPECT_EQ(exit_status(diverging.result().outcome), 1) << "a difference outweighs the missing end";
}

TEST(ReplayVerifier, AReplayLeftBeforeTheEndIsNotVerified) {
  const Replay replay = parse(recorded(2, true, "left"));
  ReplayVerifier verifier(replay);
  verifier.check(some_state(0));
  EXPECT_EQ(verifier.result().outcome, VerifyOutcome::cut_short);
  EXPECT_EQ(verifier.result().message(), "cut short after 1 ticks");
}

TEST(ReplayVerifier, AnEmptyReplayIsVerifiedAtOnce) {
  const Replay replay = parse(recorded(0, true, "empty"));
  const ReplayVerifier verifier(replay);
  EXPECT_TRUE(verifier.done());
  EXPECT_EQ(verifier.result().message(), "verified 0 ticks, hash 0000000000000000");
}

}  // namespace
}  // namespace engine
