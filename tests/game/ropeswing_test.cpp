// The program itself: what it prints and the status it ends with.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "engine/replay.h"
#include "tests/support/mixed_level.h"

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

/// A file of this process's own, so that test runs side by side do not meet; gone when it ends.
std::string scratch(const std::string& name) {
  struct Folder {
    std::string path = testing::TempDir() + "ropeswing_" + std::to_string(getpid()) + "/";
    Folder() { fs::create_directories(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path + name;
}

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

TEST(ReplayProgram, WhatItRecordsOfALevelWithCordsOfBothSolversItVerifies) {
  const std::string level = scratch("mixed_swing.tmj");
  const std::string path = scratch("mixed_swing.replay");
  write_bytes(level, test_support::mixed_swing_map());
  const Ended recorded = ropeswing("--headless --ticks 120 --level " + level + " --record " + path);
  ASSERT_EQ(recorded.status, 0) << recorded.output;
  const Ended ended = ropeswing("--headless --verify --level " + level + " --replay " + path);
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(last_line(ended.output).rfind("verified 120 ticks", 0), 0U) << ended.output;
}

TEST(ReplayProgram, RecordingAReplayAnewGivesTheSameFile) {
  const std::string path = scratch("again.replay");
  ASSERT_EQ(ropeswing("--headless --replay " + golden() + " --record " + path).status, 0);
  EXPECT_TRUE(bytes_of(path) == bytes_of(golden()));
}

/// The golden run with one part's hash of one tick changed, as another physics would have left it.
std::string diverging_replay(std::size_t tick, std::size_t part) {
  const engine::Replay replay = engine::load_replay(golden());
  std::string path = scratch("diverging.replay");
  engine::ReplayWriter writer(path, replay.header);
  for (std::size_t k = 0; k < replay.ticks.size(); ++k) {
    engine::StateHash state = replay.ticks[k].state;
    if (k + 1 == tick) {
      std::vector<engine::StatePart> parts(state.parts().begin(), state.parts().end());
      parts[part].hash ^= 1;
      state = engine::StateHash(parts, state.combined() ^ 1);
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
  EXPECT_NE(cord.output.find("ran 200 ticks"), std::string::npos) << cord.output;  // and there it stops
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

TEST(ReplayProgram, AKilledGameLeavesAReplayUpToItsLastTick) {
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

/// As many bytes of a file as the recording of a few dozen ticks has, then the disk is full.
constexpr const char* small_disk = "ulimit -f 8;";  // blocks of 512 bytes

std::size_t ticks_kept(const std::string& path) {
  const engine::Replay left = engine::load_replay(path);
  EXPECT_FALSE(left.complete);
  EXPECT_GT(left.ticks.size(), 10U);
  const Ended ended = ropeswing("--headless --verify --replay " + path);
  EXPECT_EQ(last_line(ended.output), "cut short after " + std::to_string(left.ticks.size()) + " ticks");
  return left.ticks.size();
}

TEST(ReplayProgram, AFullDiskIsToldAndTheTicksBeforeAreKept) {
  const std::string path = scratch("full.replay");
  const Ended ended = ropeswing("--headless --ticks 200 --record " + path, small_disk);
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.output, "ropeswing: " + path + ": cannot write the replay: File too large; the file keeps the " +
                              std::to_string(ticks_kept(path)) + " ticks before\n");
  const Ended nothing = ropeswing("--headless --ticks 3 --record /dev/full");
  EXPECT_EQ(nothing.status, 2);
  EXPECT_EQ(nothing.output, "ropeswing: /dev/full: cannot write the replay: No space left on device\n");
}

TEST(ReplayProgram, WhoPlaysGoesOnWhenTheDiskIsFull) {
  const std::string path = scratch("full_window.replay");
  const Ended ended = ropeswing("--ticks 60 --record " + path, std::string(small_disk) + " SDL_VIDEODRIVER=dummy");
  EXPECT_EQ(ended.status, 2);
  const std::size_t told = ended.output.find("cannot write the replay: File too large");
  ASSERT_NE(told, std::string::npos) << ended.output;
  EXPECT_EQ(ended.output.find("cannot write", told + 1), std::string::npos) << "once is enough: " << ended.output;
  const Ended whole = ropeswing("--headless --ticks 60");  // the same inputs: none
  EXPECT_EQ(last_line(ended.output), last_line(whole.output)) << "it did not run to its end";
  ticks_kept(path);
}

TEST(ReplayProgram, ARecordingCutShortIsMadeWholeByRecordingItAnew) {
  const std::string cut = scratch("cut_again.replay");
  const std::string whole = scratch("whole_again.replay");
  const std::string bytes = bytes_of(golden());
  write_bytes(cut, bytes.substr(0, bytes.size() / 3));
  EXPECT_EQ(ropeswing("--headless --replay " + cut + " --record " + whole).status, 0);
  const engine::Replay before = engine::load_replay(cut);
  const engine::Replay after = engine::load_replay(whole);
  EXPECT_TRUE(after.complete);
  EXPECT_GT(after.ticks.size(), 100U);
  EXPECT_TRUE(after.ticks == before.ticks);
}

/// A recording is emptied for a new one only when nothing else can keep that from starting.
TEST(ReplayProgram, ARunThatCannotStartLeavesTheRecordingOfTheLastAlone) {
  const std::string path = scratch("earlier.replay");
  const std::string level = scratch("broken.tmj");
  const std::string replay = scratch("broken.replay");
  write_bytes(level, "{}");
  write_bytes(replay, bytes_of(golden()).substr(0, 40));
  write_bytes(path, bytes_of(golden()));
  const std::string record = " --record " + path;
  EXPECT_EQ(ropeswing("--headless" + record).status, 2);  // without an end
  EXPECT_EQ(ropeswing("--headless --ticks 5 --level " + level + record).status, 2);
  EXPECT_EQ(ropeswing("--headless --replay " + replay + record).status, 2);
  EXPECT_EQ(ropeswing(record, "env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11").status, 2);
  EXPECT_TRUE(bytes_of(path) == bytes_of(golden()));
}

/// A process of this test's own, ended with it.
class Process {
 public:
  /// `command` is run by sh; the last program in it should be exec'ed, so that signals reach it.
  explicit Process(const std::string& command) : id_(fork()) {
    if (id_ != 0) return;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (status_) return;
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }

  void send(int signal) const { kill(id_, signal); }
  /// Whether it runs on; looked at again and again, a millisecond apart.
  bool runs() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = status;
    usleep(1000);
    return !status_;
  }
  /// What it ended with: the exit status, or −1 if a signal ended it.
  int wait() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, 0) == id_) status_ = status;
    return status_ && WIFEXITED(*status_) ? WEXITSTATUS(*status_) : -1;
  }

 private:
  pid_t id_;
  std::optional<int> status_;
};

/// Until the game is in the middle of a recording. False if it ended instead.
bool is_recording(Process& game, const std::string& path) {
  while (!fs::exists(path) || fs::file_size(path) < 5'000) {
    if (!game.runs()) return false;
  }
  return true;
}

/// That it holds a good part of a second, with its end marked, and verifies.
void expect_complete(const std::string& path) {
  const engine::Replay replay = engine::load_replay(path);
  EXPECT_TRUE(replay.complete);
  EXPECT_GT(replay.ticks.size(), 20U);
  EXPECT_EQ(ropeswing("--headless --verify --replay " + path).status, 0);
}

TEST(ReplayProgram, AWindowThatIsAskedToEndCompletesItsRecording) {
  for (const int signal : {SIGTERM, SIGINT}) {
    const std::string path = scratch("asked.replay");
    fs::remove(path);
    Process game("SDL_VIDEODRIVER=dummy exec " TEST_ROPESWING " --record " + path + " >/dev/null");
    ASSERT_TRUE(is_recording(game, path));
    game.send(signal);
    EXPECT_EQ(game.wait(), 0);
    expect_complete(path);
  }
}

TEST(ReplayProgram, WhenTheDisplayIsLostTheGameEndsWithItsRecordingComplete) {
  if (std::system("command -v Xvfb >/dev/null") != 0) GTEST_SKIP() << "Xvfb is not installed";
  for (const char* const renderer : {"software", "opengl"}) {
    SCOPED_TRACE(renderer);
    const std::string number = scratch("display");
    const std::string path = scratch("lost.replay");
    const std::string said = scratch("lost.txt");
    fs::remove(path);
    fs::remove(number);
    Process server("exec Xvfb -displayfd 3 -screen 0 640x480x24 3>" + number + " 2>/dev/null");
    while (bytes_of(number).find('\n') == std::string::npos) ASSERT_TRUE(server.runs());
    const std::string display = bytes_of(number).substr(0, bytes_of(number).find('\n'));
    // The libraries of a display are not ours to hold to account for what they leave behind.
    Process game("ASAN_OPTIONS=detect_leaks=0 SDL_VIDEODRIVER=x11 SDL_RENDER_DRIVER=" + std::string(renderer) +
                 " DISPLAY=:" + display + " exec " TEST_ROPESWING " --record " + path + " >" + said + " 2>&1");
    ASSERT_TRUE(is_recording(game, path)) << bytes_of(said);
    server.send(SIGKILL);
    EXPECT_EQ(game.wait(), 2);
    EXPECT_EQ(bytes_of(said), "ropeswing: the display was lost: the X server that showed the window has gone\n");
    expect_complete(path);
  }
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

TEST(Program, NamesTheFolderThatHasNoLevels) {
  const Ended ended = ropeswing("--headless --ticks 1", "ROPESWING_ASSETS=/no/such/folder");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.output.find("no level \"first_swing\""), std::string::npos) << ended.output;
  EXPECT_NE(ended.output.find("there are no levels in \"/no/such/folder/levels\": ROPESWING_ASSETS"), std::string::npos)
      << ended.output;
}

/// first_swing with some text in its place.
std::string changed_level(const std::string& text, const std::string& by) {
  std::string level = bytes_of(TEST_ASSETS "/levels/first_swing.tmj");
  const std::size_t at = level.find(text);
  if (at == std::string::npos) return {};
  return level.replace(at, text.size(), by);
}

TEST(Program, ALevelThatCannotBeReadOrLacksAnObjectIsRefusedBySentence) {
  const auto refused = [](const std::string& level, const std::string& about) {
    const std::string path = scratch("lacking.tmj");
    write_bytes(path, level);
    const Ended ended = ropeswing("--headless --ticks 1 --level " + path);
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.output.find(path), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find(about), std::string::npos) << ended.output;
  };
  refused("", "not valid JSON");
  refused(bytes_of(TEST_ASSETS "/levels/first_swing.tmj").substr(0, 3000), "not valid JSON");
  refused(changed_level("\"type\": \"player\"", "\"type\": \"ground\""),
          "no object of class player; a level needs one");
  refused(changed_level("\"type\": \"goal\"", "\"type\": \"player\""), "is a second player; accepted is one a level");
  refused(changed_level("\"type\": \"cord\"", "\"type\":\"chord\""),
          "class is \"chord\"; accepted is ground, circle, cord");
}

/// As many objects as a file may hold: refused, and not after minutes.
TEST(Program, AHundredThousandObjectsAreRefusedAtOnce) {
  const auto refused = [](const std::string& level, const std::string& about) {
    const std::string path = scratch("crowded.tmj");
    write_bytes(path, level);
    const Ended ended = ropeswing("--headless --ticks 1 --level " + path, "ulimit -t 60;");  // s, of the processor
    EXPECT_EQ(ended.status, 2) << ended.output;
    EXPECT_NE(ended.output.find(about), std::string::npos) << ended.output;
  };
  const std::string head =
      R"({"type":"map","orientation":"orthogonal","width":9,"height":9,"tilewidth":9,"tileheight":9,"layers":[)";
  std::string objects = R"({"id":1,"class":"player","x":0,"y":0,"point":true},)"
                        R"({"id":2,"class":"goal","x":0,"y":0,"width":1,"height":1})";
  for (int id = 3; id <= 100'000; ++id) {
    objects += R"(,{"id":)" + std::to_string(id) + R"(,"x":0,"y":0,"point":true})";
  }
  refused(head + R"({"type":"objectgroup","objects":[)" + objects + "]}]}",
          "the map has 100000 objects; accepted are at most 2000");
  std::string layers;
  for (int k = 0; k < 1'390'000; ++k) layers += k == 0 ? "{}" : ",{}";
  refused(head + layers + "]}", "\"type\" is missing, accepted is a text");
}

TEST(Program, SaysWithItsStatusThatNobodyCouldReadItsOutput) {
  EXPECT_EQ(ropeswing("--headless --ticks 1 >/dev/full").status, 2);
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
