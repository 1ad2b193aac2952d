#include "game/lab/knobs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace game::lab {
namespace {

constexpr double end_zone = 0.04;   // of a logarithmic slider, for the end that means 0 or infinity
constexpr double key_steps = 40.0;  // from one end to the other
static_assert(1.0 / key_steps > 0.5 * end_zone, "one press leaves an end that means 0 or infinity");

double rounded(double value, int digits) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1.0);
  return std::round(value / unit) * unit;
}

}  // namespace

double KnobRange::position_of(double value) const {
  if (scale != Scale::logarithmic) return (std::clamp(value, min, max) - min) / (max - min);
  if (min_is_zero && value <= 0.0) return 0.0;
  if (max_is_infinite && std::isinf(value)) return 1.0;
  const double low = min_is_zero ? end_zone : 0.0;
  const double high = max_is_infinite ? 1.0 - end_zone : 1.0;
  return low + (high - low) * std::log(std::clamp(value, min, max) / min) / std::log(max / min);
}

double KnobRange::value_at(double position) const {
  const double place = std::clamp(position, 0.0, 1.0);
  if (scale == Scale::linear) return min + std::round(100.0 * place) / 100.0 * (max - min);
  if (scale != Scale::logarithmic) return std::round(min + place * (max - min));
  const double low = min_is_zero ? end_zone : 0.0;
  const double high = max_is_infinite ? 1.0 - end_zone : 1.0;
  if (min_is_zero && place < 0.5 * end_zone) return 0.0;
  if (max_is_infinite && place > 1.0 - 0.5 * end_zone) return std::numeric_limits<double>::infinity();
  const double share = std::clamp((place - low) / (high - low), 0.0, 1.0);
  return std::clamp(rounded(min * std::pow(max / min, share), 2), min, max);
}

double KnobRange::stepped(double value, int steps) const {
  if (scale == Scale::whole) return std::clamp(value + steps, min, max);
  if (scale == Scale::choice) {
    const double choices = max - min + 1.0;
    const double moved = std::fmod(value - min + steps, choices);
    return min + (moved < 0.0 ? moved + choices : moved);
  }
  return value_at(position_of(value) + steps / key_steps);
}

}  // namespace game::lab
