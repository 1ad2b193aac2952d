#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Numbers of about 104 bits: sums of two doubles.
namespace engine {

/// The number high + low, with |low| at most half a unit of the last bit of high.
struct DoublePair {
  double high = 0.0;
  double low = 0.0;
};

/// Exact, if |a| ≥ |b| or a is 0.
constexpr DoublePair ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Exact (Knuth).
constexpr DoublePair exact_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// Exact, up to 10³⁰⁰ (Dekker).
constexpr DoublePair exact_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2²⁷ + 1
  const double a_high = splitter * a - (splitter * a - a);
  const double b_high = splitter * b - (splitter * b - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

constexpr DoublePair operator-(DoublePair a) { return {-a.high, -a.low}; }

constexpr DoublePair operator+(DoublePair a, DoublePair b) {
  const DoublePair high = exact_sum(a.high, b.high);
  const DoublePair low = exact_sum(a.low, b.low);
  const DoublePair sum = ordered_sum(high.high, high.low + low.high);
  return ordered_sum(sum.high, sum.low + low.low);
}

constexpr DoublePair operator-(DoublePair a, DoublePair b) { return a + -b; }

constexpr DoublePair operator*(DoublePair a, DoublePair b) {
  const DoublePair product = exact_product(a.high, b.high);
  return ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoublePair operator/(DoublePair a, double b) {
  const double first = a.high / b;
  const DoublePair rest = a - exact_product(first, b);
  return ordered_sum(first, (rest.high + rest.low) / b);
}

/// Rounds once. Rounding `high` alone would err where it is midway between two floats.
inline float to_float(DoublePair value) {
  if (value.low == 0.0 || value.high == 0.0) return static_cast<float>(value.high);
  // With its last bit odd, a double is midway between no two floats, and lies on the same side of each of these.
  auto bits = std::bit_cast<std::uint64_t>(value.high);
  const bool towards_zero = (value.low < 0.0) != (value.high < 0.0);
  if ((bits & 1U) == 0U) bits = towards_zero ? bits - 1U : bits + 1U;
  return static_cast<float>(std::bit_cast<double>(bits));
}

}  // namespace engine
