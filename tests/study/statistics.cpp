#include "tests/study/statistics.h"

#include <algorithm>
#include <cmath>

namespace study {
namespace {

struct Spread {
  double mean;
  double deviation;
};

template <typename Value>
Spread spread_of(std::size_t from, std::size_t to, Value&& value) {
  const auto n = static_cast<double>(to - from);
  double sum = 0.0;
  for (std::size_t k = from; k < to; ++k) sum += value(k);
  const double mean = sum / n;
  double squares = 0.0;
  for (std::size_t k = from; k < to; ++k) squares += (value(k) - mean) * (value(k) - mean);
  return {mean, std::sqrt(squares / n)};
}

}  // namespace

Statistics statistics(const Trace& trace, std::size_t from) {
  const std::size_t ticks = trace.figures.size();
  if (from >= ticks || !trace.failure.empty()) return {};
  const Spread height = spread_of(from, ticks, [&](std::size_t k) { return trace.player[k].y; });
  const Spread stretch = spread_of(from, ticks, [&](std::size_t k) { return trace.figures[k].stretch; });
  const Spread kinetic = spread_of(from, ticks, [&](std::size_t k) { return trace.figures[k].kinetic / trace.mass; });
  const double peak = *std::max_element(trace.stretch.begin() + static_cast<std::ptrdiff_t>(from), trace.stretch.end());
  return {{height.mean, height.deviation, stretch.mean, peak, kinetic.mean, kinetic.deviation}};
}

Statistics difference(const Statistics& a, const Statistics& b) {
  Statistics off;
  for (std::size_t k = 0; k < Statistics::count; ++k) off.values[k] = std::abs(a.values[k] - b.values[k]);
  return off;
}

}  // namespace study
