// The sound of the program; SDL's disk driver writes it to a file.

#include <gtest/gtest.h>

#include <string>

#include "tests/game/program.h"
#include "tests/support/disk_audio.h"

namespace {

using namespace test_support;

std::string audio_to(const std::string& path) {
  return "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=" + path;
}

TEST(Sound, ARunInAWindowPlaysSounds) {
  const std::string path = scratch("run.raw");
  const Ended ended = ropeswing("--replay " + golden() + " --seek 60 --ticks 150", audio_to(path));
  EXPECT_EQ(ended.status, 0) << ended.output;
  const auto samples = left_channel(path);
  EXPECT_GT(samples.size(), 44100U);
  EXPECT_GT(rms(samples), 0.005);
  EXPECT_LT(peak(samples), 1.0);
}

TEST(Sound, WithoutADeviceTheGameReportsItAndRunsToTheSameEnd) {
  const Ended silent = ropeswing("--ticks 30", "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=none_of_that_name");
  EXPECT_EQ(silent.status, 0);
  EXPECT_NE(silent.output.find("there is no sound: "), std::string::npos) << silent.output;
  EXPECT_EQ(last_line(silent.output), last_line(ropeswing("--headless --ticks 30").output));
}

TEST(Sound, ADeviceLostWhilePlayingDoesNotEndTheGame) {
  const Ended ended = ropeswing("--ticks 60", audio_to("/dev/full"));
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(last_line(ended.output), last_line(ropeswing("--headless --ticks 60").output));
}

}  // namespace
