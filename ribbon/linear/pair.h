#pragma once

#include <cstddef>
#include <cstring>

// Two doubles that are worked on at once. Every operation rounds each lane once, so both types give the same bits.

namespace ribbon {

/// Two doubles as a plain struct, for compilers without vector types.
struct PlainPair {
  double lane[2];

  double operator[](std::size_t k) const { return lane[k]; }
};
inline PlainPair operator+(PlainPair a, PlainPair b) { return {{a.lane[0] + b.lane[0], a.lane[1] + b.lane[1]}}; }
inline PlainPair operator-(PlainPair a, PlainPair b) { return {{a.lane[0] - b.lane[0], a.lane[1] - b.lane[1]}}; }
inline PlainPair operator*(PlainPair a, PlainPair b) { return {{a.lane[0] * b.lane[0], a.lane[1] * b.lane[1]}}; }
inline PlainPair operator*(double s, PlainPair b) { return {{s * b.lane[0], s * b.lane[1]}}; }
inline PlainPair operator*(PlainPair a, double s) { return s * a; }

#if defined(__GNUC__) || defined(__clang__)
/// Two doubles in one register. g++ 12 does not vectorise the rows of a block without it.
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;
#else
using Pair = PlainPair;
#endif
static_assert(sizeof(Pair) == 2 * sizeof(double));

/// Returns the pair of doubles that starts at `first`.
template <typename P = Pair>
P load_pair(const double* first) {
  P pair;
  std::memcpy(&pair, first, sizeof(pair));
  return pair;
}

/// Writes the pair to the two doubles that start at `first`.
template <typename P>
void store_pair(P pair, double* first) {
  std::memcpy(first, &pair, sizeof(pair));
}

/// Subtracts the pair from the two doubles that start at `first`.
template <typename P>
void subtract_pair(P pair, double* first) {
  store_pair(load_pair<P>(first) - pair, first);
}

}  // namespace ribbon
