#include "game/view/noise.h"

namespace game {
namespace {

int wrapped(int i, int period) { return i >= 0 && i < period ? i : ((i % period) + period) % period; }

/// Rounds down. Does not use floor, which would be a call.
int whole_below(double x) {
  const int whole = static_cast<int>(x);
  return whole - (whole > x ? 1 : 0);
}

double smooth(double t) { return t * t * (3.0 - 2.0 * t); }

}  // namespace

double scatter(int x, int y, int seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1U ^ static_cast<std::uint32_t>(y) * 0x85ebca77U ^
                    static_cast<std::uint32_t>(seed) * 0xc2b2ae3dU;
  h = (h ^ h >> 15U) * 0x2c1b3c6dU;
  h = (h ^ h >> 12U) * 0x297a2d39U;
  h ^= h >> 15U;
  return static_cast<double>(h >> 8U) / 16777216.0;
}

double tiled_noise(double x, double y, int period, int seed) {
  const int column = whole_below(x);
  const int row = whole_below(y);
  const double u = smooth(x - column);
  const double v = smooth(y - row);
  const auto at = [&](int i, int j) { return scatter(wrapped(column + i, period), wrapped(row + j, period), seed); };
  const double upper = at(0, 0) + u * (at(1, 0) - at(0, 0));
  if (v == 0.0) return upper;  // along an outline
  const double lower = at(0, 1) + u * (at(1, 1) - at(0, 1));
  return upper + v * (lower - upper);
}

double tiled_cloudiness(double x, double y, int period, int seed) {
  double sum = 0.0;
  double weight = 8.0 / 15.0;
  for (int octave = 0; octave < 4; ++octave, weight *= 0.5) {
    const int finer = 1 << octave;
    sum += weight * tiled_noise(finer * x, finer * y, finer * period, seed + octave);
  }
  return sum;
}

}  // namespace game
