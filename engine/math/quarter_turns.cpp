#include "engine/math/quarter_turns.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace engine {
namespace {

/// The bits of 2/π after the point: enough for the largest float.
constexpr std::array<std::uint32_t, 15> two_over_pi = {0xa2f9836eU, 0x4e441529U, 0xfc2757d1U, 0xf534ddc0U, 0xdb629599U,
                                                       0x3c439041U, 0xfe5163abU, 0xdebbc561U, 0xb7246e3aU, 0x424dd2e0U,
                                                       0x06492eeaU, 0x09d1921cU, 0xfe1deb1cU, 0xb129a73eU, 0xe88235f5U};

constexpr std::size_t words = 6;
using Window = std::array<std::uint32_t, words>;  // the highest bits first

/// Returns 32 bits of 2/π from the one with this number on, 0 for the first after the point. Before it are zeros.
std::uint32_t bits_from(int number) {
  const int word = number >= 0 ? number / 32 : -((31 - number) / 32);
  const auto at = [](int index) {
    return index < 0 ? 0U : std::uint64_t{two_over_pi[static_cast<std::size_t>(index)]};
  };
  return static_cast<std::uint32_t>((at(word) << 32U | at(word + 1)) << static_cast<unsigned>(number - 32 * word) >>
                                    32U);
}

/// Multiplies by `factor` and drops what is above the window.
void multiply(Window& window, std::uint32_t factor) {
  std::uint64_t carry = 0;
  for (std::size_t j = words; j-- > 0;) {
    carry += std::uint64_t{window[j]} * factor;
    window[j] = static_cast<std::uint32_t>(carry);
    carry >>= 32U;
  }
}

void negate(Window& window) {
  std::uint64_t carry = 1;
  for (std::size_t j = words; j-- > 0;) {
    carry += static_cast<std::uint32_t>(~window[j]);
    window[j] = static_cast<std::uint32_t>(carry);
    carry >>= 32U;
  }
}

}  // namespace

QuarterTurns quarter_turns(float x) {
  // |x| = significand · 2^exponent. Bits of 2/π that make whole turns of it are left out, so the window holds two bits
  // of quarter turns and 190 of their fraction.
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t significand = (bits & 0x7fffffU) | 0x800000U;
  const int exponent = static_cast<int>(bits >> 23U & 0xffU) - 150;
  Window window{};
  for (std::size_t j = 0; j < words; ++j) window[j] = bits_from(exponent - 2 + 32 * static_cast<int>(j));
  multiply(window, significand);

  unsigned quarters = window[0] >> 30U;
  const bool above_half = (window[0] & 0x20000000U) != 0U;
  if (above_half) {
    negate(window);
    ++quarters;
  }
  window[0] &= 0x3fffffffU;
  DoublePair fraction;
  double unit = 0x1p-30;
  for (const std::uint32_t word : window) {
    fraction = fraction + exact_sum(word * unit, 0.0);
    unit *= 0x1p-32;
  }
  DoublePair rest = fraction * half_pi;
  const bool negative = (bits >> 31U) != 0U;
  if (above_half != negative) rest = -rest;
  return {(negative ? 4U - quarters : quarters) & 3U, rest};
}

}  // namespace engine
