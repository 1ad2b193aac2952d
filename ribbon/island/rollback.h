#pragma once

#include <vector>

#include "ribbon/cord_forces.h"
#include "ribbon/island/step_context.h"

namespace ribbon {

/// The last resort for a linearised piece that gained energy in anything but velocities, or stretched: it takes the
/// motion back. Unless the solve was truncated, it does nothing if a cord was stretched at the start of the piece.
class Rollback {
 public:
  void resize(std::size_t slots, std::size_t tensions);
  /// Takes the motion of each cord that is stretched back by halves, and with it what would come into its way. If the
  /// island has still gained energy since `before`, all of it goes back by halves, in the end to the start of the
  /// piece. While something drives the island, energy tells nothing, and only speeds are limited. After a truncated
  /// solve the contacts forget their forces, and energy is taken back whatever was stretched before. Returns whether
  /// something was changed.
  bool apply(const StepContext& context, const CordEnergy& before, bool truncated);
  /// Sets the tensions of extensible cords to those of their shapes, as far as the piece has changed these. The
  /// tensions of a solve that was truncated or did not end, or of which something was stopped, belong to other shapes,
  /// and have another energy.
  void fit_tensions(const StepContext& context);

 private:
  void begin(const StepContext& context);
  void take_stretched_back(const StepContext& context);
  void go_to(const StepContext& context, double share);

  std::vector<Vec2> end_positions_;
  std::vector<Vec2> end_velocities_;
  std::vector<double> end_tensions_;
  std::vector<double> offsets_;  // of the tensions at the start from those of the shape
};

}  // namespace ribbon
