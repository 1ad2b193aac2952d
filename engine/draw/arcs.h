#pragma once

#include <algorithm>
#include <cmath>

#include "engine/draw/line_profile.h"

/// Arcs as chords; private to the meshes.
namespace engine {

inline constexpr double max_chord_error = 0.05;  // px, between an arc and its chords

/// Returns the number of chords of an arc that sweeps an angle, rad.
inline int arc_steps(double radius, double sweep) {
  const double step = 2.0 * std::acos(1.0 - std::min(max_chord_error / radius, 0.5));
  return static_cast<int>(std::clamp(std::ceil(std::abs(sweep) / step), 1.0, 512.0));
}

/// Returns the factor of the radius with which chords that each sweep an angle (rad) enclose the area of the disc.
inline double chord_compensation(double step) {
  const double angle = std::abs(step);
  return angle > 1e-6 ? std::sqrt(angle / std::sin(angle)) : 1.0;
}

/// Returns the profile of a disc of `radius` px: the cover by the distance from its middle.
inline Profile disc_profile(double radius) {
  // The volume of a truncated cone of height 1 with radii o, c = r ± 1/2 is π/3 (o² + oc + c²) = π (r² + 1/12).
  // With r² = radius² − 1/12 the disc has the exact total cover.
  const double squared = radius * radius - 1.0 / 12.0;
  if (squared < 0.25) return {0.0, 1.0, std::min(1.0, 3.0 * radius * radius)};
  return {std::sqrt(squared) - 0.5, std::sqrt(squared) + 0.5, 1.0};
}

}  // namespace engine
