#include "tests/tradeoff/measure.h"

#include <algorithm>
#include <chrono>

namespace tradeoff {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double microseconds_a_tick(const Tick& tick, int ticks) {
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < ticks; ++k) tick();
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
  return spent.count() / ticks;
}

}  // namespace

std::vector<double> interleaved_medians(const std::vector<Tick>& contestants, int ticks, int repeats,
                                        const std::function<void(double)>& progress) {
  std::vector<std::vector<double>> spent(contestants.size());
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      spent[c].push_back(microseconds_a_tick(contestants[c], ticks));
    }
    progress(static_cast<double>(repeat + 1) / repeats);
  }
  std::vector<double> medians;
  for (const auto& values : spent) medians.push_back(median(values));
  return medians;
}

}  // namespace tradeoff
