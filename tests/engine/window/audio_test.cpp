// The sound device; SDL's disk driver writes to a file instead.

#include "engine/window/sdl_audio.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>

#include "tests/support/disk_audio.h"
#include "tests/support/environment.h"

namespace {

namespace fs = std::filesystem;
using engine::Audio;
using test_support::Environment;

engine::Sound half_a_second(float level) { return {Audio::rate, std::vector<float>(Audio::rate / 2, level)}; }

/// A file that is removed after the test.
struct Recorded {
  std::string path = testing::TempDir() + "audio_" + std::to_string(getpid()) + ".raw";
  Environment driver{"SDL_AUDIODRIVER", "disk"};
  Environment file{"SDL_DISKAUDIOFILE", path.c_str()};
  Environment delay{"SDL_DISKAUDIODELAY", "1"};  // ms a block: faster than real time
  Recorded() = default;
  Recorded(const Recorded&) = delete;
  Recorded& operator=(const Recorded&) = delete;
  ~Recorded() { fs::remove(path); }

  /// Waits until `more` further bytes are written.
  void wait_for(std::uintmax_t bytes) const {
    const std::uintmax_t start = fs::file_size(path);
    while (fs::file_size(path) < start + bytes) usleep(1000);
  }
};

constexpr std::uintmax_t second = std::uintmax_t{Audio::rate} * 2 * sizeof(float);

TEST(Audio, PlaysASoundAtItsVolume) {
  for (const double volume : {1.0, 0.25}) {
    const Recorded recorded;
    {
      Audio audio;
      ASSERT_TRUE(audio.has_device()) << audio.why_silent();
      EXPECT_EQ(audio.why_silent(), "");
      audio.play(audio.add(half_a_second(0.6F)), {volume, -1.0, 1.0});
      recorded.wait_for(second);
    }
    EXPECT_NEAR(test_support::peak(test_support::left_channel(recorded.path)), 0.6 * volume, 1e-3);
  }
}

TEST(Audio, IsSilentWhenMuted) {
  const Recorded recorded;
  {
    Audio audio;
    audio.set_volume(0.0);
    recorded.wait_for(second / 2);  // until the fade-out ends
    const engine::SoundId sound = audio.add(half_a_second(0.6F));
    audio.set_loop(audio.start_loop(sound), {});
    audio.play(sound);
    recorded.wait_for(second / 2);
  }
  EXPECT_EQ(test_support::peak(test_support::left_channel(recorded.path)), 0.0);
}

/// Checks that nothing throws or blocks.
void use(Audio& audio) {
  const engine::SoundId sound = audio.add(half_a_second(0.6F));
  const engine::LoopId loop = audio.start_loop(sound);
  for (int k = 0; k < 100; ++k) audio.play(sound);
  audio.set_loop(loop, {0.5, 0.0, 1.0});
  audio.set_volume(0.3);
  audio.fade_out();
}

TEST(Audio, WithoutADeviceReportsWhyAndContinues) {
  const Environment driver("SDL_AUDIODRIVER", "none_of_that_name");
  Audio audio;
  EXPECT_FALSE(audio.has_device());
  EXPECT_EQ(audio.why_silent().rfind("there is no sound: ", 0), 0U) << audio.why_silent();
  EXPECT_GT(audio.why_silent().size(), 25U);
  use(audio);
  EXPECT_FALSE(audio.reopen_if_lost());
}

TEST(Audio, ReopensADeviceThatWasLostWhilePlaying) {
  const Environment driver("SDL_AUDIODRIVER", "disk");
  const Environment delay("SDL_DISKAUDIODELAY", "1");
  std::optional<Environment> file;
  file.emplace("SDL_DISKAUDIOFILE", "/dev/full");  // SDL's disk driver then reports that the device is lost
  Audio audio;
  ASSERT_EQ(audio.why_silent().find("there is no sound"), std::string::npos)
      << "it was there, if it is not lost by now";
  use(audio);
  while (audio.has_device()) usleep(1000);
  EXPECT_EQ(audio.why_silent(), "the sound device was lost");
  use(audio);
  file.reset();
  const Recorded recorded;
  EXPECT_TRUE(audio.reopen_if_lost());
  EXPECT_FALSE(audio.reopen_if_lost()) << "there is one";
  audio.set_volume(1.0);
  audio.play(audio.add(half_a_second(0.6F)), {1.0, -1.0, 1.0});
  recorded.wait_for(second);
  EXPECT_GT(test_support::peak(test_support::left_channel(recorded.path)), 0.5);
}

}  // namespace
