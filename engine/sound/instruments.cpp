#include "engine/sound/instruments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/sound/waves.h"

namespace engine {
namespace {

constexpr double semitone = 1.0594630943592953;   // the twelfth root of 2
constexpr double loss_60_db = 6.907755278982137;  // ln 1000

/// Returns the frequency of a key in Hz, by multiplication, because pow() differs between libraries.
double frequency_of(int key) {
  double frequency = 440.0;
  for (int k = 69; k < key; ++k) frequency *= semitone;
  for (int k = 69; k > key; --k) frequency /= semitone;
  return frequency;
}

/// Returns exp(−x) for x from 0 to 1, to 1e-7.
double falling(double x) {
  const double y = x / 16.0;
  double power = 1.0 - y * (1.0 - y / 2.0 * (1.0 - y / 3.0));
  for (int k = 0; k < 4; ++k) power *= power;
  return power;
}

/// A uniform random number in −1 … 1 by Marsaglia's xorshift.
double random(std::uint32_t& seed) {
  seed ^= seed << 13U;
  seed ^= seed >> 17U;
  seed ^= seed << 5U;
  return static_cast<double>(seed) / 2147483648.0 - 1.0;
}

/// The pluck: a period of noise without high frequencies, of mean 0 and mean square 1.
std::vector<double> pluck_of(std::size_t period, double bright, std::uint32_t seed) {
  std::vector<double> noise(period);
  for (double& x : noise) x = random(seed);
  const double keep = 0.1 + 0.45 * bright;
  double smoothed = 0.0;
  for (int pass = 0; pass < 4; ++pass) {  // around the cycle, so that its ends meet
    for (double& x : noise) x = smoothed += keep * (x - smoothed);
  }
  double mean = 0.0;
  for (const double x : noise) mean += x / static_cast<double>(period);
  double square = 0.0;
  for (double& x : noise) {
    x -= mean;
    square += x * x / static_cast<double>(period);
  }
  for (double& x : noise) x /= std::sqrt(square + 1e-12);
  return noise;
}

/// A plucked string: the pluck runs round a delay line of one period, which a filter dampens (Karplus and Strong 1983).
/// An allpass filter adds the fraction of a sample that tunes it (Jaffe and Smith 1983).
void add_pluck(Cycle& cycle, int rate, const ScoreVoice& voice, const ScoreNote& note, std::uint32_t seed) {
  const double frequency = frequency_of(note.key);
  const double blur = 0.5 * (1.0 - 0.8 * voice.bright) / (1.0 + frequency / 1200.0);  // weight of the sample before
  const double period = rate / frequency - blur;
  const auto size = static_cast<std::size_t>(period - 0.3);
  const double fraction = period - static_cast<double>(size);  // 0.3 … 1.3 samples
  const double allpass = (1.0 - fraction) / (1.0 + fraction);
  const double loss = falling(std::min(1.0, loss_60_db / (voice.ring * frequency)));
  std::vector<double> line = pluck_of(size, voice.bright, seed);
  const auto first = static_cast<std::size_t>(note.start * rate);
  const auto length = static_cast<std::size_t>(voice.ring * rate);
  const double rise = 0.006 * rate;                        // samples; a finger is no click
  const double fall = 0.25 * static_cast<double>(length);  // samples
  double before = 0.0;
  double tuned = 0.0;
  double blurred_before = 0.0;
  for (std::size_t k = 0, at = 0; k < length; ++k, at = at + 1 == size ? 0 : at + 1) {
    const double out = line[at];
    const double blurred = loss * ((1.0 - blur) * out + blur * before);
    before = out;
    tuned = allpass * (blurred - tuned) + blurred_before;
    blurred_before = blurred;
    line[at] = tuned;
    const double end = smooth_step(static_cast<double>(length - k) / fall);
    cycle.add(first + k, 0.25 * voice.volume * end * std::min(1.0, static_cast<double>(k) / rise) * out);
  }
}

/// A phasor that turns by multiplication.
struct Phasor {
  Phasor(double turns_per_sample, double start)
      : cosine(sine(turns_per_sample + 0.25)), sinus(sine(turns_per_sample)), x(sine(start + 0.25)), y(sine(start)) {}
  double next() {
    const double turned = cosine * x - sinus * y;
    y = sinus * x + cosine * y;
    x = turned;
    return y;
  }
  double cosine, sinus, x, y;
};

/// A soft chord: two slightly different pitches with weak overtones, which swell and die away.
void add_pad(Cycle& cycle, int rate, const ScoreVoice& voice, const ScoreNote& note, std::uint32_t seed) {
  const double turns = frequency_of(note.key) / rate;
  std::vector<std::pair<Phasor, double>> tones;
  for (const double detuned : {0.9985, 1.0015}) {
    double level = 0.1;
    for (int overtone = 1; overtone <= 3; ++overtone) {
      tones.emplace_back(Phasor(detuned * overtone * turns, 0.5 * random(seed)), level);
      level *= 0.15 + 0.45 * voice.bright;
    }
  }
  const double rise = std::min(1.2, 0.5 * note.length) * rate;  // samples
  const double hold = note.length * rate;
  const double fall = voice.ring * rate;
  const auto first = static_cast<std::size_t>(note.start * rate);
  for (std::size_t k = 0; static_cast<double>(k) < hold + fall; ++k) {
    const auto t = static_cast<double>(k);
    const double gone = 1.0 - smooth_step((t - hold) / fall);
    double value = 0.0;
    for (auto& [phasor, level] : tones) value += level * phasor.next();
    cycle.add(first + k, voice.volume * smooth_step(t / rise) * gone * gone * value);
  }
}

/// A drum: a tone that falls to its pitch, and a soft tick of noise.
void add_drum(Cycle& cycle, int rate, const ScoreVoice& voice, const ScoreNote& note, std::uint32_t seed) {
  const double frequency = frequency_of(note.key);
  const double loss = falling(loss_60_db / (voice.ring * rate));
  const double tick_loss = falling(loss_60_db / (0.06 * rate));
  const auto first = static_cast<std::size_t>(note.start * rate);
  double level = 1.0;
  double tick = 0.5 * voice.bright;
  double turns = 0.0;
  double hiss = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(voice.ring * rate); ++k) {
    hiss += 0.3 * (random(seed) - hiss);
    const double rise = std::min(1.0, static_cast<double>(k) / (0.003 * rate));
    cycle.add(first + k, 0.5 * voice.volume * rise * (level * sine(turns) + tick * hiss));
    turns += frequency * (1.0 + 0.8 * level * level) / rate;
    level *= loss;
    tick *= tick_loss;
  }
}

}  // namespace

void add_note(Cycle& cycle, int rate, const ScoreVoice& voice, const ScoreNote& note, std::uint32_t seed) {
  switch (voice.instrument) {
    case Instrument::pluck: return add_pluck(cycle, rate, voice, note, seed);
    case Instrument::pad: return add_pad(cycle, rate, voice, note, seed);
    case Instrument::drum: return add_drum(cycle, rate, voice, note, seed);
  }
}

}  // namespace engine
