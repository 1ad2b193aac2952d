#include "game/simulation/legs.h"

#include <algorithm>

#include "game/simulation/footing.h"

namespace game {

void Legs::detect_ground(const b2Body& body, const ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning) {
  const Footing footing = find_footing(body, coupling, tuning);
  detected_ground_ = footing.is_ground;
  on_firm_ground_ = footing.is_firm;
  if (!footing.is_ground) return;
  ground_rise_ = footing.rise;
  was_on_cord_ = footing.is_cord;
}

void Legs::begin_tick(bool jump, b2Body& body, const ribbon::box2d::Coupling& coupling, const PlayerTuning& tuning) {
  if (!detected_ground_) detect_ground(body, coupling, tuning);
  if (!*detected_ground_ && is_on_ground() && ticks_since_jump_ > tuning.coyote_ticks) stay_low(body, tuning);
  ticks_off_ground_ = *detected_ground_ ? 0 : std::min(ticks_off_ground_ + 1, long_ago);
  detected_ground_.reset();
  ticks_since_jump_pressed_ = jump ? 0 : std::min(ticks_since_jump_pressed_ + 1, long_ago);
  ticks_since_release_ = std::min(ticks_since_release_ + 1, long_ago);
}

/// Running up a step or a steep end of a bridge must not throw the player into the air. What the ground itself gives,
/// as a trampoline does, it keeps.
void Legs::stay_low(b2Body& body, const PlayerTuning& tuning) const {
  const b2Vec2 velocity = body.GetLinearVelocity();
  const auto most = static_cast<float>(std::max(0.0, ground_rise_) + tuning.step_speed);
  if (velocity.y > most) body.SetLinearVelocity({velocity.x, most});
}

void Legs::move(int direction, bool holds_jump, b2Body& body, const PlayerTuning& tuning, double dt) {
  run(direction, body, tuning, dt);
  cut_jump(holds_jump, body, tuning);
  const double speed_up = static_cast<double>(body.GetLinearVelocity().y);
  jump_if_possible(body, tuning);
  speed_up_before_ = speed_up;
}

void Legs::run(int direction, b2Body& body, const PlayerTuning& tuning, double dt) const {
  b2Vec2 velocity = body.GetLinearVelocity();
  const double speed = static_cast<double>(velocity.x);
  const double target = direction * tuning.run_speed;
  double max_change = (is_on_ground() ? tuning.ground_acceleration : tuning.air_acceleration) * dt;
  const bool would_lose_speed = direction == 0 || speed * direction > tuning.run_speed;
  if (!is_on_ground() && would_lose_speed) max_change = 0.0;
  velocity.x = static_cast<float>(speed + std::clamp(target - speed, -max_change, max_change));
  body.SetLinearVelocity(velocity);
}

void Legs::jump_if_possible(b2Body& body, const PlayerTuning& tuning) {
  if (ticks_since_jump_pressed_ == 0 && ticks_since_release_ <= tuning.hop_ticks && !is_on_ground())
    return hop(body, tuning);
  ticks_since_jump_ = std::min(ticks_since_jump_ + 1, long_ago);
  if (ticks_since_jump_pressed_ > tuning.jump_buffer_ticks || ticks_off_ground_ > tuning.coyote_ticks) return;
  if (ticks_since_jump_ < tuning.jump_pause_ticks) return;
  const b2Vec2 velocity = body.GetLinearVelocity();
  // A cord that still throws the player up is used to the end.
  const bool is_thrown = was_on_cord_ && is_on_ground() &&
                         static_cast<double>(velocity.y) > std::max(tuning.sinking_speed, speed_up_before_ + 0.05);
  if (is_thrown) {
    ticks_since_jump_pressed_ = 0;
    return;
  }
  // A jump off a bouncing surface adds a fraction of its speed.
  const double up =
      std::max(tuning.jump_speed, static_cast<double>(velocity.y) + tuning.bounce_fraction * tuning.jump_speed);
  body.SetLinearVelocity({velocity.x, static_cast<float>(up)});
  jump_can_be_cut_ = !was_on_cord_;
  ticks_since_jump_pressed_ = long_ago;
  ticks_since_jump_ = 0;
  ticks_off_ground_ = tuning.coyote_ticks + 1;
}

/// A jump off the ground is as high as its key is held. What a cord gives stays.
void Legs::cut_jump(bool key_is_down, b2Body& body, const PlayerTuning& tuning) {
  const b2Vec2 velocity = body.GetLinearVelocity();
  if (velocity.y <= 0.0F) jump_can_be_cut_ = false;
  if (!jump_can_be_cut_ || key_is_down || is_on_ground()) return;
  jump_can_be_cut_ = false;
  body.SetLinearVelocity({velocity.x, std::min(velocity.y, static_cast<float>(tuning.cut_speed))});
}

void Legs::hop(b2Body& body, const PlayerTuning& tuning) {
  const b2Vec2 velocity = body.GetLinearVelocity();
  body.SetLinearVelocity({velocity.x, velocity.y + static_cast<float>(tuning.hop_speed)});
  ticks_since_jump_pressed_ = long_ago;
  ticks_since_release_ = long_ago;
}

void Legs::jump_off_ledge(b2Body& body, const PlayerTuning& tuning) {
  body.SetLinearVelocity({0.0F, static_cast<float>(tuning.jump_speed)});
  ticks_since_jump_pressed_ = long_ago;
  jump_can_be_cut_ = false;
}

void Legs::leave_cord() {
  ticks_since_jump_pressed_ = long_ago;
  ticks_since_release_ = 0;
}

void Legs::add_times_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(ticks_off_ground_);
  hasher.add(ticks_since_jump_pressed_);
  hasher.add(ticks_since_release_);
  hasher.add(ticks_since_jump_);
}

void Legs::add_ground_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(ground_rise_);
  hasher.add(static_cast<int>(jump_can_be_cut_));
  hasher.add(static_cast<int>(was_on_cord_));
  hasher.add(speed_up_before_);
}

}  // namespace game
