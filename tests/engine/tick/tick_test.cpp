#include "engine/tick/tick.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

#include "engine/tick/input.h"

namespace engine {
namespace {

constexpr std::int64_t second = 1'000'000'000;
constexpr std::int64_t hour = 3600 * second;

TEST(FixedTick, AnHourAt144FramesASecondIsExactlyAnHourOfTicks) {
  FixedTick tick(60);
  std::int64_t ticks = 0;
  std::int64_t now = 0;
  for (std::int64_t frame = 1; frame <= 3600 * 144; ++frame) {
    const std::int64_t then = frame * second / 144;  // as a clock in whole nanoseconds shows it
    ticks += tick.advance(then - now);
    now = then;
  }
  EXPECT_EQ(ticks, 3600 * 60);
  EXPECT_EQ(tick.alpha(), 0.0);
  EXPECT_EQ(tick.dropped_ticks(), 0);
}

TEST(FixedTick, AnHourAt20FramesASecondRunsThreeTicksEveryFrame) {
  FixedTick tick(60);
  for (std::int64_t now = 0; now < hour; now += second / 20) ASSERT_EQ(tick.advance(second / 20), 3);
  EXPECT_EQ(tick.dropped_ticks(), 0);
}

TEST(FixedTick, NeverRunsATickEarlyOrLateForAnyFrameTimes) {
  for (const int rate : {1, 50, 60, 144, 1000, FixedTick::max_ticks_per_second}) {
    FixedTick tick(rate, std::numeric_limits<int>::max());
    std::int64_t now = 0;
    std::int64_t ticks = 0;
    std::uint32_t random = 1;
    for (int frame = 0; frame < 10'000; ++frame) {
      random = random * 1664525U + 1013904223U;
      const std::int64_t elapsed = random % 100'000'000U;
      now += elapsed;
      ticks += tick.advance(elapsed);
      ASSERT_EQ(ticks, now / second * rate + now % second * rate / second) << rate << " Hz, frame " << frame;
    }
  }
}

TEST(FixedTick, ASlowFrameRunsAsManyTicksAsAcceptedAndCountsTheRest) {
  FixedTick tick(60, 8);
  EXPECT_EQ(tick.advance(second), 8);
  EXPECT_EQ(tick.dropped_ticks(), 52);
  EXPECT_EQ(tick.advance(0), 0) << "what was dropped must not come back";
  EXPECT_EQ(tick.advance(second / 10), 6);
  EXPECT_EQ(tick.dropped_ticks(), 52);
}

TEST(FixedTick, TheLongestTimeDoesNotOverflow) {
  constexpr std::int64_t longest = std::numeric_limits<std::int64_t>::max();
  FixedTick tick(FixedTick::max_ticks_per_second, 8);
  EXPECT_EQ(tick.advance(longest), 8);
  EXPECT_EQ(tick.dropped_ticks(), longest / 1000 - 8);
}

TEST(FixedTick, TimeThatRunsBackwardsCountsAsZero) {
  FixedTick tick(60);
  tick.advance(10'000'000);
  const double alpha = tick.alpha();
  EXPECT_EQ(tick.advance(-second), 0);
  EXPECT_EQ(tick.advance(std::numeric_limits<std::int64_t>::min()), 0);
  EXPECT_EQ(tick.alpha(), alpha);
}

TEST(FixedTick, AlphaIsThePartOfATickNotRunYet) {
  FixedTick tick(50);
  EXPECT_EQ(tick.alpha(), 0.0);
  EXPECT_EQ(tick.advance(5'000'000), 0);
  EXPECT_DOUBLE_EQ(tick.alpha(), 0.25);
  EXPECT_EQ(tick.advance(14'999'999), 0);
  EXPECT_GT(tick.alpha(), 0.9999);
  EXPECT_LT(tick.alpha(), 1.0);
  EXPECT_EQ(tick.advance(1), 1);
  EXPECT_EQ(tick.alpha(), 0.0);
}

TEST(FixedTick, RefusesInvalidRates) {
  EXPECT_THROW(FixedTick(0), std::invalid_argument);
  EXPECT_THROW(FixedTick(-60), std::invalid_argument);
  EXPECT_THROW(FixedTick(FixedTick::max_ticks_per_second + 1), std::invalid_argument);
  EXPECT_THROW(FixedTick(60, 0), std::invalid_argument);
}

TEST(Input, PointerIsRoundedToTheNearestCentimetre) {
  EXPECT_EQ(quantise_cm(1.234), 123);
  EXPECT_EQ(quantise_cm(1.235), 124);
  EXPECT_EQ(quantise_cm(-1.236), -124);
  EXPECT_EQ(quantise_cm(-0.004), 0);
}

TEST(Input, PointerBeyondTheRangeStopsAtItsEnd) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(quantise_cm(327.67), 32767);
  EXPECT_EQ(quantise_cm(327.68), 32767);
  EXPECT_EQ(quantise_cm(-327.69), -32768);
  EXPECT_EQ(quantise_cm(infinity), 32767);
  EXPECT_EQ(quantise_cm(-infinity), -32768);
  EXPECT_EQ(quantise_cm(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Input, EveryCentimetreIsPreserved) {
  for (int cm = -32768; cm <= 32767; ++cm) {
    TickInput input;
    input.pointer_x_cm = static_cast<std::int16_t>(cm);
    input.pointer_y_cm = static_cast<std::int16_t>(-1 - cm);
    TickInput again;
    set_pointer(again, pointer(input));
    ASSERT_EQ(again, input);
  }
}

}  // namespace
}  // namespace engine
