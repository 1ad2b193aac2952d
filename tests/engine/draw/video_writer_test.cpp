// Videos by a substitute for ffmpeg: a script of the test.

#include "engine/draw/video_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/environment.h"
#include "tests/support/files.h"
#include "tests/support/refusal.h"

namespace {

namespace fs = std::filesystem;
using engine::VideoError;
using engine::VideoWriter;
using test_support::bytes_of;
using test_support::Environment;
using test_support::refusal;

/// A folder with a program ffmpeg; PATH has only this folder and those of the shell.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const std::string& script) : path_("PATH", (folder_ + ":/usr/bin:/bin").c_str()) {
    fs::create_directories(folder_);
    std::ofstream(folder_ + "/ffmpeg") << "#!/bin/sh\nfor last; do :; done\nout=${last#file:}\n" << script << "\n";
    fs::permissions(folder_ + "/ffmpeg", fs::perms::owner_all);
  }
  FakeFfmpeg(const FakeFfmpeg&) = delete;
  FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;
  ~FakeFfmpeg() { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return folder_ + "/" + name; }

 private:
  std::string folder_ = testing::TempDir() + "ffmpeg_" + std::to_string(getpid());
  Environment path_;
};

const std::vector<std::uint32_t>& frame() {
  static const std::vector<std::uint32_t> pixels(std::size_t{64} * 32, 0x00112233U);
  return pixels;
}

TEST(VideoWriter, FfmpegReceivesItsArgumentsAndEveryFrame) {
  const FakeFfmpeg ffmpeg(R"(echo "$@" > "$out.arguments"; cat > "$out")");
  const std::string path = ffmpeg.file("a.gif");
  VideoWriter writer(path, 64, 32);
  for (int k = 0; k < 100; ++k) writer.write(frame());
  writer.finish();
  EXPECT_EQ(fs::file_size(path), 100U * 64 * 32 * 4);
  EXPECT_EQ(bytes_of(path).substr(0, 4), std::string("\x33\x22\x11\x00", 4)) << "blue first";
  const std::string arguments = bytes_of(path + ".arguments");
  EXPECT_NE(arguments.find("-s 64x32 -framerate 30 -i pipe:0"), std::string::npos) << arguments;
  EXPECT_NE(arguments.find("paletteuse"), std::string::npos) << arguments;
}

TEST(VideoWriter, TheExtensionSelectsTheFormat) {
  const FakeFfmpeg ffmpeg(R"(echo "$@" > "$out"; cat > /dev/null)");
  const std::string path = ffmpeg.file("a.mp4");
  VideoWriter(path, 64, 32).finish();
  EXPECT_NE(bytes_of(path).find("libx264"), std::string::npos);
  EXPECT_EQ(bytes_of(path).find("palette"), std::string::npos);
  const std::string refused = refusal<VideoError>([&] { VideoWriter(ffmpeg.file("a.avi"), 64, 32); });
  EXPECT_NE(refused.find("a.avi"), std::string::npos) << refused;
  EXPECT_NE(refused.find(".gif or .mp4"), std::string::npos) << refused;
  EXPECT_NE(refusal<VideoError>([&] { VideoWriter(path, 0, 32); }).find("0 x 32 pixels"), std::string::npos);
}

TEST(VideoWriter, ANameThatStartsLikeAnOptionIsAFile) {
  const FakeFfmpeg ffmpeg(R"(echo "$last" > )" + testing::TempDir() + "ffmpeg_name; cat > /dev/null");
  VideoWriter("-y.gif", 64, 32).finish();
  EXPECT_EQ(bytes_of(testing::TempDir() + "ffmpeg_name"), "file:-y.gif\n");
  fs::remove(testing::TempDir() + "ffmpeg_name");
}

TEST(VideoWriter, ReportsThatFfmpegIsMissing) {
  const Environment path("PATH", "/no/such/folder");
  EXPECT_EQ(refusal<VideoError>([] { VideoWriter("a.gif", 64, 32); }),
            "cannot write the video a.gif: the program ffmpeg is not installed");
}

TEST(VideoWriter, TheMessageOfFfmpegIsReportedWhenItFails) {
  const FakeFfmpeg ffmpeg("cat > /dev/null; echo one thing >&2; echo 'no space left' >&2; exit 3");
  VideoWriter writer(ffmpeg.file("a.gif"), 64, 32);
  writer.write(frame());
  const std::string message = refusal<VideoError>([&] { writer.finish(); });
  EXPECT_NE(message.find("status 3: no space left"), std::string::npos) << message;
}

TEST(VideoWriter, AnFfmpegThatExitsEarlyIsAnErrorAndNotASignal) {
  std::signal(SIGPIPE, SIG_DFL);  // which would end the test
  const FakeFfmpeg ffmpeg("echo 'had enough' >&2; exit 1");
  VideoWriter writer(ffmpeg.file("a.gif"), 64, 32);
  const std::string message = refusal<VideoError>([&] {
    for (int k = 0; k < 100'000; ++k) writer.write(frame());
  });
  EXPECT_NE(message.find("status 1: had enough"), std::string::npos) << message;
}

TEST(VideoWriter, AnAbortedWriterLeavesNoProcess) {
  const FakeFfmpeg ffmpeg(R"(cat > /dev/null; echo ended > "$out")");
  const std::string path = ffmpeg.file("a.gif");
  { VideoWriter(path, 64, 32).write(frame()); }
  EXPECT_EQ(bytes_of(path), "ended\n") << "it was not waited for";
}

TEST(VideoWriter, TheRealFfmpegMakesVideos) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  for (const char* name : {"real.gif", "real.mp4"}) {
    const std::string path = testing::TempDir() + std::to_string(getpid()) + name;
    VideoWriter writer(path, 65, 33);  // sizes that H.264 does not have
    const std::vector<std::uint32_t> pixels(std::size_t{65} * 33, 0x00336699U);
    for (int k = 0; k < 30; ++k) writer.write(pixels);
    writer.finish();
    const std::string bytes = bytes_of(path);
    EXPECT_TRUE(bytes.starts_with("GIF89a") || bytes.substr(4, 4) == "ftyp") << path;
    fs::remove(path);
  }
}

}  // namespace
