#pragma once

#include <string>
#include <vector>

#include "ribbon/vec2.h"
#include "tests/peers/plan.h"

namespace peers {

/// What a tick took, and where everything was after it.
struct Frame {
  double us = 0.0;
  std::vector<std::vector<ribbon::Vec2>> cords{};  ///< by cord: its points, or the ends of its chain's links
  std::vector<ribbon::Vec2> movers{};              ///< by Plan::movers
};

/// A scene as an engine played it: a frame a tick, without those of the plan's calm_ticks. It may end early.
using Recording = std::vector<Frame>;

/// m, beyond which nothing of a scene has any business: what gets there blew up, and so did what is no number.
inline constexpr double furthest = 1e4;
bool is_somewhere(const Frame& frame);

/// Points of all cords, in a frame.
int points_of(const Plan& plan);

/// From a file of 64-bit floating-point numbers, frame after frame: us, then x and y of each cord's points and of each
/// mover. Throws std::runtime_error if it cannot be read, or is not of the plan.
Recording read_recording(const std::string& path, const Plan& plan);

}  // namespace peers
