#pragma once

#include <array>
#include <cstddef>

#include "tests/study/trace.h"

namespace study {

/// Statistics of a run after the tick from which its motion is chaotic.
struct Statistics {
  static constexpr std::size_t count = 6;
  static constexpr std::array<const char*, count> names = {
      "chaotic_height_m",        // mean of the player's height
      "chaotic_height_sd_m",     // its standard deviation
      "chaotic_stretch",         // mean of the cords' mean stretch, relative to their whole lengths
      "chaotic_peak_stretch",    // maximum over cords and ticks
      "chaotic_kinetic_J_kg",    // mean of kinetic energy per mass, of all cords and dynamic bodies
      "chaotic_kinetic_sd_J_kg"  // its standard deviation
  };
  std::array<double, count> values = {unavailable, unavailable, unavailable,
                                      unavailable, unavailable, unavailable};  ///< by name
};

/// Returns the statistics of all ticks after the first `from`; NaN without such ticks, or if the run ended early.
Statistics statistics(const Trace& trace, std::size_t from);

/// Returns the absolute differences.
Statistics difference(const Statistics& a, const Statistics& b);

}  // namespace study
