// The output and the exit status of the program.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "tests/game/program.h"
#include "tests/support/mixed_level.h"

namespace {

using namespace test_support;

TEST(ReplayProgram, TheGoldenRunVerifiesAndReachesTheGoal) {
  const Ended ended = ropeswing("--headless --verify --replay " + golden());
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_NE(ended.output.find("reached the goal"), std::string::npos);
  EXPECT_EQ(last_line(ended.output).rfind("verified ", 0), 0U) << ended.output;
  EXPECT_NE(last_line(ended.output).find(" ticks, hash "), std::string::npos);
}

TEST(ReplayProgram, ATruncatedReplayVerifiesItsCompleteTicksWithStatus2) {
  const std::string bytes = bytes_of(golden());
  const std::string path = scratch("cut.replay");
  write_bytes(path, bytes.substr(0, bytes.size() / 2));
  const Ended ended = ropeswing("--headless --verify --replay " + path);
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(last_line(ended.output).rfind("cut short after ", 0), 0U) << ended.output;
}

TEST(ReplayProgram, VerifiesItsOwnRecording) {
  const std::string path = scratch("recorded.replay");
  ASSERT_EQ(ropeswing("--headless --ticks 120 --record " + path).status, 0);
  const Ended ended = ropeswing("--headless --verify --replay " + path);
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(last_line(ended.output).rfind("verified 120 ticks", 0), 0U) << ended.output;
}

TEST(ReplayProgram, VerifiesItsRecordingOfALevelWithBothSolvers) {
  const std::string level = scratch("mixed_swing.tmj");
  const std::string path = scratch("mixed_swing.replay");
  write_bytes(level, test_support::mixed_swing_map());
  const Ended recorded = ropeswing("--headless --ticks 120 --level " + level + " --record " + path);
  ASSERT_EQ(recorded.status, 0) << recorded.output;
  const Ended ended = ropeswing("--headless --verify --level " + level + " --replay " + path);
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(last_line(ended.output).rfind("verified 120 ticks", 0), 0U) << ended.output;
}

TEST(ReplayProgram, SeeksATickAndReportsTheTime) {
  const Ended ended = ropeswing("--headless --seek 300 --ticks 300 --replay " + golden());
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.output.rfind("tick 300 reached in ", 0), 0U) << ended.output;
  EXPECT_NE(ended.output.find(" times real time\n"), std::string::npos) << ended.output;
  const ribbon::box2d::StateHash recorded = engine::load_replay(golden()).ticks[299].state;
  EXPECT_EQ(last_line(ended.output), "hash " + ribbon::box2d::to_hex(recorded.combined()));
  const Ended beyond = ropeswing("--headless --seek 100000 --replay " + golden());
  EXPECT_EQ(beyond.status, 2);
  EXPECT_NE(beyond.output.find("tick 100000 is not in the replay; accepted is 0 to "), std::string::npos);
  EXPECT_EQ(ropeswing("--headless --seek 3 --ticks 5").status, 2) << "of what?";
}

TEST(ReplayProgram, RecordingAReplayAgainGivesTheSameFile) {
  const std::string path = scratch("again.replay");
  ASSERT_EQ(ropeswing("--headless --replay " + golden() + " --record " + path).status, 0);
  EXPECT_TRUE(bytes_of(path) == bytes_of(golden()));
}

/// Returns the path of a golden run in which one part's hash of one tick is changed, as by other physics.
std::string diverging_replay(std::size_t tick, std::size_t part) {
  const engine::Replay replay = engine::load_replay(golden());
  std::string path = scratch("diverging.replay");
  engine::ReplayWriter writer(path, replay.header);
  for (std::size_t k = 0; k < replay.ticks.size(); ++k) {
    ribbon::box2d::StateHash state = replay.ticks[k].state;
    if (k + 1 == tick) {
      std::vector<ribbon::box2d::StatePart> parts(state.parts().begin(), state.parts().end());
      parts[part].hash ^= 1;
      state = ribbon::box2d::StateHash(parts, state.combined() ^ 1);
    }
    writer.write(replay.ticks[k].input, state);
  }
  writer.finish();
  return path;
}

TEST(ReplayProgram, TheFirstTickThatDiffersIsNamedWithSubsystemAndIndex) {
  const Ended cord =
      ropeswing("--headless --verify --replay " + diverging_replay(200, 2));  // game 0, cord 0, cord 1, …
  EXPECT_EQ(cord.status, 1);
  EXPECT_EQ(last_line(cord.output).rfind("tick 200: cord 1 differs", 0), 0U) << cord.output;
  EXPECT_NE(cord.output.find("ran 200 ticks"), std::string::npos) << cord.output;  // it stops there
  const Ended game = ropeswing("--headless --verify --replay " + diverging_replay(1, 0));
  EXPECT_EQ(game.status, 1);
  EXPECT_EQ(last_line(game.output).rfind("tick 1: game 0 differs", 0), 0U) << game.output;
}

