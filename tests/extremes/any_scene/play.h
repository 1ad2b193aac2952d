#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/extremes/any_scene/oracles.h"
#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

/// The figures of one tick.
struct Sample {
  int work = 0;               ///< Newton steps; each island counts once
  int unconverged = 0;        ///< substeps
  double left = 0.0;          ///< m, the greatest IslandReport::position_error of them; 0 if all converged
  double milliseconds = 0.0;  ///< of Coupling::step; for information only
  double stretch = 0.0;       ///< of inextensible ropes, relative length error
  double strain = 0.0;        ///< of all other cords
  double speed = 0.0;         ///< m/s, of the fastest point
  double energy = 0.0;        ///< J
  double gain = 0.0;          ///< energy gained in the tick / (greatest kinetic energy so far + m·g·height range)
  double rise = 0.0;          ///< the same, since the lowest energy so far
  World::Gaps gaps;
  Depth penetration;  ///< Oracles::penetration
  /// Change of mass and momentum of the cords by cuts before the tick, relative to the mass and to the mass times the
  /// highest speed.
  double imbalance = 0.0;
  std::vector<CrossedPair> crossings;  ///< Oracles::crossings
  int inverted = 0;                    ///< number of newly inverted corners of ribbons
  bool finite = true;
  bool hangs = false;  ///< not converged, and almost nothing has moved
  bool late = false;   ///< all that drives ended at least a second ago
};

/// How a run ended.
enum class End : unsigned char {
  completed,  ///< all ticks were played
  timed_out,  ///< the time limit was exceeded
  broken,     ///< a number was not finite
  refused,    ///< the definition was refused
  crashed,    ///< the process crashed
};
std::string_view name(End end);

struct Outcome {
  std::vector<Sample> ticks;
  End end = End::completed;
  std::string message;  ///< the reason of a refusal
};

/// Plays a scene. Stops after the tick in which the time exceeds `max_seconds`.
Outcome play(const Scene& scene, double max_seconds);

}  // namespace any_scene
