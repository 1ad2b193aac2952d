#pragma once

#include <vector>

#include "ribbon/cord.h"

namespace test_support {

/// A 10 m cord of 50 links and 1 kg with a load of 70 kg at its end, released at rest from the horizontal.
/// `stiffness` is EA in N, infinity for an inextensible cord.
ribbon::Cord heavy_swing(double stiffness, const ribbon::Accuracy& accuracy);

struct HeavySwingRun {
  std::vector<ribbon::Vec2> load;  ///< m, after each tick of 1/60 s
  double lost_energy = 0.0;        ///< at the end, as a share of M·g·L, M the mass of cord and load
  double peak_stretch = 0.0;       ///< of the whole cord, as a share of its length
  ribbon::IslandReport report;     ///< summed over all ticks
};

/// Runs it for five seconds.
HeavySwingRun run_heavy_swing(double stiffness, const ribbon::Accuracy& accuracy);

/// The root of the mean square of the distances between two paths, m.
double rms_distance(const std::vector<ribbon::Vec2>& a, const std::vector<ribbon::Vec2>& b);

}  // namespace test_support
