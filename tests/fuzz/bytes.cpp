#include "tests/fuzz/bytes.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace fuzz {
namespace {

using Limits = std::numeric_limits<double>;

constexpr std::array hostile_numbers = {Limits::quiet_NaN(),
                                        Limits::infinity(),
                                        -Limits::infinity(),
                                        Limits::max(),
                                        Limits::lowest(),
                                        Limits::denorm_min(),
                                        Limits::min(),
                                        -Limits::min(),
                                        1e308,
                                        -1e308,
                                        1e-300,
                                        1e155,
                                        1e39,
                                        -1e39,
                                        1e18,
                                        1e9,
                                        -1e9,
                                        1.000001e9,
                                        1e6,
                                        -1.0,
                                        -0.0,
                                        0.0};

}  // namespace

std::uint8_t Bytes::byte() {
  if (left_.empty()) return 0;
  const std::uint8_t first = left_.front();
  left_ = left_.subspan(1);
  return first;
}

int Bytes::integer(int low, int high) {
  const std::uint8_t choice = byte();
  if (choice < 240) return low + choice % (high - low + 1);
  const std::array edges = {
      low - 1, high, low, -1, 0, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
  return edges[choice % edges.size()];
}

double Bytes::number(double low, double high) {
  const std::uint8_t choice = byte();
  if (choice >= 232) return hostile();
  if (choice >= 216) return low;
  if (choice >= 200) return high;
  const double share = byte() / 255.0;
  if (low > 0.0 && high > 0.0) return low * std::pow(high / low, share);
  return low + share * (high - low);
}

double Bytes::hostile() {
  const std::size_t choice = byte() % (hostile_numbers.size() + 1);
  if (choice < hostile_numbers.size()) return hostile_numbers[choice];
  std::uint64_t bits = 0;
  for (int k = 0; k < 8; ++k) bits = bits << 8U | byte();
  return std::bit_cast<double>(bits);
}

ribbon::Vec2 Bytes::vector(double low, double high) {
  const double x = number(low, high);
  return {x, number(low, high)};
}

}  // namespace fuzz
