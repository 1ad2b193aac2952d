#pragma once

#include <cstddef>

#include "tests/study/trace.h"

namespace study {

/// The errors of a run relative to a reference, each of its own kind; NaN if one of the runs lacks it.
///
/// Energy and momentum are not drifts: the player adds and removes both, so each is compared with that of the reference
/// in the same tick.
struct Errors {
  double position_m = unavailable;         ///< RMS over all stations of cords that exist in both runs, and ticks
  double position_relative = unavailable;  ///< the same, relative to each cord's length
  double player_m = 0.0;                   ///< RMS over all ticks
  double stretch = 0.0;                    ///< of the peak, relative to a cord's length
  double tension = unavailable;            ///< of the peak, relative to the reference's peak
  double penetration = unavailable;        ///< maximum of the run itself after any tick, relative to the cord's radius
  double energy = unavailable;             ///< maximum after any tick, relative to total weight × longest cord
  double momentum = unavailable;           ///< maximum after any tick, relative to total mass × √(g × longest cord)
  double body_m = unavailable;             ///< RMS over the second player, the dynamic bodies and all ticks

  /// Returns the largest of the errors that are lengths, m; 0 if nothing is compared.
  double greatest_length() const;
};

/// Returns the errors of `run` relative to `reference`, a run of the same level, in the first `ticks` that both have.
Errors difference(const Trace& run, const Trace& reference, std::size_t ticks);

/// Returns whether two runs differ in a tick that both have by at most `most` metres everywhere.
bool agree(const Trace& a, const Trace& b, std::size_t tick, double most);

/// Returns the number of ticks in which two runs differ by at most `most` metres everywhere: players, bodies, and cords
/// that exist in both. Later motion is chaotic.
std::size_t agreeing_ticks(const Trace& a, const Trace& b, double most);

/// Calls `visit` with the indices of each cord that exists in both runs in a tick, and its id.
template <typename Visit>
void for_each_common_cord(const Trace& a, const Trace& b, std::size_t tick, Visit&& visit) {
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.cords[tick].size(); ++i) {
    while (j < b.cords[tick].size() && b.cords[tick][j] < a.cords[tick][i]) ++j;
    if (j == b.cords[tick].size()) return;
    if (b.cords[tick][j] == a.cords[tick][i]) visit(i, j, static_cast<std::size_t>(a.cords[tick][i].cord));
  }
}

}  // namespace study
