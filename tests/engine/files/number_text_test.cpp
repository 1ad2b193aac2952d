#include "engine/files/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace engine {
namespace {

TEST(NumberText, IsTheShortestThatReadsAsTheNumber) {
  EXPECT_EQ(shortest_text_by_search(0.1), "0.1");
  EXPECT_EQ(shortest_text_by_search(-2.0), "-2");
  EXPECT_EQ(shortest_text_by_search(1e-7), "1e-07");
  EXPECT_EQ(shortest_text_by_search(1.0 / 3.0), "0.3333333333333333");
}

TEST(NumberText, TheSearchWritesWhatTheLibraryWrites) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    const double bits = std::bit_cast<double>(random());
    // Numbers of all sizes, then those that a level has.
    const double value = k % 2 == 0 ? bits : std::ldexp(static_cast<double>(random() % 100000), -(k % 20));
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(shortest_text_by_search(value), shortest_text(value));
  }
  for (const double value : {0.0, -0.0, std::numeric_limits<double>::max(), std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(), 1e22, 1e23, 123456789012345680000.0}) {
    EXPECT_EQ(shortest_text_by_search(value), shortest_text(value));
  }
}

TEST(NumberText, BothReadersAgree) {
  for (const char* const text : {"0", "-0.25", "1.", ".5", "120", "", "-", ".", "1e3", "+1", " 1", "1 ", "0x10",
                                 "1.2.3", "--1", "inf", "nan", "12a"}) {
    EXPECT_EQ(fixed_number_by_strtod(text), fixed_number(text)) << text;
  }
  EXPECT_EQ(fixed_number_by_strtod("-0.25"), -0.25);
  EXPECT_FALSE(fixed_number_by_strtod("1e3"));
}

}  // namespace
}  // namespace engine
