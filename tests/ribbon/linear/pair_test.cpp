#include "ribbon/linear/pair.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace ribbon {
namespace {

using Doubles = std::array<double, 2>;

/// Finite doubles of all magnitudes: zeros, subnormals and results that overflow or cancel among them.
std::vector<double> samples() {
  constexpr double min = std::numeric_limits<double>::min();
  constexpr double max = std::numeric_limits<double>::max();
  std::vector<double> all{0.0, -0.0, 1.0, -1.0, 1.0 + 0x1p-52, 0.1, min, -0.5 * min, 0x1p-1074, max, -0.75 * max};
  std::mt19937_64 random(5);
  while (all.size() < 60) {
    const double value = std::bit_cast<double>(random());
    if (value - value == 0.0) all.push_back(value);
    all.push_back(static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5);
  }
  return all;
}

/// Every operation of the block elimination, on one block row l, one block c and one target t.
template <typename P>
std::vector<double> results(const Doubles& l, const Doubles& c, const Doubles& t) {
  const P a = load_pair<P>(l.data());
  const P b = load_pair<P>(c.data());
  std::vector<double> out;
  const auto add = [&out](P pair) { out.insert(out.end(), {pair[0], pair[1]}); };
  add(a + b);
  add(a - b);
  add(a * b);
  add(t[0] * a);
  add(a * t[0]);
  add(t[0] * a + t[1] * b);
  add(a[0] * b + a[1] * b);
  add(a * b + b * b);
  Doubles target = t;
  subtract_pair(a[0] * b + a[1] * a, target.data());
  out.insert(out.end(), target.begin(), target.end());
  store_pair(a, target.data());
  out.insert(out.end(), target.begin(), target.end());
  return out;
}

/// All NaNs are equal: their sign and payload depend on the order of operands, which a compiler may exchange.
std::uint64_t bits(double value) { return value == value ? std::bit_cast<std::uint64_t>(value) : ~std::uint64_t{0}; }

TEST(Pair, HasTheSameBitsAsAPlainStruct) {
  const std::vector<double> all = samples();
  std::mt19937 random(9);
  const auto pick = [&] { return all[random() % all.size()]; };
  for (int k = 0; k < 20000; ++k) {
    const Doubles l{pick(), pick()};
    const Doubles c{pick(), pick()};
    const Doubles t{pick(), pick()};
    const std::vector<double> fast = results<Pair>(l, c, t);
    const std::vector<double> plain = results<PlainPair>(l, c, t);
    for (std::size_t i = 0; i < fast.size(); ++i) {
      ASSERT_EQ(bits(fast[i]), bits(plain[i])) << "result " << i << ": " << fast[i] << ", plain " << plain[i];
    }
  }
}

TEST(Pair, WorksOnEachLaneAlone) {
  const Doubles l{3.0, 5.0};
  const auto a = load_pair<PlainPair>(l.data());
  const PlainPair sum = 2.0 * a + a * a;
  EXPECT_EQ(sum[0], 15.0);
  EXPECT_EQ(sum[1], 35.0);
}

}  // namespace
}  // namespace ribbon
