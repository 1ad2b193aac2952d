#include "engine/sound/mixer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/support/allocations.h"

namespace {

using engine::Mixer;
using engine::Sound;

constexpr int rate = 44100;

/// Whole periods of a tone at half of full scale.
Sound tone(double frequency, double seconds, double level = 0.5) {
  Sound sound{rate, {}};
  for (int k = 0; k < static_cast<int>(seconds * rate); ++k) {
    sound.samples.push_back(static_cast<float>(level * std::sin(2.0 * std::numbers::pi * frequency * k / rate)));
  }
  return sound;
}

struct Stereo {
  std::vector<double> left, right;
};

Stereo mix(Mixer& mixer, double seconds) {
  std::vector<float> samples(2 * static_cast<std::size_t>(seconds * rate));
  mixer.mix(samples);
  Stereo mixed;
  for (std::size_t k = 0; k < samples.size(); k += 2) {
    mixed.left.push_back(static_cast<double>(samples[k]));
    mixed.right.push_back(static_cast<double>(samples[k + 1]));
  }
  return mixed;
}

double rms(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double value : x) sum += value * value;
  return std::sqrt(sum / static_cast<double>(x.size()));
}

double greatest_step(const std::vector<double>& x) {
  double most = 0.0;
  for (std::size_t k = 1; k < x.size(); ++k) most = std::max(most, std::abs(x[k] - x[k - 1]));
  return most;
}

double peak(const std::vector<double>& x) {
  double most = 0.0;
  for (const double value : x) most = std::max(most, std::abs(value));
  return most;
}

int rising_zeros(const std::vector<double>& x) {
  int count = 0;
  for (std::size_t k = 1; k < x.size(); ++k) count += x[k - 1] < 0.0 && x[k] >= 0.0;
  return count;
}

double loudness(const engine::Playing& how) {
  Mixer mixer(rate);
  mixer.play(mixer.add(tone(440.0, 0.5)), how);
  return rms(mix(mixer, 0.4).left);
}

TEST(Mixer, IsSilentWithNothingToPlay) {
  Mixer mixer(rate);
  mixer.start_loop(mixer.add(tone(440.0, 0.5)));
  EXPECT_EQ(peak(mix(mixer, 0.1).left), 0.0);
}

TEST(Mixer, TwiceTheVolumeIsTwiceAsLoud) {
  EXPECT_NEAR(loudness({0.8}), 2.0 * loudness({0.4}), 1e-6);
  EXPECT_EQ(loudness({0.0}), 0.0);
}

TEST(Mixer, PanMovesASoundAndKeepsItsPower) {
  for (const double pan : {-1.0, -0.3, 0.0, 0.6, 1.0}) {
    Mixer mixer(rate);
    mixer.play(mixer.add(tone(440.0, 0.5)), {0.7, pan, 1.0});
    const Stereo mixed = mix(mixer, 0.4);
    const double power = rms(mixed.left) * rms(mixed.left) + rms(mixed.right) * rms(mixed.right);
    EXPECT_NEAR(power, 0.5 * 0.25 * 0.49, 1e-4) << pan;
    EXPECT_NEAR(rms(mixed.right) * rms(mixed.right) / power, 0.5 * (1.0 + pan), 1e-4) << pan;
  }
}

TEST(Mixer, PitchAndSampleRateSetTheSpeed) {
  Mixer mixer(rate);
  mixer.play(mixer.add(tone(440.0, 1.0)), {1.0, 0.0, 2.0});
  EXPECT_NEAR(rising_zeros(mix(mixer, 0.45).left), 0.45 * 880.0, 1.0);
  EXPECT_EQ(mixer.voices(), 1);
  mix(mixer, 0.1);
  EXPECT_EQ(mixer.voices(), 0) << "a second's sound at twice its pitch ends after half of it";

  Mixer half(rate / 2);
  half.play(half.add(tone(440.0, 1.0)));
  EXPECT_NEAR(rising_zeros(mix(half, 0.45).left), 0.9 * 440.0, 1.0) << "of 44100 a second these are 0.9 s";
}

TEST(Mixer, ALoopRepeatsWithoutAGap) {
  Mixer mixer(rate);
  const engine::LoopId loop = mixer.start_loop(mixer.add(tone(440.0, 0.1)));  // 44 whole turns
  mixer.set_loop(loop, {});
  mix(mixer, 0.2);  // until the fade-in ends
  const Stereo mixed = mix(mixer, 1.0);
  EXPECT_NEAR(rms(mixed.left), 0.5 * 0.5, 1e-3);
  EXPECT_LT(greatest_step(mixed.left), 1.01 * 0.5 * std::sqrt(0.5) * 2.0 * std::numbers::pi * 440.0 / rate);
}

