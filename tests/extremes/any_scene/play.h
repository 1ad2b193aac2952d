#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/extremes/any_scene/oracles.h"
#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

/// What a tick was like.
struct Sample {
  int work = 0;               ///< Newton steps, each island once
  int unconverged = 0;        ///< substeps
  double left = 0.0;          ///< m, CordReport::position_error of the worst of them; 0 if all converged
  double milliseconds = 0.0;  ///< of Coupling::step; for information
  double stretch = 0.0;       ///< of inextensible ropes, relative
  double strain = 0.0;        ///< of the others
  double speed = 0.0;         ///< m/s, of the fastest point
  double energy = 0.0;        ///< J
  double gain = 0.0;          ///< energy gained in the tick, of the greatest kinetic energy so far + m·g·height range
  double rise = 0.0;          ///< the same since the lowest energy so far
  World::Gaps gaps;
  Depth penetration;               ///< Oracles::penetration
  std::vector<Meeting> crossings;  ///< Oracles::crossings
  int inverted = 0;                ///< corners of ribbons turned inside out that were not
  bool finite = true;
};

/// How a run ended.
enum class End : unsigned char {
  whole,    ///< after all ticks
  cut,      ///< after the time that it was given
  broken,   ///< something was not finite
  refused,  ///< its definition was
  crashed,  ///< its process ended
};
std::string_view name(End end);

struct Outcome {
  std::vector<Sample> ticks;
  End end = End::whole;
  std::string message;  ///< why it was refused
};

/// Plays a scene, for at most so many seconds; what exceeds them ends after the tick that does.
Outcome play(const Scene& scene, double max_seconds);

}  // namespace any_scene
