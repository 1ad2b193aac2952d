#include "game/lab/knobs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "game/lab/scene.h"
#include "tests/support/constants.h"

namespace game::lab {
namespace {

using constants::infinity;

/// Each end of a slider is an end of its range, and the initial value stands where a drag would set it again.
TEST(Knobs, SlidersReachTheEndsOfTheirRanges) {
  for (const Scene& scene : scenes()) {
    for (const KnobRange& range : scene.knobs) {
      const auto what = std::string(scene.name) + ", knob " + std::to_string(static_cast<int>(range.knob));
      EXPECT_EQ(range.value_at(0.0), range.min_is_zero ? 0.0 : range.min) << what;
      EXPECT_EQ(range.value_at(1.0), range.max_is_infinite ? infinity : range.max) << what;
      const double again = range.value_at(range.position_of(range.initial));
      EXPECT_TRUE(again == range.initial || std::abs(again / range.initial - 1.0) < 0.05) << what << ": " << again;
    }
  }
}

TEST(Knobs, SlidersAreMonotonous) {
  for (const Scene& scene : scenes()) {
    for (const KnobRange& range : scene.knobs) {
      double before = range.value_at(0.0);
      for (double place = 0.0; place <= 1.0; place += 0.01) {
        EXPECT_GE(range.value_at(place), before) << scene.name;
        before = range.value_at(place);
      }
    }
  }
}

/// Keys reach both ends from anywhere, and leave the ends that mean 0 and infinity by one press.
TEST(Knobs, KeysReachBothEndsAndLeaveThem) {
  for (const Scene& scene : scenes()) {
    for (const KnobRange& range : scene.knobs) {
      if (range.scale == KnobRange::Scale::choice) continue;
      const double low = range.value_at(0.0);
      const double high = range.value_at(1.0);
      double value = low;
      for (int k = 0; k < 1000 && value < high; ++k) {
        const double next = range.stepped(value, 1);
        ASSERT_GT(next, value) << scene.name << ", knob " << static_cast<int>(range.knob);
        value = next;
      }
      EXPECT_EQ(value, high);
      for (int k = 0; k < 1000 && value > low; ++k) {
        const double next = range.stepped(value, -1);
        ASSERT_LT(next, value) << scene.name << ", knob " << static_cast<int>(range.knob);
        value = next;
      }
      EXPECT_EQ(value, low);
    }
  }
}

TEST(Knobs, AChoiceWrapsAround) {
  const KnobRange preset{Knob::preset, 0.0, 2.0, 1.0, KnobRange::Scale::choice};
  EXPECT_EQ(preset.stepped(2.0, 1), 0.0);
  EXPECT_EQ(preset.stepped(0.0, -1), 2.0);
  EXPECT_EQ(preset.stepped(1.0, 1), 2.0);
}

}  // namespace
}  // namespace game::lab