TEST(ReplayProgram, AReplayOfAChangedLevelIsRefused) {
  const std::string folder = scratch("assets");
  fs::create_directories(folder + "/levels");
  std::string level = bytes_of(TEST_ASSETS "/levels/first_swing.tmj");
  level += "\n";
  write_bytes(folder + "/levels/first_swing.tmj", level);
  const Ended refused = ropeswing("--headless --verify --replay " + golden(), "ROPESWING_ASSETS=" + folder);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.output.find("level hash differs"), std::string::npos) << refused.output;
}

TEST(ReplayProgram, AKilledGameHasWrittenAReplayUpToItsLastTick) {
  const std::string path = scratch("killed.replay");
  fs::remove(path);
  const pid_t game = fork();
  if (game == 0) {
    execl(TEST_ROPESWING, TEST_ROPESWING, "--headless", "--ticks", "1000000", "--record", path.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  while (!fs::exists(path) || fs::file_size(path) < 20'000) {  // until it is in the middle of a run
    ASSERT_EQ(waitpid(game, &status, WNOHANG), 0) << "the game ended by itself";
    usleep(1000);
  }
  kill(game, SIGKILL);
  waitpid(game, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  const engine::Replay left = engine::load_replay(path);
  EXPECT_FALSE(left.complete);
  EXPECT_GT(left.ticks.size(), 50U);
  const Ended ended = ropeswing("--headless --verify --replay " + path);
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(last_line(ended.output), "cut short after " + std::to_string(left.ticks.size()) + " ticks");
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

TEST(Program, RefusesUnknownLevelsAndBadArgumentsWithAMessage) {
  const Ended level = ropeswing("--headless --level nowhere");
  EXPECT_EQ(level.status, 2);
  EXPECT_NE(level.output.find("first_swing"), std::string::npos) << level.output;  // lists the existing levels
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

TEST(Program, RefusesToOverwriteWhatItReadsAndToWriteOneFileTwice) {
  const std::string replay = scratch("both.replay");
  write_bytes(replay, bytes_of(golden()));
  const Ended ended = ropeswing("--headless --replay " + replay + " --record " + replay);
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.output.find("--record"), std::string::npos) << ended.output;
  EXPECT_TRUE(bytes_of(replay) == bytes_of(golden()));
  EXPECT_EQ(ropeswing("--headless --ticks 1 --record " + replay + ".x --screenshot " + replay + ".x").status, 2);
}

TEST(Program, RefusesEmptyNamesAndARunWithoutAnEnd) {
  for (const char* option : {"--level", "--replay", "--record", "--screenshot"}) {
    EXPECT_EQ(ropeswing(std::string("--headless --ticks 1 ") + option + " ''").status, 2) << option;
  }
  const Ended endless = ropeswing("--headless");
  EXPECT_EQ(endless.status, 2);
  EXPECT_NE(endless.output.find("--ticks"), std::string::npos) << endless.output;
}

TEST(Program, WithoutADisplayAWindowIsRefusedWithAHint) {
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

TEST(LabProgram, RunsASceneWithoutAWindowWithTheSameBits) {
  const std::string picture = scratch("lab.png");
  const Ended once = ropeswing("--headless --lab bridge --ticks 60 --screenshot " + picture);
  EXPECT_EQ(once.status, 0) << once.output;
  EXPECT_NE(once.output.find("chains: stretched by "), std::string::npos) << once.output;
  EXPECT_EQ(last_line(once.output).rfind("ran 60 ticks, hash ", 0), 0U) << once.output;
  EXPECT_TRUE(std::filesystem::exists(picture));
  EXPECT_EQ(last_line(ropeswing("--headless --lab bridge --ticks 60").output), last_line(once.output));
  EXPECT_EQ(ropeswing("--headless --lab --ticks 1").status, 0) << "the first scene";
}

TEST(LabProgram, RefusesAnUnknownSceneWithTheNamesOfAll) {
  for (const char* how : {"--headless --ticks 1 --lab nonsense", "--lab nonsense"}) {
    const Ended ended = ropeswing(how);
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.output.find("no scene 'nonsense'; accepted are heavy_load, capstan, "), std::string::npos)
        << ended.output;
  }
  EXPECT_EQ(ropeswing("--headless --lab bridge").status, 2) << "it does not say how far";
  EXPECT_EQ(ropeswing("--lab bridge --level first_swing").status, 2);
}

}  // namespace
