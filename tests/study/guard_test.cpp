#include "tests/study/guard.h"

#include <gtest/gtest.h>

#include "tests/study/level_study_fixture.h"
#include "tests/support/refusal.h"

namespace study {
namespace {

using test_support::refusal;

GuardRow row() { return {"swing", "", 100, 10000, 500, 1e-3, 5.0, 20.0, ""}; }

TEST(Guard, ReportsWhatIsWorseThanTheMargin) {
  GuardRow now = row();
  EXPECT_TRUE(worse(row(), now).empty());
  now.work = 10500;
  now.most_work = 525;
  now.error_m = 1.2e-3;
  EXPECT_TRUE(worse(row(), now).empty());  // at the margins
  now.work = 10501;
  ASSERT_EQ(worse(row(), now).size(), 1U);
  EXPECT_EQ(worse(row(), now)[0], "work 10501 instead of 10000 (+5.0 %)");
  now.most_work = 600;
  now.error_m = 2e-3;
  now.ticks = 101;
  now.failure = "blew up in tick 3";
  const std::vector<std::string> all = worse(row(), now);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0], "its recording has 101 ticks instead of 100");
  EXPECT_EQ(all[2], "work of the greatest tick 600 instead of 500 (+20.0 %)");
  EXPECT_EQ(all[3], "error 0.002 m instead of 0.001 m (+100.0 %)");
  EXPECT_EQ(all[4], "it fails: blew up in tick 3");
  GuardRow exact = row();
  exact.error_m = 1e-9;
  now = exact;
  now.error_m = 9e-6;  // twice a nanometre is not a fault
  EXPECT_TRUE(worse(exact, now).empty());
}

TEST_F(LevelStudy, AGuardReadsWhatItWrites) {
  const std::string path = home + "/levels.csv";
  GuardRow other = row();
  other.level = "two, or \"three\".tmj";
  other.replay = "a,b.replay";
  other.failure = "cord 1, 3 ticks not converged";
  write_guard(path, {row(), other});
  EXPECT_EQ(read_guard(path), (std::vector<GuardRow>{row(), other}));
  const auto complaint = [&](const std::string& text) {
    std::ofstream(path) << text;
    return refusal<std::runtime_error>([&] { read_guard(path); });
  };
  const std::string whole = read_file(path);
  EXPECT_NE(complaint("level\n").find("line 1: has another header"), std::string::npos);
  EXPECT_NE(complaint(whole + "swing,,100\n").find("line 4: is not a row"), std::string::npos);
  EXPECT_NE(complaint(whole + "third,,100,-5,1,1,5,20,\n").find("line 4: is not a row"), std::string::npos);
  EXPECT_NE(complaint(whole + whole.substr(whole.find("swing"))).find("has swing again"), std::string::npos);
  EXPECT_NE(complaint(whole + "\"third,,100,5,1,1,5,20,\n").find("line 4: is not a row"), std::string::npos);
  other.replay = "a\nb";
  EXPECT_NE(refusal<std::runtime_error>([&] { write_guard(path, {other}); }).find("a path has a line end"),
            std::string::npos);
  EXPECT_NE(refusal<std::runtime_error>([&] { read_guard(home + "/none.csv"); }).find("cannot read"),
            std::string::npos);
  EXPECT_NE(refusal<std::runtime_error>([&] { write_guard(home + "/no/file.csv", {row()}); }).find("cannot write"),
            std::string::npos);
}

/// The level is worse by one substep more.
TEST_F(LevelStudy, AGuardNoticesAMoreExpensiveLevel) {
  const Guard guard{home + "/levels.csv", {level_path}, replay_path};
  testing::internal::CaptureStdout();
  EXPECT_EQ(accept(guard), 0);
  EXPECT_EQ(check(guard), 0);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("as accepted"), std::string::npos);
  LevelFile(level_path).apply(Setting{"direct", "tr_bdf2", 2, 5e-4});
  record(replay_path, 20);
  testing::internal::CaptureStdout();
  EXPECT_EQ(check({guard.file, {}, ""}), 1);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("worse: " + level_path + ": work "), std::string::npos) << said;
  testing::internal::CaptureStdout();
  EXPECT_EQ(accept({guard.file, {}, ""}), 0);
  EXPECT_EQ(check({guard.file, {}, ""}), 0);
  testing::internal::GetCapturedStdout();
  EXPECT_NE(refusal<std::runtime_error>([&] {
              check({guard.file, {"first_swing"}, ""});
            }).find("has no row of"),
            std::string::npos);
}

}  // namespace
}  // namespace study
