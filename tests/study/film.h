#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "game/simulation/level.h"
#include "tests/study/trace.h"

namespace study {

/// The frame of all films of a level, so that they can be drawn over each other.
struct Stage {
  ribbon::Vec2 origin;  ///< m, the middle of what the converged run reaches
  double unit = 1e-3;   ///< m, of the numbers of a film
  std::size_t ticks_per_frame = 2;
  std::vector<std::vector<ribbon::Vec2>> scenery;  ///< m, outlines of what does not move
};

/// Where and when a run differs most from its reference, in the ticks that are compared.
struct GreatestError {
  std::size_t tick = 0;  ///< from 1; 0: nothing differs
  double metres = 0.0;
  ribbon::Vec2 place;            ///< m, in the run
  ribbon::Vec2 reference_place;  ///< m
};

/// A run to be drawn: the frames as 16-bit numbers in base64. A frame is the number of cords; for each cord the number
/// of its points and their coordinates in units of the stage; the number of bodies, the player first, and their
/// coordinates.
struct Film {
  std::string frames;  ///< empty: there is no film
  GreatestError greatest;
};

Stage stage_of(const game::Level& level, const Trace& converged);
std::string frames_of(const Trace& trace, const Stage& stage);
GreatestError greatest_error(const Trace& run, const Trace& reference, std::size_t ticks);

}  // namespace study
