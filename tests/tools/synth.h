#pragma once

#include <cstdint>
#include <functional>
#include <vector>

/// Small sounds from sines and noise, the same bytes on every machine: nothing here calls a library's sine.
namespace synth {

inline constexpr int rate = 22050;  // samples a second

/// From time [s] to what is heard then, or to a frequency.
using Curve = std::function<double(double)>;

/// sin(2π·turns).
double sine(double turns);
/// 0 below 0, 1 above 1, without a corner between.
double smooth(double x);
/// Up within `attack` seconds, then down to a third with every `decay` seconds.
Curve strike(double attack, double decay);
/// Up and down again within `length` seconds.
Curve swell(double length);
/// Evenly from one value to the other within `length` seconds.
Curve glide(double from, double to, double length);

/// A sound that is added up from parts.
class Track {
 public:
  /// s.
  explicit Track(double length);

  /// A tone from `at` seconds on; the frequency [Hz] and loudness as of its own beginning.
  void tone(double at, const Curve& frequency, const Curve& loudness);
  /// Noise around a frequency [Hz]; a larger `sharpness` (1 … 50) is more like a tone.
  void noise(double at, const Curve& frequency, double sharpness, const Curve& loudness);

  /// Has its end run into its beginning: the last `seconds` are faded into the first, and it is shorter by them.
  void close_loop(double seconds);
  /// Begins and ends in silence.
  void fade_ends();
  /// As loud as that at its loudest.
  std::vector<float> finished(double peak) const;

  /// Evenly, −1 … 1; the same ones in every run.
  double random();

 private:
  std::size_t sample(double time) const;

  std::vector<double> samples_;
  std::uint32_t seed_ = 2463534242U;
};

}  // namespace synth
