// The pieces of music, their fades, and how the program plays them.

#include "game/sound/music.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "engine/sound/score_renderer.h"
#include "game/screens/level_facts.h"
#include "ribbon/box2d/state_hash.h"
#include "tests/game/program.h"
#include "tests/support/disk_audio.h"

namespace game {
namespace {

using namespace test_support;

constexpr std::int64_t ms = 1'000'000;

engine::Sound piece(Tune tune) {
  return engine::render(engine::load_score(std::string(TEST_ASSETS "/music/") + tune_name(tune) + ".score"));
}

/// FNV-1a of the samples as a WAV file has them.
std::uint64_t hash_of(const engine::Sound& sound) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char byte : engine::wav_of(sound)) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  return hash;
}

class EachPiece : public testing::TestWithParam<Tune> {};
INSTANTIATE_TEST_SUITE_P(Music, EachPiece, testing::Values(Tune::menu, Tune::calm, Tune::tense),
                         [](const auto& piece) { return tune_name(piece.param); });

TEST_P(EachPiece, LoopsForAMinuteOrMoreWithoutClipping) {
  const engine::Sound sound = piece(GetParam());
  const double seconds = static_cast<double>(sound.samples.size()) / sound.rate;
  EXPECT_GE(seconds, 60.0);
  EXPECT_LE(seconds, 90.0);
  EXPECT_NEAR(peak(sound.samples), 0.75, 1e-4);
  EXPECT_GT(rms(sound.samples), 0.05);
}

/// At the wrap, value, slope and loudness change no more than they do elsewhere in a soft passage.
TEST_P(EachPiece, HasNoSeam) {
  const std::vector<float> x = piece(GetParam()).samples;
  const std::size_t size = x.size();
  const auto at = [&](std::size_t k) { return static_cast<double>(x[k % size]); };
  std::vector<double> bends;
  for (std::size_t k = 1; k < size; ++k) bends.push_back(std::abs(at(k + 1) - 2.0 * at(k) + at(k - 1)));
  const double at_wrap = std::max({bends[size - 3], bends[size - 2], std::abs(at(1) - 2.0 * at(0) + at(size - 1))});
  auto high = bends.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(bends.size()));
  std::nth_element(bends.begin(), high, bends.end());
  EXPECT_LT(at_wrap, *high) << "one bend in a hundred is larger";
  const std::size_t second = engine::ScoreRenderer::rate;
  EXPECT_GT(rms({x.end() - static_cast<std::ptrdiff_t>(second), x.end()}), 0.3 * rms(x)) << "no silence at the end";
  EXPECT_GT(rms({x.begin(), x.begin() + static_cast<std::ptrdiff_t>(second)}), 0.3 * rms(x)) << "nor at the start";
}

/// On each machine and with each compiler. After a change of a score or an instrument, set the new values.
TEST(Music, AScoreGivesTheSameSamplesEverywhere) {
  EXPECT_EQ(ribbon::box2d::to_hex(hash_of(piece(Tune::menu))), "30e08061244e96de");
  EXPECT_EQ(ribbon::box2d::to_hex(hash_of(piece(Tune::calm))), "829912ec8927d244");
  EXPECT_EQ(ribbon::box2d::to_hex(hash_of(piece(Tune::tense))), "eb08adb447c5a919");
}

TEST(Music, ALevelWithGustsOrWeakRopesIsTense) {
  EXPECT_EQ(tune_of(load_level("first_swing")), Tune::calm);
  EXPECT_EQ(tune_of(load_level("gently")), Tune::tense);
  EXPECT_EQ(tune_of(load_level("wait_for_the_wind")), Tune::tense);
}

