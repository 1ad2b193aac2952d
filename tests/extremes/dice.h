#pragma once

#include <random>

namespace extremes {

/// 0 … 1, the same numbers on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double operator()() { return static_cast<double>(random_()) / 4294967296.0; }

 private:
  std::mt19937 random_;
};

}  // namespace extremes
