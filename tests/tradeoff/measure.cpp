#include "tests/tradeoff/measure.h"

#include <algorithm>
#include <chrono>

namespace tradeoff {
namespace {

using Clock = std::chrono::steady_clock;

/// The smallest value that `share` of them do not exceed.
double quantile(std::vector<double> values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

double microseconds(Clock::duration spent) { return std::chrono::duration<double, std::micro>(spent).count(); }

struct Samples {
  std::vector<double> means;  // µs a tick, of each repeat
  std::vector<double> ticks;  // µs, of each tick
};

void repeat_once(const Timed& contestant, int ticks, Samples& samples) {
  if (contestant.reset) contestant.reset();
  const Clock::time_point start = Clock::now();
  Clock::time_point last = start;
  for (int k = 0; k < ticks; ++k) {
    contestant.tick();
    const Clock::time_point now = Clock::now();
    samples.ticks.push_back(microseconds(now - last));
    last = now;
  }
  samples.means.push_back(microseconds(last - start) / ticks);
}

}  // namespace

std::vector<Timing> interleaved_timings(const std::vector<Timed>& contestants, int ticks, int repeats,
                                        const std::function<void(double)>& progress) {
  std::vector<Samples> samples(contestants.size());
  for (Samples& s : samples) s.ticks.reserve(static_cast<std::size_t>(ticks) * static_cast<std::size_t>(repeats));
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t c = 0; c < contestants.size(); ++c) repeat_once(contestants[c], ticks, samples[c]);
    progress(static_cast<double>(repeat + 1) / repeats);
  }
  std::vector<Timing> timings;
  for (const Samples& s : samples) timings.push_back({quantile(s.means, 0.5), quantile(s.ticks, 0.99)});
  return timings;
}

}  // namespace tradeoff