TEST(Fades, APieceEndsBeforeTheNextBegins) {
  Fades fades;
  const auto run = [&fades](Tune wanted, int milliseconds) {
    double greatest_step = 0.0;
    for (int k = 0; k < milliseconds; k += 10) {
      const double menu = fades.volume(Tune::menu);
      const double calm = fades.volume(Tune::calm);
      fades.advance(10 * ms, wanted, true);
      EXPECT_TRUE(fades.volume(Tune::menu) == 0.0 || fades.volume(Tune::calm) == 0.0);
      greatest_step = std::max(
          {greatest_step, std::abs(fades.volume(Tune::menu) - menu), std::abs(fades.volume(Tune::calm) - calm)});
    }
    EXPECT_LT(greatest_step, 0.02);
  };
  run(Tune::menu, 1300);
  EXPECT_EQ(fades.volume(Tune::menu), 1.0);
  run(Tune::calm, 710);
  EXPECT_EQ(fades.volume(Tune::menu), 0.0);
  EXPECT_EQ(fades.volume(Tune::calm), 0.0);
  run(Tune::calm, 200);
  EXPECT_EQ(fades.volume(Tune::calm), 0.0) << "a silence between the pieces";
  run(Tune::calm, 1400);
  EXPECT_EQ(fades.volume(Tune::calm), 1.0);
  run(Tune::none, 800);
  EXPECT_EQ(fades.volume(Tune::calm), 0.0) << "a pause";
  run(Tune::calm, 600);
  EXPECT_GT(fades.volume(Tune::calm), 0.4) << "it continues without a silence";
}

TEST(Fades, APieceWaitsUntilItIsReady) {
  Fades fades;
  for (int k = 0; k < 100; ++k) fades.advance(16 * ms, Tune::menu, false);
  EXPECT_EQ(fades.volume(Tune::menu), 0.0);
  fades.advance(16 * ms, Tune::menu, true);
  EXPECT_GT(fades.volume(Tune::menu), 0.0);
  EXPECT_LT(fades.volume(Tune::menu), 0.1);
}

/// Runs a level with these settings and returns what was heard. The music is rendered and faded in within 4 s, or later
/// if other programs take the processor.
std::vector<float> heard_with(const std::string& name, int ticks, const std::string& settings) {
  const std::string config = scratch(name);
  const std::string sound = scratch(name + ".raw");
  fs::create_directories(config + "/ropeswing");
  write_bytes(config + "/ropeswing/settings.json", settings);
  const Ended ended =
      ropeswing("--ticks " + std::to_string(ticks),
                "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=" + sound + " XDG_CONFIG_HOME=" + config);
  EXPECT_EQ(ended.status, 0) << ended.output;
  return left_channel(sound);
}

/// The programs run at the same time, because sound takes its time.
TEST(Music, HasAVolumeOfItsOwnAndIsMutedWithTheSounds) {
  const auto peak_with = [](const std::string& name, int ticks, const std::string& settings) {
    return std::async(std::launch::async, [=] { return peak(heard_with(name, ticks, settings)); });
  };
  auto loud = peak_with("loud", 600, R"({"volume": 0, "music_volume": 100})");
  auto quiet = peak_with("quiet", 600, R"({"volume": 0, "music_volume": 10})");
  auto without = peak_with("without", 120, R"({"volume": 0, "music_volume": 0})");
  auto muted = peak_with("muted", 300, R"({"volume": 0, "music_volume": 100, "muted": true})");
  const double loudest = loud.get();
  const double quietest = quiet.get();
  EXPECT_GT(loudest, 0.01);
  EXPECT_GT(quietest, 0.001);
  EXPECT_LT(quietest, 0.3 * loudest);
  EXPECT_EQ(without.get(), 0.0);
  EXPECT_EQ(muted.get(), 0.0);
}

TEST(Music, ABadOrMissingScoreIsReportedOnceAndTheGameRuns) {
  const std::string assets = scratch("assets_of_bad_music");
  fs::remove_all(assets);
  fs::create_directories(assets + "/music");
  for (const char* const folder : {"levels", "sounds", "replays"}) {
    fs::create_directory_symlink(std::string(TEST_ASSETS "/") + folder, assets + "/" + folder);
  }
  fs::copy_file(TEST_ASSETS "/music/menu.score", assets + "/music/menu.score");
  write_bytes(assets + "/music/calm.score", "tempo 900\n");
  const Ended ended = ropeswing("--ticks 60", "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy ROPESWING_ASSETS=" + assets);
  EXPECT_EQ(ended.status, 0) << ended.output;
  const std::string message = "calm.score:1: tempo is 900; accepted is a number from 30 to 240";
  const std::size_t found = ended.output.find(message);
  EXPECT_NE(found, std::string::npos) << ended.output;
  EXPECT_EQ(ended.output.find(".score", found + message.size()), std::string::npos) << "only the first one";
}

}  // namespace
}  // namespace game
