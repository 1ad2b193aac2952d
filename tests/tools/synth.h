#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/sound/waves.h"

/// Short sounds from sines and noise, with the same bytes on every machine: it calls no library sine.
namespace synth {

inline constexpr int rate = 22050;  // samples a second

/// Maps time [s] to an amplitude or a frequency [Hz].
using Curve = std::function<double(double)>;

using engine::sine;
/// Returns a smooth step: 0 below 0, 1 above 1.
inline double smooth(double x) { return engine::smooth_step(x); }
/// Rises within `attack` seconds, then falls to 1/e with every `decay` seconds.
Curve strike(double attack, double decay);
/// Rises and falls within `length` seconds.
Curve swell(double length);
/// Changes linearly from one value to the other within `length` seconds.
Curve glide(double from, double to, double length);

/// Mixes a sound from parts.
class Track {
 public:
  /// `length` is in s.
  explicit Track(double length);

  /// Adds a tone from `at` seconds on; the frequency [Hz] and loudness are functions of the time since then.
  void tone(double at, const Curve& frequency, const Curve& loudness);
  /// Adds noise around a frequency [Hz]; a larger `sharpness` (1 … 50) is more like a tone.
  void noise(double at, const Curve& frequency, double sharpness, const Curve& loudness);

  /// Makes a loop: fades the last `seconds` into the first, and shortens the sound by them.
  void close_loop(double seconds);
  /// Fades in at the start and out at the end.
  void fade_ends();
  /// Returns the samples, scaled to this peak.
  std::vector<float> finished(double peak) const;

  /// Returns a uniform random number in −1 … 1; the sequence is the same in every run.
  double random();

 private:
  std::size_t sample(double time) const;

  std::vector<double> samples_;
  std::uint32_t seed_ = 2463534242U;
};

}  // namespace synth
