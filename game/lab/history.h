#pragma once

#include <array>
#include <cstddef>

#include "game/lab/experiment.h"

namespace game::lab {

/// Energy and stretch of the benches of an experiment in the last seconds.
class History {
 public:
  static constexpr std::size_t length = 480;  ///< ticks, 8 s

  struct Sample {
    double energy = 0.0;   ///< J, since the start
    double stretch = 0.0;  ///< relative, of the most stretched cord
  };

  /// Adds what an experiment has after a tick. Forgets all before if the experiment has begun again.
  void add(const Experiment& experiment);
  void forget() { count_ = 0; }
  std::size_t size() const { return count_ < length ? count_ : length; }
  /// Returns a sample of a bench; 0 is the oldest one that is kept.
  const Sample& sample(std::size_t bench, std::size_t index) const {
    return samples_[bench][(count_ - size() + index) % length];
  }

 private:
  static constexpr std::size_t benches = 2;
  std::array<std::array<Sample, length>, benches> samples_{};
  std::size_t count_ = 0;  // of all since forget()
  int last_tick_ = 0;
};

}  // namespace game::lab
