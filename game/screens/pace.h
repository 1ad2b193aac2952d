#pragma once

#include <cstdint>

#include "engine/tick/tick.h"
#include "engine/window/window_input.h"
#include "game/settings/settings.h"
#include "game/simulation/simulation.h"

namespace game {

/// How fast a run goes: at its speed, in slow motion, or stopped, tick by tick.
class Pace {
 public:
  /// Reads the keys for it. `can_stop`: that of a pause stops the run; else it opens a menu.
  void read_keys(const engine::WindowInput& input, const Settings& settings, bool can_stop);
  /// Returns the number of ticks that are due after a frame. `per_cent`: the speed.
  int ticks_in(std::int64_t elapsed_ns, int per_cent) {
    return clock_.advance(elapsed_ns * per_cent / (100 * slowed_));
  }

  void stop() { stopped_ = true; }
  bool is_stopped() const { return stopped_; }
  int slowed() const { return slowed_; }  ///< the factor of slow motion
  bool is_usual() const { return slowed_ == 1 && !stopped_; }
  double alpha() const { return clock_.alpha(); }  ///< engine::FixedTick::alpha

 private:
  engine::FixedTick clock_{ticks_per_second};
  bool stopped_ = false;
  int slowed_ = 1;
};

}  // namespace game
