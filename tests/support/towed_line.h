#pragma once

#include "ribbon/cord.h"
#include "ribbon/weather.h"

namespace test_support {

/// A line of 4 m and 10 g/m that hangs from a fixed point in a uniform flow of air, as if it were towed. With its
/// weight w per length and the pressure R = ½·ρ·C·d·u² it hangs straight, at the critical angle φ to the flow:
///
///     w·cos φ = R·sin² φ
///
/// Drag along it changes only its tension.
class TowedLine {
 public:
  static constexpr double dt = 1.0 / 60.0;  // s

  /// `speed`: of the flow, m/s, above 0. The line begins hanging down, or level.
  TowedLine(const ribbon::Accuracy& accuracy, double speed, bool level = false);

  ribbon::IslandReport step();
  ribbon::Cord& cord() { return cord_; }
  /// Returns the largest distance of a point from where it is in the closed form, as a share of the length.
  double error() const;
  /// Returns the angle between the line of the closed form and the flow, degrees.
  double degrees() const;

 private:
  ribbon::Weather flow_;
  ribbon::Cord cord_;
  ribbon::Vec2 direction_;  // of the closed form
  double time_ = 0.0;       // s
};

/// Returns the largest error of the speed of a level line of 0.1 kg/m that falls for 5 s, as a share of its terminal
/// velocity: v = v∞·tanh(g·t/v∞) with m·g = ½·ρ·C·d·v∞².
double error_of_a_fall(const ribbon::Accuracy& accuracy);

}  // namespace test_support
