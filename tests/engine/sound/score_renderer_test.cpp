#include "engine/sound/score_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using engine::Sound;

const std::string head = "tempo 120\nmeter 4\n";

Sound played(const std::string& voice, const std::string& bars) {
  return engine::render(
      engine::parse_score(head + "voice v " + voice + "\nsection a\nv: " + bars + "\nplay a\n", "a.score"));
}

/// The amplitude of a frequency in the samples from `from` s on, for half a second.
double level(const Sound& sound, double frequency, double from) {
  double c = 0.0;
  double s = 0.0;
  const auto first = static_cast<std::size_t>(from * sound.rate);
  const std::size_t count = static_cast<std::size_t>(sound.rate) / 2;
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(k);
    const double window = 1.0 - std::cos(turn / static_cast<double>(count));
    c += window * static_cast<double>(sound.samples[first + k]) * std::cos(frequency * turn / sound.rate);
    s += window * static_cast<double>(sound.samples[first + k]) * std::sin(frequency * turn / sound.rate);
  }
  return std::hypot(c, s) / static_cast<double>(count);
}

double rms(const Sound& sound, double from, double to) {
  double sum = 0.0;
  const auto first = static_cast<std::size_t>(from * sound.rate);
  const auto last = static_cast<std::size_t>(to * sound.rate);
  for (std::size_t k = first; k < last; ++k) {
    sum += static_cast<double>(sound.samples[k]) * static_cast<double>(sound.samples[k]);
  }
  return std::sqrt(sum / static_cast<double>(last - first));
}

TEST(ScoreRenderer, StringsAndPadsAreInTune) {
  for (const char* const voice : {"pluck ring 4", "pluck ring 4 bright 1", "pad"}) {
    for (const auto& [note, frequency] : {std::pair{"D2", 73.416}, std::pair{"A3", 220.0}, std::pair{"E5", 659.255}}) {
      const Sound sound = played(voice, note);
      const double right = level(sound, frequency, 0.4);
      EXPECT_GT(right, 0.01) << voice << ' ' << note;
      for (const double cents : {-15.0, 15.0}) {
        EXPECT_LT(level(sound, frequency * std::exp2(cents / 1200.0), 0.4), right) << voice << ' ' << note << cents;
      }
    }
  }
}

TEST(ScoreRenderer, APluckDiesAwayAndAHeldPadDoesNot) {
  const Sound pluck = played("pluck ring 1", "A3 | . | .");
  EXPECT_LT(rms(pluck, 3.0, 3.5), 0.01 * rms(pluck, 0.05, 0.5));
  const Sound pad = played("pad ring 0.5", "A3 | - | .");
  EXPECT_GT(rms(pad, 3.0, 3.5), 0.5 * rms(pad, 1.0, 1.5));
  EXPECT_LT(rms(pad, 5.5, 6.0), 0.05 * rms(pad, 1.0, 1.5));
}

/// What sounds at the end continues at the start: a note at the end gives the same loop, turned, as one at the start.
TEST(ScoreRenderer, TheLoopHasNoSeam) {
  for (const char* const voice : {"pluck ring 3", "pad ring 1.5", "drum ring 1"}) {
    const Sound first = played(voice, "A2 . . . | . . . .");
    const Sound last = played(voice, ". . . . | . . . A2");
    ASSERT_EQ(first.samples.size(), last.samples.size());
    const std::size_t size = first.samples.size();
    double most = 0.0;
    for (std::size_t k = 0; k < size; ++k) {
      const double turned = static_cast<double>(last.samples[(k + 7 * size / 8) % size]);
      most = std::max(most, std::abs(turned - static_cast<double>(first.samples[k])));
    }
    EXPECT_LT(most, 1e-4) << voice;
  }
}

TEST(ScoreRenderer, NoSampleClipsAndSilenceIsSilent) {
  const Sound loud = played("pluck volume 1", "C2+E2+G2+C3+E3+G3+C4+E4 C2+E2+G2+C3+E3+G3+C4+E4");
  float most = 0.0F;
  for (const float x : loud.samples) most = std::max(most, std::abs(x));
  EXPECT_NEAR(most, engine::ScoreRenderer::peak, 1e-6);
  for (const float x : played("pluck", ".").samples) ASSERT_EQ(x, 0.0F);
}

TEST(ScoreRenderer, StepsGiveTheSameLoopAsOneCall) {
  const std::string text = head + "voice v pluck\nvoice w pad\nsection a\nv: A3 B3 C4 D4\nw: A3+C4\nplay a\n";
  engine::ScoreRenderer renderer(engine::parse_score(text, "a.score"));
  int steps = 1;
  while (renderer.step()) ++steps;
  EXPECT_GT(steps, 6);
  EXPECT_EQ(renderer.finish().samples, engine::render(engine::parse_score(text, "a.score")).samples);
}

}  // namespace
