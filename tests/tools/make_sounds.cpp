// Synthesises the game's sounds.
//   make_sounds FOLDER           writes the sounds into the folder
//   make_sounds --check FOLDER   compares the sounds in the folder byte by byte
//   make_sounds --play SCORE WAV writes the loop that the game makes of a score, to listen to it

#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/sound/score_renderer.h"
#include "engine/sound/wav.h"
#include "tests/tools/synth.h"

namespace {

using synth::glide;
using synth::strike;
using synth::swell;
using synth::Track;

synth::Curve times(double factor, synth::Curve curve) {
  return [=](double t) { return factor * curve(t); };
}

synth::Curve steady(double value) {
  return [=](double) { return value; };
}

/// Feet or a load hit the ground.
Track thud() {
  Track track(0.34);
  track.tone(0.0, glide(105.0, 52.0, 0.16), strike(0.005, 0.075));
  track.noise(0.0, steady(240.0), 1.0, times(0.8, strike(0.004, 0.035)));
  track.fade_ends();
  return track;
}

/// A cord hits an object.
Track slap() {
  Track track(0.16);
  track.noise(0.0, glide(900.0, 500.0, 0.1), 2.0, strike(0.003, 0.028));
  track.tone(0.0, steady(170.0), times(0.25, strike(0.004, 0.03)));
  track.fade_ends();
  return track;
}

/// Fibres stick and slip: soft grains at decreasing intervals excite the cord.
Track creak(double body, double slips) {
  Track track(0.44);
  const synth::Curve loud = swell(0.40);
  for (double at = 0.02; at < 0.38;) {
    const double level = loud(at) * (0.7 + 0.3 * track.random());
    track.tone(at, steady(body), times(level, strike(0.003, 0.014)));
    track.tone(at, steady(2.13 * body), times(0.4 * level, strike(0.002, 0.009)));
    track.noise(at, steady(3.1 * body), 6.0, times(0.5 * level, strike(0.002, 0.007)));
    at += (1.0 + 0.2 * track.random()) / (slips * (0.7 + at));
  }
  track.fade_ends();
  return track;
}

/// A continuous loop of rushing air.
Track whoosh() {
  Track track(1.7);
  const auto waver = [](double t) { return 1.0 + 0.15 * synth::sine(1.3 * t) + 0.1 * synth::sine(2.1 * t); };
  track.noise(
      0.0, [=](double t) { return 380.0 * waver(t); }, 1.6, steady(1.0));
  track.noise(
      0.0, [=](double t) { return 900.0 * waver(0.8 * t); }, 2.5, steady(0.25));
  track.close_loop(0.3);
  return track;
}

Track catch_cord() {
  Track track(0.22);
  track.tone(0.0, glide(170.0, 110.0, 0.1), strike(0.004, 0.045));
  track.noise(0.0, steady(620.0), 1.5, times(0.7, strike(0.003, 0.022)));
  track.noise(0.045, steady(480.0), 2.0, times(0.4, strike(0.004, 0.03)));
  track.fade_ends();
  return track;
}

Track let_go() {
  Track track(0.24);
  track.noise(0.0, glide(420.0, 1100.0, 0.2), 2.0, swell(0.2));
  track.fade_ends();
  return track;
}

Track throw_line() {
  Track track(0.36);
  track.noise(0.0, glide(380.0, 1900.0, 0.3), 3.0, swell(0.32));
  track.fade_ends();
  return track;
}

Track hook() {
  Track track(0.42);
  track.tone(0.0, steady(1046.5), strike(0.003, 0.085));
  track.tone(0.0, steady(1046.5 * 1.503), times(0.5, strike(0.003, 0.06)));
  track.tone(0.0, steady(1046.5 * 2.51), times(0.22, strike(0.002, 0.035)));
  track.noise(0.0, steady(700.0), 2.0, times(0.3, strike(0.002, 0.012)));
  track.fade_ends();
  return track;
}

/// A turning ratchet, a loop of four clicks; the clicks end before the loop does.
Track reel() {
  Track track(0.4);
  for (int click = 0; click < 4; ++click) {
    const double at = 0.1 * click + 0.01;
    const double level = click % 2 == 0 ? 1.0 : 0.8;
    track.tone(at, steady(click % 2 == 0 ? 540.0 : 500.0), times(0.6 * level, strike(0.002, 0.010)));
    track.noise(at, steady(1500.0), 3.0, times(level, strike(0.0015, 0.006)));
  }
  track.fade_ends();
  return track;
}

/// A soft bell.
void bell(Track& track, double at, double frequency, double level, double decay) {
  track.tone(at, steady(frequency), times(level, strike(0.012, decay)));
  track.tone(at, steady(2.0 * frequency), times(0.3 * level, strike(0.010, 0.6 * decay)));
  track.tone(at, steady(3.0 * frequency), times(0.1 * level, strike(0.008, 0.4 * decay)));
}

Track checkpoint() {
  Track track(0.7);
  bell(track, 0.0, 659.26, 1.0, 0.14);
  bell(track, 0.11, 880.0, 1.0, 0.17);
  track.fade_ends();
  return track;
}

Track goal() {
  Track track(1.5);
  double at = 0.0;
  for (const double note : {523.25, 659.26, 783.99}) {
    bell(track, at, note, 0.8, 0.16);
    at += 0.13;
  }
  bell(track, at, 1046.5, 1.0, 0.34);
  bell(track, at, 659.26, 0.5, 0.34);
  track.fade_ends();
  return track;
}

Track fall() {
  Track track(0.5);
  track.tone(0.0, glide(380.0, 130.0, 0.42), swell(0.46));
  track.tone(0.0, glide(383.0, 131.5, 0.42), times(0.6, swell(0.46)));
  track.fade_ends();
  return track;
}

/// A danger kills the player: a dull blow and a tone that sinks.
Track die() {
  Track track(0.6);
  track.noise(0.0, glide(420.0, 160.0, 0.12), 1.5, times(0.8, strike(0.003, 0.05)));
  track.tone(0.02, glide(233.1, 146.8, 0.4), strike(0.01, 0.16));
  track.tone(0.02, glide(277.2, 174.6, 0.4), times(0.5, strike(0.01, 0.14)));
  track.fade_ends();
  return track;
}

/// An edge parts the fibres, and the ends spring apart.
Track cut() {
  Track track(0.28);
  track.noise(0.0, glide(2600.0, 1200.0, 0.06), 2.0, strike(0.002, 0.02));
  track.noise(0.05, steady(1700.0), 3.0, times(0.6, strike(0.002, 0.014)));
  track.tone(0.055, glide(210.0, 130.0, 0.12), times(0.7, strike(0.003, 0.045)));
  track.fade_ends();
  return track;
}

Track coin() {
  Track track(0.45);
  bell(track, 0.0, 1318.5, 0.7, 0.06);
  bell(track, 0.06, 1760.0, 0.8, 0.1);
  track.fade_ends();
  return track;
}

Track footstep() {
  Track track(0.1);
  track.noise(0.0, glide(330.0, 180.0, 0.08), 1.2, strike(0.004, 0.018));
  track.fade_ends();
  return track;
}

Track jump() {
  Track track(0.2);
  track.noise(0.0, glide(300.0, 750.0, 0.16), 1.5, swell(0.17));
  track.fade_ends();
  return track;
}

struct Recipe {
  const char* name;
  std::function<Track()> make;
  double peak;
};

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = {{"thud", thud, 0.80},
                                          {"slap", slap, 0.60},
                                          {"creak_1", [] { return creak(310.0, 48.0); }, 0.55},
                                          {"creak_2", [] { return creak(265.0, 41.0); }, 0.55},
                                          {"creak_3", [] { return creak(352.0, 55.0); }, 0.55},
                                          {"whoosh", whoosh, 0.60},
                                          {"catch", catch_cord, 0.65},
                                          {"let_go", let_go, 0.45},
                                          {"throw", throw_line, 0.55},
                                          {"hook", hook, 0.55},
                                          {"reel", reel, 0.45},
                                          {"checkpoint", checkpoint, 0.6},
                                          {"goal", goal, 0.65},
                                          {"fall", fall, 0.5},
                                          {"die", die, 0.55},
                                          {"cut", cut, 0.55},
                                          {"coin", coin, 0.45},
                                          {"footstep", footstep, 0.4},
                                          {"jump", jump, 0.4}};
  return all;
}

