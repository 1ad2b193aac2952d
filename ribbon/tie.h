#pragma once

#include <span>

namespace ribbon {

/// A point of a cord that is tied to one of another cord: the two move as one. A point may have several ties.
struct Tie {
  int cord = 0;         ///< index of a cord among those of the step
  int point = 0;        ///< index of its point
  int other_cord = 0;   ///< index of the other cord
  int other_point = 0;  ///< index of its point
};

/// Throws DefinitionError for a tie of an unknown cord or point or of a cord to itself, and for ties that make two
/// points of a cord one through others. `points` has the number of points of each cord.
void check_ties(std::span<const Tie> ties, std::span<const int> points);

}  // namespace ribbon
