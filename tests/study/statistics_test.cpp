#include "tests/study/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace study {
namespace {

/// Returns 6 ticks of 2 kg: player heights 0 … 5 m; mean stretch grows by 0.01 per tick, kinetic energy by 4 J.
Trace rising() {
  Trace trace;
  trace.mass = 2.0;
  for (int k = 0; k < 6; ++k) {
    trace.player.push_back({9.0, 1.0 * k});
    trace.stretch.push_back(k == 3 ? 0.5 : 0.02 * k);
    Figures& figures = trace.figures.emplace_back();
    figures.stretch = 0.01 * k;
    figures.kinetic = 4.0 * k;
  }
  return trace;
}

TEST(Statistics, CoverTheRemainingTicks) {
  const Statistics found = statistics(rising(), 2);
  const double deviation = std::sqrt(1.25);  // of 2, 3, 4, 5
  const std::array<double, Statistics::count> expected = {3.5, deviation, 0.035, 0.5, 7.0, 2.0 * deviation};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found.values[k], expected[k], 1e-15) << found.names[k];
  EXPECT_NEAR(statistics(rising(), 4).values[3], 0.1, 1e-15);
}

TEST(Statistics, DifferencesAreAbsolute) {
  const Statistics off = difference(statistics(rising(), 4), statistics(rising(), 2));
  EXPECT_NEAR(off.values[0], 1.0, 1e-15);
  EXPECT_NEAR(off.values[3], 0.4, 1e-15);
}

TEST(Statistics, AreUnavailableWithoutTicks) {
  for (const double value : statistics(rising(), 6).values) EXPECT_TRUE(std::isnan(value));
  Trace failed = rising();
  failed.failure = "blew up in tick 6";
  for (const double value : statistics(failed, 2).values) EXPECT_TRUE(std::isnan(value));
}

}  // namespace
}  // namespace study
