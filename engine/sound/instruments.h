#pragma once

#include <cstdint>
#include <vector>

#include "engine/sound/score.h"

/// The sounds of single notes, with the same bits on every machine.
namespace engine {

/// A cycle of samples. What reaches beyond its end continues at its start, so the cycle has no seam.
class Cycle {
 public:
  explicit Cycle(std::size_t size) : samples_(size) {}
  void add(std::size_t at, double value) { samples_[at % samples_.size()] += value; }
  const std::vector<double>& samples() const { return samples_; }
  std::vector<double>& samples() { return samples_; }

 private:
  std::vector<double> samples_;
};

/// Adds a note to a cycle of `rate` samples a second. Notes with different seeds (not 0) have different noise.
void add_note(Cycle& cycle, int rate, const ScoreVoice& voice, const ScoreNote& note, std::uint32_t seed);

}  // namespace engine
