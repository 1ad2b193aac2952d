#pragma once

#include <vector>

#include "ribbon/island/step_context.h"

namespace ribbon {

/// The last resort for a linearised piece that gained energy in anything but velocities, or stretched: it takes the
/// motion back. It does nothing if a cord was stretched at the start of the piece.
class Rollback {
 public:
  void resize(std::size_t slots, std::size_t tensions);
  /// Goes back by halves, and in the end to the start of the piece, until neither energy was gained since `before` nor
  /// an inextensible cord is stretched. While something drives the island, energy tells nothing, and only speeds are
  /// limited. Returns whether something was changed.
  bool apply(const StepContext& context, const Cord::Energy& before);

 private:
  void go_to(IslandState& state, double share);

  std::vector<Vec2> end_positions_;
  std::vector<Vec2> end_velocities_;
  std::vector<double> offsets_;  // of the tensions at the start from those of the shape
};

}  // namespace ribbon
