// Videos of runs, from the command line and from the window, with a substitute for ffmpeg.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "game/program/film.h"
#include "tests/game/program.h"
#include "tests/support/environment.h"

namespace {

using namespace test_support;

/// A folder to put before PATH, with an ffmpeg that saves its input.
std::string fake_ffmpeg() {
  std::string folder = scratch("ffmpeg_folder");
  fs::create_directories(folder);
  write_bytes(folder + "/ffmpeg", "#!/bin/sh\nfor last; do :; done\ncat > \"${last#file:}\"\n");
  fs::permissions(folder + "/ffmpeg", fs::perms::owner_all);
  return folder;
}

std::string found_first(const std::string& folder) { return "PATH=" + folder + ":$PATH"; }

TEST(Video, HasThirtyFramesASecondAndChangesNoBitOfTheRun) {
  const std::string path = scratch("run.gif");
  const std::string arguments = "--headless --ticks 60 --replay " + golden();
  const Ended ended = ropeswing(arguments + " --video " + path + " --video-size 64x36", found_first(fake_ffmpeg()));
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(fs::file_size(path), 30U * 64 * 36 * 4);
  EXPECT_NE(ended.output.find("video of 30 frames: " + path), std::string::npos) << ended.output;
  EXPECT_EQ(last_line(ended.output), last_line(ropeswing(arguments).output));
  const std::string bytes = bytes_of(path);
  EXPECT_NE(bytes.substr(0, 64 * 36 * 4), bytes.substr(bytes.size() - 64 * 36 * 4)) << "it stands still";
}

TEST(Video, StartsAtTheSoughtTickWithTheDefaultSize) {
  const std::string path = scratch("later.mp4");
  const Ended ended = ropeswing("--headless --seek 300 --ticks 320 --replay " + golden() + " --video " + path,
                                found_first(fake_ffmpeg()));
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(fs::file_size(path), 10U * 480 * 270 * 4);
}

TEST(Video, InvalidArgumentsAreRefusedWithAMessage) {
  const std::string run = "--headless --ticks 10 --video ";
  const Ended missing = ropeswing(run + scratch("a.gif"), "PATH=/no/such/folder");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.output.find("the program ffmpeg is not installed"), std::string::npos) << missing.output;
  const Ended ending = ropeswing(run + scratch("a.avi"));
  EXPECT_EQ(ending.status, 2);
  EXPECT_NE(ending.output.find(".gif or .mp4"), std::string::npos) << ending.output;
  for (const char* size : {"64", "64x", "x64", "64x36x2", "0x10", "64x99999", "64.5x36", "-64x36"}) {
    const Ended refused = ropeswing(run + scratch("a.gif") + " --video-size=" + size);
    EXPECT_EQ(refused.status, 2) << size;
    EXPECT_NE(refused.output.find("480x270"), std::string::npos) << refused.output;
  }
  EXPECT_EQ(ropeswing("--ticks 10 --video " + scratch("a.gif")).status, 2) << "in a window a key does it";
  EXPECT_EQ(ropeswing(run + scratch("a.gif") + " --screenshot " + scratch("a.gif")).status, 2);
}

TEST(Video, AnFfmpegThatFailsFailsTheProgram) {
  const std::string folder = fake_ffmpeg();
  write_bytes(folder + "/ffmpeg", "#!/bin/sh\necho 'disk full' >&2\nexit 1\n");
  const Ended ended = ropeswing("--headless --ticks 600 --video " + scratch("b.gif"), found_first(folder));
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.output.find("disk full"), std::string::npos) << ended.output;
}

TEST(Film, TakesThirtyFramesASecond) {
  const std::string folder = fake_ffmpeg();
  const Environment path("PATH", (folder + ":" + std::getenv("PATH")).c_str());
  const std::string videos = scratch("new") + "/videos";
  fs::remove_all(videos);
  const engine::Raster raster(64, 36);
  game::Film film(videos);
  EXPECT_EQ(film.take(raster, 1'000'000'000), "");
  EXPECT_EQ(film.toggle(raster), "Recording a video to " + videos + "/ropeswing-1.mp4");
  for (int frame = 0; frame < 144; ++frame) EXPECT_EQ(film.take(raster, 1'000'000'000 / 144), "");
  EXPECT_EQ(film.toggle(raster), "Video: ropeswing-1.mp4");
  EXPECT_NEAR(static_cast<double>(fs::file_size(videos + "/ropeswing-1.mp4")), 31.0 * 64 * 36 * 4, 64 * 36 * 4);

  film.toggle(raster);
  EXPECT_EQ(film.take(engine::Raster(70, 36), 1'000'000), "The window has another size now; video: ropeswing-2.mp4");
  EXPECT_FALSE(film.is_running());
}

TEST(Film, ReportsAFolderThatCannotBeMade) {
  const engine::Raster raster(64, 36);
  game::Film nowhere("/proc/nowhere");
  const std::string said = nowhere.toggle(raster);
  EXPECT_NE(said.find("/proc/nowhere"), std::string::npos) << said;
  EXPECT_FALSE(nowhere.is_running());
  game::Film homeless("");
  EXPECT_EQ(homeless.toggle(raster), "No video: there is no home folder for it");
}

}  // namespace
