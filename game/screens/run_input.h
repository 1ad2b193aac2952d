#pragma once

#include "engine/tick/input.h"
#include "engine/window/window_input.h"
#include "game/settings/controls.h"
#include "game/settings/settings.h"
#include "game/simulation/simulation.h"
#include "ribbon/vec2.h"

namespace game {

/// The controls of the player of a run, or of both, each with its half of the keyboard and its gamepad.
class RunInput {
 public:
  /// Adds the input of a frame. `mouse`: its position in the world, m. `dragging`: the left button only drags.
  void take(const engine::WindowInput& input, const Settings& settings, ribbon::Vec2 mouse, bool dragging, int players);
  /// Returns the input of the next tick, without a restart, which begins a run of its own.
  engine::TickInput next(const Simulation& simulation);

  // For both players: see Controls.
  void discard();
  void discard_presses();
  void ignore_held();

 private:
  Controls first_;
  Controls second_;  // in a level for two
};

}  // namespace game
