#include "tests/tradeoff/measure.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace tradeoff {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration spent) { return std::chrono::duration<double, std::micro>(spent).count(); }

struct Samples {
  std::vector<double> means;               // µs a tick, of each repeat
  std::vector<double> share_means;         // the same without the rest
  std::vector<double> ticks;               // µs, of each tick
  std::vector<std::vector<double>> share;  // µs without the rest, by tick and repeat
};

void repeat_once(const Timed& variant, int ticks, Samples& samples) {
  if (variant.reset) variant.reset();
  const std::clock_t begun = std::clock();
  const Clock::time_point start = Clock::now();
  Clock::time_point last = start;
  Clock::duration share{};
  samples.share.resize(static_cast<std::size_t>(ticks));  // without a rest a share is the tick
  for (int k = 0; k < ticks; ++k) {
    variant.tick();
    if (variant.rest) {
      const Clock::duration spent = Clock::now() - last;
      share += spent;
      samples.share[static_cast<std::size_t>(k)].push_back(microseconds(spent));
      variant.rest();
    }
    const Clock::time_point now = Clock::now();
    samples.ticks.push_back(microseconds(now - last));
    if (!variant.rest) samples.share[static_cast<std::size_t>(k)].push_back(samples.ticks.back());
    last = now;
  }
  // By processor time, which excludes other processes. The other clock separates the rest of a tick.
  const double spent_us = 1e6 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  samples.means.push_back((variant.rest ? microseconds(last - start) : spent_us) / ticks);
  samples.share_means.push_back(microseconds(share) / ticks);
}

Timing timing_of(const Timed& variant, const Samples& samples) {
  Timing timing;
  timing.median_us = quantile(samples.means, 0.5);
  timing.least_us = quantile(samples.means, 0.0);
  timing.p99_us = quantile(samples.ticks, 0.99);
  for (const std::vector<double>& tick : samples.share) {
    timing.worst_us = std::max(timing.worst_us, quantile(tick, 0.5));
  }
  if (!variant.rest) return timing;
  timing.share_us = quantile(samples.share_means, 0.5);
  timing.rest_us = timing.median_us - timing.share_us;
  std::vector<double> all;
  for (const std::vector<double>& tick : samples.share) {
    all.insert(all.end(), tick.begin(), tick.end());
  }
  timing.share_p99_us = quantile(all, 0.99);
  return timing;
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

std::vector<Timing> interleaved_timings(const std::vector<Timed>& variants, int ticks, int repeats,
                                        const std::function<void(double)>& progress) {
  std::vector<Samples> samples(variants.size());
  for (Samples& s : samples) s.ticks.reserve(static_cast<std::size_t>(ticks) * static_cast<std::size_t>(repeats));
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t c = 0; c < variants.size(); ++c) repeat_once(variants[c], ticks, samples[c]);
    progress(static_cast<double>(repeat + 1) / repeats);
  }
  std::vector<Timing> timings;
  for (std::size_t c = 0; c < samples.size(); ++c) timings.push_back(timing_of(variants[c], samples[c]));
  return timings;
}

}  // namespace tradeoff
