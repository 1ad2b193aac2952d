#include "tests/baseline/table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "tests/support/refusal.h"

namespace baseline {
namespace {

const std::string header = "scene,method,setting,points,ticks,work,worst_tick\n";

/// Writes a file with this text; its name contains that of the test, so that tests can run at the same time.
std::filesystem::path file_with(const std::string& text) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::path path = std::filesystem::path(testing::TempDir()) / ("baseline_" + test + ".csv");
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// Returns the message that such a file is refused with, without the file's path.
std::string refusal_of(const std::string& text) {
  const std::filesystem::path path = file_with(text);
  std::string message = test_support::refusal<std::runtime_error>([&] { read_table(path); });
  if (!test_support::starts_with(message, path.string())) return message;
  return message.substr(path.string().size());
}

TEST(BaselineTable, ReadsWhatItWrites) {
  const std::vector<Row> rows = {{"bridge", "cord", "fast ratio=0.01", 31, 120, 12'345'678'901, 4'000'000'000},
                                 {"cords_and_circles", "cord", "fast", 5000, 30, 0, 0},
                                 {"curtains", "recorded run", "", 204, 1, 7, 7}};
  const std::filesystem::path path = file_with("");
  write_table(path, rows);
  EXPECT_EQ(read_table(path), rows);
}

TEST(BaselineTable, RequiresAHeader) {
  EXPECT_EQ(refusal_of("scene,work\n"),
            ":1: 'scene,work' is not accepted; accepted is scene,method,setting,points,ticks,work,worst_tick");
  EXPECT_EQ(refusal_of(""), ":1: '' is not accepted; accepted is scene,method,setting,points,ticks,work,worst_tick");
}

TEST(BaselineTable, ALineHasAllColumnsAndNoMore) {
  const std::string accepted = " columns; accepted are 7: scene,method,setting,points,ticks,work,worst_tick";
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,1,2,2\na,cord,fast,51,1,2\n"), ":3: 6" + accepted);
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,1,2,2,3\n"), ":2: 8" + accepted);
  EXPECT_EQ(refusal_of(header + "\n"), ":2: 1" + accepted);
}

TEST(BaselineTable, NumbersAreWholeAndNotNegative) {
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,1,many,2\n"),
            ":2: 'many' is not accepted; accepted is a whole number of 0 or more");
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,1,2.5,2\n"),
            ":2: '2.5' is not accepted; accepted is a whole number of 0 or more");
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,1,2,-2\n"),
            ":2: '-2' is not accepted; accepted is a whole number of 0 or more");
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,0,2,2\n"),
            ":2: '0' is not accepted; accepted is a whole number of 1 or more");
  EXPECT_EQ(refusal_of(header + "a,cord,fast,none,1,2,2\n"),
            ":2: 'none' is not accepted; accepted is a whole number of 0 or more");
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,1,99999999999999999999,2\n"),
            ":2: '99999999999999999999' is not accepted; accepted is a whole number of 0 or more");
}

TEST(BaselineTable, ARowHasASceneAndAMethod) {
  EXPECT_EQ(refusal_of(header + ",cord,fast,51,1,2,2\n"), ":2: no scene or no method; accepted is a name of each");
}

TEST(BaselineTable, RefusesDuplicateRows) {
  EXPECT_EQ(refusal_of(header + "a,cord,fast,51,1,2,2\na,cord,fast,51,1,2,2\n"),
            ":3: 'a cord fast, 51 points' is there twice; accepted is one row of a name");
}

TEST(BaselineTable, AMissingFileIsReported) {
  EXPECT_EQ(test_support::refusal<std::runtime_error>([] { read_table("/nowhere/work.csv"); }),
            "cannot read /nowhere/work.csv; accepted is a table that --accept has written");
  EXPECT_THROW(write_table("/nowhere/work.csv", {}), std::runtime_error);
}

}  // namespace
}  // namespace baseline
