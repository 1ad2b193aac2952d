#include "game/tuning/frame_times.h"

#include <gtest/gtest.h>

namespace game {
namespace {

using Part = FrameTimes::Part;

TEST(FrameTimes, GiveMeanAndWorstOfTheLastSecond) {
  FrameTimes times;
  EXPECT_EQ(times.of(Part::whole).worst_ms, 0.0);
  times.add(Part::whole, 90'000'000);
  times.end_frame(100'000'000);
  EXPECT_EQ(times.of(Part::whole).worst_ms, 90.0);
  for (int frame = 0; frame < 20; ++frame) {
    times.add(Part::physics, 1'000'000);
    times.add(Part::physics, 1'000'000);  // two ticks
    times.add(Part::whole, frame == 7 ? 8'000'000 : 3'000'000);
    times.end_frame(50'000'000);
  }
  EXPECT_EQ(times.of(Part::physics).mean_ms, 2.0);
  EXPECT_EQ(times.of(Part::drawing).worst_ms, 0.0);
  EXPECT_EQ(times.of(Part::whole).worst_ms, 8.0) << "the slow frame was more than a second ago";
  EXPECT_DOUBLE_EQ(times.of(Part::whole).mean_ms, 3.25);
}

TEST(FrameTimes, OfManyShortFramesAreThoseOfTheLastOnes) {
  FrameTimes times;
  for (int frame = 0; frame < 1000; ++frame) {
    times.add(Part::whole, frame * 1'000'000);
    times.end_frame(1);
  }
  EXPECT_EQ(times.of(Part::whole).worst_ms, 999.0);
  EXPECT_DOUBLE_EQ(times.of(Part::whole).mean_ms, 0.5 * (999.0 + 760.0));
}

}  // namespace
}  // namespace game
