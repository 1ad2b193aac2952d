#include "game/simulation/pump.h"

#include <algorithm>

#include "ribbon/box2d/convert.h"

namespace game {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

void Pump::follow(int direction, const PlayerTuning& tuning) {
  ticks_left_ = direction == direction_ ? std::max(0, ticks_left_ - 1) : tuning.pump_ticks;
  direction_ = direction;
}

void Pump::push(b2Body& body, Vec2 from, const PlayerTuning& tuning, double dt) const {
  const Vec2 along = from - to_double(body.GetPosition());
  const double distance = length(along);
  if (direction_ == 0 || ticks_left_ == 0 || distance == 0.0) return;
  const Vec2 across = (1.0 / distance) * Vec2{along.y, -along.x};  // to the right for a cord that hangs
  const double impulse = direction_ * tuning.pump_acceleration * tuning.mass * dt;
  body.ApplyLinearImpulseToCenter(to_float(impulse * across), true);
}

void Pump::add_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(direction_);
  hasher.add(ticks_left_);
}

}  // namespace game
