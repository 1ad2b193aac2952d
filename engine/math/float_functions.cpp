#include "engine/math/float_functions.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/math/double_pair.h"
#include "engine/math/quarter_turns.h"

namespace engine {
namespace {

constexpr double relative_error = 0x1p-50;  // of the computations with doubles: a bound, the errors are near 2⁻⁵²
constexpr float linear_limit = 0x1p-12F;    // below it, sin(x) rounds to x and cos(x) to 1
constexpr float fast_limit = 1e5F;          // up to it, quarters · the first two parts of π/2 are exact

float size(float x) { return x < 0.0F ? -x : x; }

/// Whether all numbers within the error of `value` round to the same float.
bool is_certain(double value) {
  const double error = relative_error * value;
  return static_cast<float>(value - error) == static_cast<float>(value + error);
}

/// Sums coefficient[k] · x^k (Horner).
template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double x) {
  double sum = coefficients[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

// Taylor's series: with |x| ≤ π/4 what is left out is below 2⁻⁵⁹ of the result.
constexpr std::array sine_terms = {
    -1.0 / 6.0,        1.0 / 120.0,        -1.0 / 5040.0,          1.0 / 362880.0,
    -1.0 / 39916800.0, 1.0 / 6227020800.0, -1.0 / 1307674368000.0, 1.0 / 355687428096000.0};
constexpr std::array cosine_terms = {-0.5,
                                     1.0 / 24.0,
                                     -1.0 / 720.0,
                                     1.0 / 40320.0,
                                     -1.0 / 3628800.0,
                                     1.0 / 479001600.0,
                                     -1.0 / 87178291200.0,
                                     1.0 / 20922789888000.0};

struct DoubleSines {
  double sine, cosine;
};

DoubleSines sines_of_rest(double x) {
  const double x2 = x * x;
  return {x + x * (x2 * polynomial(sine_terms, x2)), 1.0 + x2 * polynomial(cosine_terms, x2)};
}

struct PairSines {
  DoublePair sine, cosine;
};

/// Taylor's series of an angle of at most π/4 with pairs: what is left out is below 2⁻¹⁰⁰.
PairSines sines_of_rest(DoublePair x) {
  const DoublePair x2 = x * x;
  DoublePair sine{1.0, 0.0};
  DoublePair cosine{1.0, 0.0};
  for (int k = 14; k > 0; --k) {
    sine = DoublePair{1.0, 0.0} - sine * x2 / (2.0 * k * (2.0 * k + 1.0));
    cosine = DoublePair{1.0, 0.0} - cosine * x2 / (2.0 * k * (2.0 * k - 1.0));
  }
  return {x * sine, cosine};
}

/// Turns (cosine, sine) by a number of quarter turns.
template <typename Sines>
Sines turned(Sines of_rest, unsigned quarters) {
  switch (quarters & 3U) {
    case 1: return {of_rest.cosine, -of_rest.sine};
    case 2: return {-of_rest.sine, -of_rest.cosine};
    case 3: return {-of_rest.cosine, of_rest.sine};
    default: return of_rest;
  }
}

/// For fast_limit at most.
DoubleSines near_sines(float x) {
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  constexpr double half_pi_1 = 0x1.921fb544p+0, half_pi_2 = 0x1.0b4611a6p-34, half_pi_3 = 0x1.3198a2e037073p-69;
  constexpr double to_whole = 0x1.8p52;  // adding it rounds to a whole number
  const auto wide = static_cast<double>(x);
  const double quarters = (wide * two_over_pi + to_whole) - to_whole;
  const double rest = ((wide - quarters * half_pi_1) - quarters * half_pi_2) - quarters * half_pi_3;
  return turned(sines_of_rest(rest), static_cast<unsigned>(static_cast<std::int64_t>(quarters)));
}

DoubleSines double_sines(float x) {
  if (size(x) <= fast_limit) return near_sines(x);
  const QuarterTurns turns = quarter_turns(x);
  return turned(sines_of_rest(turns.rest.high), turns.quarters);
}

PairSines pair_sines(float x) {
  const QuarterTurns turns = quarter_turns(x);
  return turned(sines_of_rest(turns.rest), turns.quarters);
}

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// What follows is the angle of (high, low) with 0 ≤ low ≤ high: at most π/4.

/// atan(k/8).
constexpr std::array<DoublePair, 9> eighths = {{{0.0, 0.0},
                                                {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                                {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                                {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                                {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                                {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                                {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                                {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                                {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};
constexpr std::array angle_terms = {-1.0 / 3.0, 1.0 / 5.0, -1.0 / 7.0, 1.0 / 9.0, -1.0 / 11.0, 1.0 / 13.0};

double double_angle(double low, double high) {
  const auto k = static_cast<std::size_t>(std::lround(8.0 * (low / high)));
  // The rest of the angle has a tangent of 1/16 at most. Its numerator is exact, for low and high are floats.
  const double part = static_cast<double>(k) / 8.0;
  const double tangent = (low - part * high) / (high + part * low);
  const double t2 = tangent * tangent;
  return eighths[k].high + (tangent + (tangent * (t2 * polynomial(angle_terms, t2)) + eighths[k].low));
}

DoublePair pair_angle(double low, double high) {
  const double near = double_angle(low, high);
  if (near < 0x1p-40) {
    // The angle is low/high, less a third of its cube: too little to change a float, unless low/high is midway between
    // two.
    const double rest = low - near * high;
    const DoublePair product = exact_product(near, high);
    const double left = (low - product.high) - product.low;
    return {near, (rest == 0.0 && left == 0.0) ? -0x1p-60 * near : left / high};
  }
  // One step of Newton from the angle with an error of 2⁻⁵⁰: that of the result is its cube.
  const PairSines sines = sines_of_rest(DoublePair{near, 0.0});
  const DoublePair across = DoublePair{low, 0.0} * sines.cosine - DoublePair{high, 0.0} * sines.sine;
  const double along = high * sines.cosine.high + low * sines.sine.high;
  return ordered_sum(near, (across.high + across.low) / along);
}

/// Returns the angle of (x, y) from that of the larger and the smaller coordinate.
template <typename Angle>
Angle in_its_octant(Angle angle, float y, float x, Angle half_turn, Angle quarter_turn) {
  if (size(y) > size(x)) angle = quarter_turn - angle;
  if (std::signbit(x)) angle = half_turn - angle;
  return std::signbit(y) ? -angle : angle;
}

constexpr DoublePair pi{2.0 * half_pi.high, 2.0 * half_pi.low};

}  // namespace

float correct_sine(float x) {
  if (size(x) <= linear_limit) return x;
  if (!std::isfinite(x)) return not_a_number;
  const double sine = double_sines(x).sine;
  return is_certain(sine) ? static_cast<float>(sine) : to_float(pair_sines(x).sine);
}

float correct_cosine(float x) {
  if (size(x) <= linear_limit) return 1.0F;
  if (!std::isfinite(x)) return not_a_number;
  const double cosine = double_sines(x).cosine;
  return is_certain(cosine) ? static_cast<float>(cosine) : to_float(pair_sines(x).cosine);
}

SineCosine correct_sine_cosine(float x) {
  if (size(x) <= linear_limit) return {x, 1.0F};
  if (!std::isfinite(x)) return {not_a_number, not_a_number};
  const DoubleSines near = double_sines(x);
  if (is_certain(near.sine) && is_certain(near.cosine))
    return {static_cast<float>(near.sine), static_cast<float>(near.cosine)};
  const PairSines sines = pair_sines(x);
  return {to_float(sines.sine), to_float(sines.cosine)};
}

float correct_atan2(float y, float x) {
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  float across = size(y);
  float along = size(x);
  if (std::isinf(across) || std::isinf(along)) {
    across = std::isinf(across) ? 1.0F : 0.0F;
    along = std::isinf(along) ? 1.0F : 0.0F;
  }
  const float octant_y = std::copysign(across, y);
  const float octant_x = std::copysign(along, x);
  const auto low = static_cast<double>(across > along ? along : across);
  const auto high = static_cast<double>(across > along ? across : along);
  const double near = low == 0.0 ? 0.0 : double_angle(low, high);
  const double angle = in_its_octant(near, octant_y, octant_x, pi.high, half_pi.high);
  if (low == 0.0 || is_certain(angle)) return static_cast<float>(angle);
  return to_float(in_its_octant(pair_angle(low, high), octant_y, octant_x, pi, half_pi));
}

}  // namespace engine
