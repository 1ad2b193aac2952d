#include "tests/tools/synth.h"

#include <algorithm>
#include <cmath>

namespace synth {

Curve strike(double attack, double decay) {
  return [attack, decay](double t) {
    double level = smooth(t / attack);
    // (1 − 1/64)^64 ≈ 1/e per decay time, by squaring, because exp() differs between libraries.
    const double steps = 64.0 * std::max(0.0, t - attack) / decay;
    for (double k = 0.0; k + 1.0 <= steps; k += 1.0) level *= 1.0 - 1.0 / 64.0;
    return level * (1.0 - (steps - std::floor(steps)) / 64.0);
  };
}

Curve swell(double length) {
  return [length](double t) {
    return t < 0.4 * length ? smooth(t / (0.4 * length)) : smooth((length - t) / (0.6 * length));
  };
}

Curve glide(double from, double to, double length) {
  return [=](double t) { return from + (to - from) * std::clamp(t / length, 0.0, 1.0); };
}

Track::Track(double length) : samples_(static_cast<std::size_t>(length * rate)) {}

std::size_t Track::sample(double time) const { return static_cast<std::size_t>(std::max(0.0, time) * rate); }

double Track::random() {  // Marsaglia's xorshift
  seed_ ^= seed_ << 13U;
  seed_ ^= seed_ >> 17U;
  seed_ ^= seed_ << 5U;
  return static_cast<double>(seed_) / 2147483648.0 - 1.0;
}

void Track::tone(double at, const Curve& frequency, const Curve& loudness) {
  double turns = 0.0;
  const std::size_t first = sample(at);
  for (std::size_t k = first; k < samples_.size(); ++k) {
    const double t = static_cast<double>(k - first) / rate;
    samples_[k] += loudness(t) * sine(turns);
    turns += frequency(t) / rate;
  }
}

/// Chamberlin's state-variable filter, applied twice: a single pass leaves too much hiss.
void Track::noise(double at, const Curve& frequency, double sharpness, const Curve& loudness) {
  struct Filter {
    double low = 0.0;
    double band = 0.0;
    double operator()(double in, double f, double sharpness) {
      low += f * band;
      return band += f * (in - low - band / sharpness);
    }
  };
  Filter first_filter;
  Filter second_filter;
  const std::size_t first = sample(at);
  for (std::size_t k = first; k < samples_.size(); ++k) {
    const double t = static_cast<double>(k - first) / rate;
    const double f = 2.0 * sine(0.5 * std::min(frequency(t), 3500.0) / rate);
    const double once = first_filter(random(), f, sharpness) / sharpness;
    samples_[k] += 4.0 * loudness(t) * second_filter(once, f, sharpness) / std::sqrt(sharpness);
  }
}

void Track::close_loop(double seconds) {
  const std::size_t fade = sample(seconds);
  const std::size_t rest = samples_.size() - fade;
  for (std::size_t k = 0; k < fade; ++k) {
    const double in = static_cast<double>(k) / static_cast<double>(fade);
    // Noise is uncorrelated: powers add up, not amplitudes.
    samples_[k] = std::sqrt(in) * samples_[k] + std::sqrt(1.0 - in) * samples_[rest + k];
  }
  samples_.resize(rest);
}

void Track::fade_ends() {
  const double last = static_cast<double>(samples_.size()) - 1.0;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const auto at = static_cast<double>(k);
    samples_[k] *= smooth(at / (0.002 * rate)) * smooth((last - at) / (0.03 * rate));
  }
}

std::vector<float> Track::finished(double peak) const {
  double most = 0.0;
  for (const double x : samples_) most = std::max(most, std::abs(x));
  std::vector<float> samples;
  for (const double x : samples_) samples.push_back(static_cast<float>(peak / most * x));
  return samples;
}

}  // namespace synth