std::string bytes_of(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes << std::flush;
  if (!out) throw std::runtime_error("cannot write " + path);
}

/// Renders a score to a WAV file and prints its length and the time that it took.
void play(const std::string& score, const std::string& path) {
  const auto start = std::chrono::steady_clock::now();
  const engine::Sound loop = engine::render(engine::load_score(score));
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  write(path, engine::wav_of(loop));
  std::printf("%s: %.1f s of music, made in %.0f ms\n", path.c_str(),
              static_cast<double>(loop.samples.size()) / loop.rate, taken.count());
}

/// Writes the sounds, or compares them. Returns false if one differs.
bool make(const std::string& folder, bool check) {
  bool same = true;
  for (const Recipe& recipe : recipes()) {
    const std::string path = folder + "/" + recipe.name + ".wav";
    const std::string bytes = engine::wav_of({synth::rate, recipe.make().finished(recipe.peak)});
    if (!check) write(path, bytes);
    if (!check || bytes == bytes_of(path)) continue;
    std::printf("%s is not what make_sounds makes\n", path.c_str());
    same = false;
  }
  return same;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool plays = arguments.size() == 3 && arguments[0] == "--play";
  const bool check = arguments.size() == 2 && arguments[0] == "--check";
  if (!plays && !check && (arguments.size() != 1 || arguments[0].starts_with("-"))) {
    std::fputs("usage: make_sounds [--check] FOLDER, or make_sounds --play SCORE WAV\n", stderr);
    return 2;
  }
  try {
    if (!plays) return make(arguments.back(), check) ? 0 : 1;
    play(arguments[1], arguments[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_sounds: %s\n", error.what());
    return 2;
  }
}
