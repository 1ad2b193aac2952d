// Failures around the program: disk, display, level, signals.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "engine/replay/replay.h"
#include "tests/game/process.h"
#include "tests/game/program.h"

namespace {

using namespace test_support;

/// A file may have as many bytes as the recording of a few dozen ticks; then the disk is full.
/// (The counters of tests/run --coverage would not fit either.)
constexpr const char* small_disk = "ulimit -f 8; LLVM_PROFILE_FILE=/dev/null";  // blocks of 512 bytes

std::size_t ticks_kept(const std::string& path) {
  const engine::Replay left = engine::load_replay(path);
  EXPECT_FALSE(left.complete);
  EXPECT_GT(left.ticks.size(), 10U);
  const Ended ended = ropeswing("--headless --verify --replay " + path);
  EXPECT_EQ(last_line(ended.output), "cut short after " + std::to_string(left.ticks.size()) + " ticks");
  return left.ticks.size();
}

TEST(ReplayFaults, AFullDiskIsReportedAndEarlierTicksAreSaved) {
  const std::string path = scratch("full.replay");
  const Ended ended = ropeswing("--headless --ticks 200 --record " + path, small_disk);
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.output, "ropeswing: " + path + ": cannot write the replay: File too large; the file keeps the " +
                              std::to_string(ticks_kept(path)) + " ticks before\n");
  const Ended nothing = ropeswing("--headless --ticks 3 --record /dev/full");
  EXPECT_EQ(nothing.status, 2);
  EXPECT_EQ(nothing.output, "ropeswing: /dev/full: cannot write the replay: No space left on device\n");
}

TEST(ReplayFaults, TheGameContinuesWhenTheDiskIsFull) {
  const std::string path = scratch("full_window.replay");
  const Ended ended = ropeswing("--ticks 60 --record " + path, std::string(small_disk) + " SDL_VIDEODRIVER=dummy");
  EXPECT_EQ(ended.status, 2);
  const std::size_t told = ended.output.find("cannot write the replay: File too large");
  ASSERT_NE(told, std::string::npos) << ended.output;
  EXPECT_EQ(ended.output.find("cannot write", told + 1), std::string::npos) << "once is enough: " << ended.output;
  const Ended whole = ropeswing("--headless --ticks 60");  // also without inputs
  EXPECT_EQ(last_line(ended.output), last_line(whole.output)) << "it did not run to its end";
  ticks_kept(path);
}

TEST(ReplayFaults, ATruncatedRecordingIsCompletedByRecordingItAgain) {
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

/// An old recording is emptied only after everything else that can fail at the start.
TEST(ReplayFaults, ARunThatCannotStartKeepsTheEarlierRecording) {
  const std::string path = scratch("earlier.replay");
  const std::string level = scratch("broken.tmj");
  const std::string replay = scratch("broken.replay");
  write_bytes(level, "{}");
  write_bytes(replay, bytes_of(golden()).substr(0, 40));
  write_bytes(path, bytes_of(golden()));
  const std::string record = " --record " + path;
  EXPECT_EQ(ropeswing("--headless" + record).status, 2);  // no end is given
  EXPECT_EQ(ropeswing("--headless --ticks 5 --level " + level + record).status, 2);
  EXPECT_EQ(ropeswing("--headless --replay " + replay + record).status, 2);
  EXPECT_EQ(ropeswing(record, "env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11").status, 2);
  EXPECT_TRUE(bytes_of(path) == bytes_of(golden()));
}

/// Waits until the game is in the middle of a recording. Returns false if it ended instead.
bool is_recording(Process& game, const std::string& path) {
  while (!fs::exists(path) || fs::file_size(path) < 5'000) {
    if (!game.runs()) return false;
  }
  return true;
}

/// Checks that the recording has most of a second, has its end marker, and verifies.
void expect_complete(const std::string& path) {
  const engine::Replay replay = engine::load_replay(path);
  EXPECT_TRUE(replay.complete);
  EXPECT_GT(replay.ticks.size(), 20U);
  EXPECT_EQ(ropeswing("--headless --verify --replay " + path).status, 0);
}

TEST(ReplayFaults, AWindowThatIsAskedToEndCompletesItsRecording) {
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

TEST(ReplayFaults, WhenTheDisplayIsLostTheGameEndsWithItsRecordingComplete) {
  if (std::system("command -v Xvfb >/dev/null") != 0) GTEST_SKIP() << "Xvfb is not installed";
  for (const char* const renderer : {"software", "opengl"}) {
    SCOPED_TRACE(renderer);
    const std::string path = scratch("lost.replay");
    const std::string said = scratch("lost.txt");
    fs::remove(path);
    XServer server("640x480x24");
    ASSERT_TRUE(server.starts());
    // Leaks of the display's libraries are ignored.
    std::ostringstream command;
    command << "ASAN_OPTIONS=detect_leaks=0 SDL_AUDIODRIVER=dummy SDL_VIDEODRIVER=x11 SDL_RENDER_DRIVER=" << renderer
            << " DISPLAY=" << server.display() << " exec " TEST_ROPESWING " --record " << path << " >" << said
            << " 2>&1";
    Process game(command.str());
    ASSERT_TRUE(is_recording(game, path)) << bytes_of(said);
    server.send(SIGKILL);
    EXPECT_EQ(game.wait(), 2);
    EXPECT_EQ(bytes_of(said), "ropeswing: the display was lost: the X server that showed the window has gone\n");
    expect_complete(path);
  }
}

TEST(ProgramFaults, NamesTheFolderThatHasNoLevels) {
  const Ended ended = ropeswing("--headless --ticks 1", "ROPESWING_ASSETS=/no/such/folder");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.output.find("no level \"first_swing\""), std::string::npos) << ended.output;
  EXPECT_NE(ended.output.find("there are no levels in \"/no/such/folder/levels\": ROPESWING_ASSETS"), std::string::npos)
      << ended.output;
}

/// first_swing with one text replaced by another.
std::string changed_level(const std::string& text, const std::string& by) {
  std::string level = bytes_of(TEST_ASSETS "/levels/first_swing.tmj");
  const std::size_t at = level.find(text);
  if (at == std::string::npos) return {};
  return level.replace(at, text.size(), by);
}

TEST(ProgramFaults, AnUnreadableOrIncompleteLevelIsRefusedWithAMessage) {
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

/// A file with as many objects as possible is refused within seconds.
TEST(ProgramFaults, AHundredThousandObjectsAreRefusedAtOnce) {
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

TEST(ProgramFaults, ReportsUnwrittenOutputByItsStatus) {
  EXPECT_EQ(ropeswing("--headless --ticks 1 >/dev/full").status, 2);
}

}  // namespace