TEST(Mixer, ALoopsVolumeNeverJumps) {
  Mixer mixer(rate);
  const engine::LoopId loop = mixer.start_loop(mixer.add({rate, std::vector<float>(4410, 0.5F)}));  // only the volume
  for (const double volume : {1.0, 0.0, 1.0, 0.3}) {
    mixer.set_loop(loop, {volume, 0.0, 1.0});
    const Stereo mixed = mix(mixer, 0.1);
    EXPECT_LT(greatest_step(mixed.left), 1e-3) << volume;
    EXPECT_NEAR(mixed.left.back(), 0.5 * volume * std::sqrt(0.5), 1e-3) << volume;
  }
}

TEST(Mixer, ASilentLoopContinuesAtItsPlace) {
  Mixer mixer(rate);
  std::vector<float> ramp(rate);
  for (std::size_t k = 0; k < ramp.size(); ++k) ramp[k] = 0.5F * static_cast<float>(k) / static_cast<float>(rate);
  const engine::LoopId loop = mixer.start_loop(mixer.add({rate, ramp}));
  mixer.set_loop(loop, {1.0, -1.0, 1.0});
  const double before = mix(mixer, 0.5).left.back();
  mixer.set_loop(loop, {0.0, -1.0, 1.0});
  mix(mixer, 0.2);                                                         // until it is silent
  for (int k = 0; k < 5; ++k) EXPECT_EQ(peak(mix(mixer, 0.1).left), 0.0);  // longer than the rest of the loop
  mixer.set_loop(loop, {1.0, -1.0, 1.0});
  const double after = mix(mixer, 0.1).left.back();
  EXPECT_GT(after, before + 0.05);
  EXPECT_LT(after, before + 0.2) << "0.3 s, which include the time of the fade later";
}

TEST(Mixer, FadesOutWhenMutedAndBackIn) {
  Mixer mixer(rate);
  mixer.set_loop(mixer.start_loop(mixer.add({rate, std::vector<float>(4410, 0.5F)})), {});
  mix(mixer, 0.2);
  mixer.set_volume(0.0);
  const Stereo fading = mix(mixer, 0.2);
  EXPECT_LT(greatest_step(fading.left), 1e-3);
  EXPECT_EQ(peak(mix(mixer, 0.1).left), 0.0);
  mixer.set_volume(1.0);
  EXPECT_GT(peak(mix(mixer, 0.1).left), 0.3);
}

TEST(Mixer, HushEndsSoundsWithoutAClick) {
  Mixer mixer(rate);
  mixer.play(mixer.add({rate, std::vector<float>(rate, 0.5F)}));
  mix(mixer, 0.1);
  mixer.fade_out();
  EXPECT_LT(greatest_step(mix(mixer, 0.2).left), 1e-3);
  EXPECT_EQ(mixer.voices(), 0);
}

TEST(Mixer, ManyLoudSoundsTogetherStayBelowFullScale) {
  Mixer mixer(rate);
  const engine::SoundId loud = mixer.add(tone(300.0, 0.5, 1.0));
  for (int k = 0; k < 20; ++k) mixer.play(loud, {4.0});
  const Stereo mixed = mix(mixer, 0.3);
  EXPECT_LT(peak(mixed.left), 1.0);
  EXPECT_GT(peak(mixed.left), 0.95);
}

TEST(Mixer, DoesNotDistortQuietSounds) {
  const auto peak_of = [](double level) {
    Mixer mixer(rate);
    mixer.play(mixer.add(tone(300.0, 0.5, level)), {1.0, -1.0, 1.0});
    return peak(mix(mixer, 0.4).left);
  };
  EXPECT_NEAR(peak_of(0.65), 0.65, 1e-4);
  EXPECT_GT(peak_of(0.9), 0.75);
  EXPECT_LT(peak_of(0.9), 0.85);
}

TEST(Mixer, OneSoundTooManyEndsTheOldest) {
  Mixer mixer(rate);
  const engine::SoundId sound = mixer.add(tone(300.0, 1.0));
  for (int k = 0; k < 3 * Mixer::max_voices; ++k) mixer.play(sound, {0.01});
  EXPECT_EQ(mixer.voices(), Mixer::max_voices);
  mix(mixer, 0.1);
}

TEST(Mixer, InvalidNumbersAreHarmless) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Mixer mixer(rate);
  const engine::SoundId sound = mixer.add(tone(300.0, 0.2));
  const engine::LoopId loop = mixer.start_loop(sound);
  mixer.play(sound, {nan, nan, nan});
  mixer.play(sound, {1e300, -1e300, 1e300});
  mixer.set_loop(loop, {nan, nan, 0.0});
  mixer.set_volume(nan);
  for (const double value : mix(mixer, 0.1).left) ASSERT_TRUE(std::abs(value) < 1.0);
}

TEST(Mixer, MixingAllocatesNothing) {
  Mixer mixer(rate);
  const engine::SoundId sound = mixer.add(tone(300.0, 0.2));
  mixer.set_loop(mixer.start_loop(sound), {});
  std::vector<float> block(1024);
  const test_support::AllocationCount allocations;
  for (int k = 0; k < 200; ++k) {
    mixer.play(sound, {0.1});
    mixer.mix(block);
  }
  EXPECT_EQ(allocations.so_far(), 0);
}

}  // namespace
