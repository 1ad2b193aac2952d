#include "game/screens/pace.h"

namespace game {

void Pace::read_keys(const engine::WindowInput& input, const Settings& settings, bool can_stop) {
  const auto pressed = [&](Action action) { return settings.bindings.pressed(action, input); };
  if (pressed(Action::pause)) stopped_ = can_stop && !stopped_;
  if (pressed(Action::step)) stopped_ = true;
  if (pressed(Action::slow_motion)) slowed_ = slowed_ == 4 ? 1 : 2 * slowed_;
}

}  // namespace game
