#pragma once

#include <array>
#include <cstddef>

#include "tests/study/trace.h"

namespace study {

/// What can be said of a run where what it does is chance: of its ticks from one on.
struct Statistics {
  static constexpr std::size_t count = 6;
  static constexpr std::array<const char*, count> names = {
      "later_height_m",        // mean of the player's height
      "later_height_sd_m",     // its standard deviation
      "later_stretch",         // mean of the cords' mean stretch, as a share of their whole lengths
      "later_peak_stretch",    // of the cord that stretches most, in any of the ticks
      "later_kinetic_J_kg",    // mean of kinetic energy a unit of mass, of all cords and dynamic bodies
      "later_kinetic_sd_J_kg"  // its standard deviation
  };
  std::array<double, count> values = {lacking, lacking, lacking, lacking, lacking, lacking};  ///< by name
};

/// Of all ticks after the first `from`. No numbers if there are none, or the run ended before its time.
Statistics statistics(const Trace& trace, std::size_t from);

/// The size of each one's difference.
Statistics difference(const Statistics& a, const Statistics& b);

}  // namespace study
