// The program itself: what it prints and the status it ends with.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

struct Ended {
  int status;
  std::string output;  // both streams
};

Ended ropeswing(const std::string& arguments, const std::string& environment = "") {
  const std::string command = environment + " " TEST_ROPESWING " " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  Ended ended{-1, ""};
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) ended.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  return ended;
}

std::string golden() { return TEST_ASSETS "/replays/first_swing.replay"; }

std::string scratch(const std::string& name) { return testing::TempDir() + "ropeswing_" + name; }

std::string bytes_of(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

void write_bytes(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return "";
  const std::size_t start = text.rfind('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? 0 : start + 1) + 1);
}

TEST(ReplayProgram, TheGoldenRunVerifiesAndReachesTheGoal) {
  const Ended ended = ropeswing("--headless --verify --replay " + golden());
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_NE(ended.output.find("reached the goal"), std::string::npos);
  EXPECT_EQ(last_line(ended.output).rfind("verified ", 0), 0U) << ended.output;
  EXPECT_NE(last_line(ended.output).find(" ticks, hash "), std::string::npos);
}

TEST(ReplayProgram, ACutShortReplayVerifiesItsCompleteTicksWithStatus2) {
  const std::string bytes = bytes_of(golden());
  const std::string path = scratch("cut.replay");
  write_bytes(path, bytes.substr(0, bytes.size() / 2));
  const Ended ended = ropeswing("--headless --verify --replay " + path);
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(last_line(ended.output).rfind("cut short after ", 0), 0U) << ended.output;
}

TEST(ReplayProgram, WhatItRecordsItVerifies) {
  const std::string path = scratch("recorded.replay");
  ASSERT_EQ(ropeswing("--headless --ticks 120 --record " + path).status, 0);
  const Ended ended = ropeswing("--headless --verify --replay " + path);
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(last_line(ended.output).rfind("verified 120 ticks", 0), 0U) << ended.output;
}

TEST(ReplayProgram, RecordingAReplayAnewGivesTheSameFile) {
  const std::string path = scratch("again.replay");
  ASSERT_EQ(ropeswing("--headless --replay " + golden() + " --record " + path).status, 0);
  EXPECT_TRUE(bytes_of(path) == bytes_of(golden()));
}

TEST(ReplayProgram, AnotherPhysicsIsNamedByTickSubsystemAndIndex) {
  // The same level file but for a cord's mass, and a recording that claims to be of it.
  const std::string folder = scratch("assets");
  fs::create_directories(folder + "/levels");
  std::string level = bytes_of(TEST_ASSETS "/levels/first_swing.tmj");
  write_bytes(folder + "/levels/first_swing.tmj", level);
  const std::string other = scratch("other.replay");
  const std::size_t place = level.find("\"mass\"");
  ASSERT_NE(place, std::string::npos);
  const std::size_t digit = level.find_first_of("123456789", place);
  level[digit] = level[digit] == '9' ? '8' : '9';
  write_bytes(folder + "/levels/first_swing.tmj", level);
  const std::string environment = "ROPESWING_ASSETS=" + folder;
  const Ended refused = ropeswing("--headless --verify --replay " + golden(), environment);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.output.find("level hash differs"), std::string::npos) << refused.output;
}

TEST(ReplayProgram, RefusesGarbageAnotherVersionAndAMissingFile) {
  const std::string garbage = scratch("garbage.replay");
  write_bytes(garbage, "this is not a replay");
  const Ended no_replay = ropeswing("--headless --replay " + garbage);
  EXPECT_EQ(no_replay.status, 2);
  EXPECT_NE(no_replay.output.find(garbage), std::string::npos);

  std::string bytes = bytes_of(golden());
  const std::size_t version = bytes.find(" 1\n");
  ASSERT_LT(version, 40U);
  bytes[version + 1] = '7';
  const std::string newer = scratch("newer.replay");
  write_bytes(newer, bytes);
  const Ended other_version = ropeswing("--headless --replay " + newer);
  EXPECT_EQ(other_version.status, 2);
  EXPECT_NE(other_version.output.find("version"), std::string::npos) << other_version.output;

  EXPECT_EQ(ropeswing("--headless --replay /no/such/file").status, 2);
  EXPECT_EQ(ropeswing("--headless --replay " TEST_ASSETS).status, 2);  // a folder
}

TEST(Program, RefusesUnknownLevelsAndBadArgumentsWithASentence) {
  const Ended level = ropeswing("--headless --level nowhere");
  EXPECT_EQ(level.status, 2);
  EXPECT_NE(level.output.find("first_swing"), std::string::npos) << level.output;  // what there is
  EXPECT_EQ(ropeswing("--headless --verify").status, 2);
  EXPECT_EQ(ropeswing("--headless --ticks -5").status, 2);
  EXPECT_EQ(ropeswing("--headless --ticks many").status, 2);
  EXPECT_EQ(ropeswing("--nonsense").status, 2);
  EXPECT_EQ(ropeswing("--help").status, 0);
  const Ended record = ropeswing("--headless --ticks 1 --record /no/such/folder/a.replay");
  EXPECT_EQ(record.status, 2);
  EXPECT_NE(record.output.find("/no/such/folder/a.replay"), std::string::npos);
  const Ended picture = ropeswing("--headless --ticks 1 --screenshot /no/such/folder/a.png");
  EXPECT_EQ(picture.status, 2);
  EXPECT_NE(picture.output.find("/no/such/folder/a.png"), std::string::npos);
}

TEST(Program, WithoutADisplayAWindowIsRefusedWithTheWayOut) {
  const Ended ended = ropeswing("", "env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.output.find("--headless"), std::string::npos) << ended.output;
}

TEST(Program, WritesAPictureOfTheLastMoment) {
  const std::string path = scratch("picture.png");
  fs::remove(path);
  const Ended ended = ropeswing("--headless --ticks 30 --screenshot " + path);
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(bytes_of(path).substr(1, 3), "PNG");
  EXPECT_NE(ended.output.find(path), std::string::npos);
}

}  // namespace
