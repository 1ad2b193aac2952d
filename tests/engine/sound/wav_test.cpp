#include "engine/sound/wav.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/refusal.h"

namespace {

using engine::parse_wav;
using engine::Sound;
using engine::wav_of;

std::string refusal(const std::string& bytes) {
  return test_support::refusal<engine::SoundError>([&] { parse_wav(bytes, "a.wav"); });
}

std::string small_wav() { return wav_of({22050, {0.0F, 0.5F, -0.5F, 1.0F, -1.0F}}); }

std::string with(std::string bytes, std::size_t at, char value) {
  bytes[at] = value;
  return bytes;
}

TEST(Wav, ReadsWhatItWrites) {
  const Sound sound = parse_wav(small_wav(), "a.wav");
  EXPECT_EQ(sound.rate, 22050);
  ASSERT_EQ(sound.samples.size(), 5U);
  EXPECT_NEAR(sound.samples[1], 0.5F, 2e-5F);
  EXPECT_EQ(sound.samples[3], 1.0F);
  EXPECT_EQ(sound.samples[4], -1.0F);
  EXPECT_EQ(wav_of(sound), small_wav());
}

TEST(Wav, ClipsLoudSamples) {
  const Sound sound = parse_wav(wav_of({22050, {3.0F, -3.0F}}), "a.wav");
  EXPECT_EQ(sound.samples, (std::vector<float>{1.0F, -1.0F}));
}

TEST(Wav, SkipsOtherChunks) {
  std::string bytes = small_wav();
  bytes.insert(36, std::string("LIST\x03\0\0\0abc\0", 12));  // an odd one, padded
  EXPECT_EQ(parse_wav(bytes, "a.wav").samples.size(), 5U);
}

TEST(Wav, RefusesEveryTruncatedFile) {
  const std::string bytes = small_wav();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(refusal(bytes.substr(0, size)).rfind("a.wav: ", 0), 0U) << size;
  }
}

TEST(Wav, RefusesOtherFormatsByName) {
  EXPECT_NE(refusal(with(small_wav(), 20, 3)).find("not plain PCM"), std::string::npos);
  EXPECT_NE(refusal(with(small_wav(), 22, 2)).find("2 channels"), std::string::npos);
  EXPECT_NE(refusal(with(small_wav(), 34, 8)).find("8 bits a sample"), std::string::npos);
  EXPECT_NE(refusal(with(small_wav(), 25, 0)).find("34 samples a second"), std::string::npos);
  EXPECT_NE(refusal("not at all").find("accepted is a WAV file of one channel"), std::string::npos);
}

TEST(Wav, AMissingFileAndAFolderAreRefused) {
  EXPECT_THROW(engine::load_wav("/no/such/file.wav"), engine::SoundError);
  EXPECT_THROW(engine::load_wav("/"), engine::SoundError);
}

}  // namespace
