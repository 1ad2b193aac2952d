#pragma once

#include <string>
#include <vector>

#include "ribbon/vec2.h"
#include "tests/peers/plan.h"

namespace peers {

/// The duration of a tick, and the positions after it.
struct Frame {
  double us = 0.0;
  std::vector<std::vector<ribbon::Vec2>> cords{};  ///< by cord: its points, or the ends of its chain's links
  std::vector<ribbon::Vec2> moving_bodies{};       ///< by Plan::moving_bodies
};

/// A recorded scene: one frame per tick, without the plan's settling_ticks. It may end early.
using Recording = std::vector<Frame>;

/// m; a position beyond this, or NaN, counts as a blow-up.
inline constexpr double max_coordinate = 1e4;
bool is_in_bounds(const Frame& frame);

/// Returns the number of points of all cords in a frame.
int points_of(const Plan& plan);

/// Reads a file of 64-bit floating-point numbers, frame after frame: us, then x and y of each cord's points and of each
/// moving_body. Throws std::runtime_error if it cannot be read, or does not fit the plan.
Recording read_recording(const std::string& path, const Plan& plan);

}  // namespace peers
