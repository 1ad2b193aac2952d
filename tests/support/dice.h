#pragma once

#include <random>

namespace test_support {

/// The same numbers on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  /// 0 … 1.
  double operator()() { return static_cast<double>(random_()) / 4294967296.0; }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }
  bool coin() { return (random_() & 0x80000000U) != 0; }

 private:
  std::mt19937 random_;
};

}  // namespace test_support
