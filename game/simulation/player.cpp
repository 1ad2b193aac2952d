#include "game/simulation/player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "game/simulation/buttons.h"
#include "game/simulation/footing.h"
#include "game/simulation/nearest_pin.h"
#include "game/simulation/nearest_point.h"
#include "game/simulation/player_body.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr int long_ago = 1'000'000;  // ticks

/// Returns the position from which the held position hangs: the nearest constrained point, else the cord's first point.
Vec2 anchor_of(const ribbon::box2d::Coupling& coupling, const ribbon::box2d::CordPoint& held) {
  const ribbon::box2d::CordView cord = coupling.cord(held.cord);
  return cord.positions()[static_cast<std::size_t>(std::max(nearest_pin(cord, held.point), 0))];
}

}  // namespace

/// The meaning of the buttons of a tick.
struct Player::Command {
  Command(std::uint16_t buttons, std::uint16_t before)
      : direction(axis(buttons, button_right, button_left)),
        climb(axis(buttons, button_up, button_down)),
        grab((buttons & button_grab) != 0),
        jump((buttons & ~before & button_jump) != 0),
        holds_jump((buttons & button_jump) != 0) {
    const unsigned pressed = buttons & ~static_cast<unsigned>(before);
    lines.throws = {(pressed & button_throw) != 0, (pressed & button_throw_second) != 0};
    lines.ties = (pressed & button_tie) != 0;
    lines.reel = axis(buttons, button_reel_out, button_reel_in);
  }

  static int axis(std::uint16_t buttons, Button plus, Button minus) {
    return ((buttons & plus) != 0 ? 1 : 0) - ((buttons & minus) != 0 ? 1 : 0);
  }

  int direction;
  int climb;
  bool grab;
  bool jump;        // pressed in this tick
  bool holds_jump;  // its key is down
  Lines::Command lines;
};

Player::Player(b2World& world, Vec2 feet, const PlayerTuning& tuning, std::size_t lines, const LineTuning& line_tuning)
    : tuning_(tuning),
      body_(make_player_body(world, feet, tuning)),
      lines_(line_tuning, lines),
      ticks_since_jump_pressed_(long_ago),
      ticks_since_release_(long_ago),
      ticks_since_jump_(long_ago) {}

Vec2 Player::position() const { return to_double(body_->GetPosition()); }

/// The body is the set of places within `radius` of an upright line.
bool Player::touches(const Area& area) const {
  const Vec2 off = position() - area.center;
  const double straight = 0.5 * tuning_.height - tuning_.radius;
  const Vec2 gap{std::max(0.0, std::abs(off.x) - 0.5 * area.size.x),
                 std::max(0.0, std::abs(off.y) - 0.5 * area.size.y - straight)};
  return length(gap) <= tuning_.radius;
}

Vec2 Player::hand() const { return position() + Vec2{0.0, tuning_.hand_height}; }

void Player::apply(std::uint16_t buttons, const Targets& targets, ribbon::box2d::Coupling& coupling, double dt) {
  const Command command(buttons, buttons_before_);
  buttons_before_ = buttons;
  if (!command.grab) may_catch_ = true;
  if (command.direction != 0) faces_left_ = command.direction < 0;
  pump_ticks_left_ = command.direction == direction_ ? std::max(0, pump_ticks_left_ - 1) : tuning_.pump_ticks;
  direction_ = command.direction;
  update_ground(coupling);
  forget_left_cord(coupling);
  ticks_since_jump_pressed_ = command.jump ? 0 : std::min(ticks_since_jump_pressed_ + 1, long_ago);
  ticks_since_release_ = std::min(ticks_since_release_ + 1, long_ago);
  climbs_ = false;

  handle_lines(command, targets, coupling, dt);
  if (holds_cord(coupling)) {
    if (command.jump || !command.grab) {
      release_cord(coupling);
      if (command.jump) hop();
    } else {
      hang(command, coupling, dt);
    }
    return;
  }
  if (ledge_) return hang_from_ledge(command, dt);
  if (const Line* line = lines_.held(); line != nullptr && !is_on_ground()) {
    pump(line->end(), dt);
    if (command.jump) {
      leave(*line->cord());
      lines_.release(coupling);
      hop();
    }
  } else {
    run(command.direction, dt);
    cut_jump(command.holds_jump);
    const double speed_up = static_cast<double>(body_->GetLinearVelocity().y);
    jump_if_possible();
    speed_up_before_ = speed_up;
  }
  if (command.grab && may_catch_ && !catch_cord(coupling)) catch_ledge();
}

void Player::put(Vec2 feet, ribbon::box2d::Coupling& coupling) {
  lines_.release(coupling);
  coupling.body(*body_).release();
  ledge_.reset();
  grip_id_.reset();
  left_cord_.reset();
  may_catch_ = false;
  body_->SetTransform(to_float(feet + Vec2{0.0, 0.5 * tuning_.height}), 0.0F);
  body_->SetLinearVelocity({0.0F, 0.0F});
}

/// Returns whether the player holds a cord other than the line, which has a grip of its own.
bool Player::holds_cord(const ribbon::box2d::Coupling& coupling) const {
  return grip_id_ && coupling.grip(*grip_id_).is_valid();
}

std::optional<ribbon::box2d::CordPoint> Player::held_place(const ribbon::box2d::Coupling& coupling) const {
  if (!tether_) return coupling.body(*body_).held_place();
  if (!holds_cord(coupling)) {
    const Line* line = lines_.held();
    return line != nullptr ? line->held_place(coupling) : std::nullopt;
  }
  const ribbon::box2d::GripState held = coupling.grip(*grip_id_).state();
  return ribbon::box2d::CordPoint{held.cord, held.point, 0.0, held.along};
}

void Player::update_ground(const ribbon::box2d::Coupling& coupling) {
  if (!detected_ground_) detect_ground(coupling);
  if (!*detected_ground_ && is_on_ground() && ticks_since_jump_ > tuning_.coyote_ticks) stay_low();
  ticks_off_ground_ = *detected_ground_ ? 0 : std::min(ticks_off_ground_ + 1, long_ago);
  detected_ground_.reset();
}

/// Running up a step or a steep end of a bridge must not throw the player into the air. What the ground itself gives,
/// as a trampoline does, it keeps.
void Player::stay_low() {
  const b2Vec2 velocity = body_->GetLinearVelocity();
  const auto most = static_cast<float>(std::max(0.0, ground_rise_) + tuning_.step_speed);
  if (velocity.y > most) body_->SetLinearVelocity({velocity.x, most});
}

/// Throws, releases, flies, reels and knots the lines. When one arrives, the player lets go of a cord or a ledge.
void Player::handle_lines(const Command& command, const Targets& targets, ribbon::box2d::Coupling& coupling,
                          double dt) {
  lines_.use(command.lines, targets, hand(), coupling, dt);
  if (lines_.arrive()) {
    if (holds_cord(coupling)) release_cord(coupling);
    leave_ledge();
  }
  lines_.move(command.lines, coupling, *body_, {0.0, tuning_.hand_height}, dt);
}

void Player::detect_ground(const ribbon::box2d::Coupling& coupling) {
  const Footing footing = find_footing(*body_, coupling, tuning_);
  detected_ground_ = footing.is_ground;
  on_firm_ground_ = footing.is_firm;
  if (!footing.is_ground) return;
  ground_rise_ = footing.rise;
  was_on_cord_ = footing.is_cord;
}

void Player::run(int direction, double dt) {
  b2Vec2 velocity = body_->GetLinearVelocity();
  const double speed = static_cast<double>(velocity.x);
  const double target = direction * tuning_.run_speed;
  double max_change = (is_on_ground() ? tuning_.ground_acceleration : tuning_.air_acceleration) * dt;
  const bool would_lose_speed = direction == 0 || speed * direction > tuning_.run_speed;
  if (!is_on_ground() && would_lose_speed) max_change = 0.0;
  velocity.x = static_cast<float>(speed + std::clamp(target - speed, -max_change, max_change));
  body_->SetLinearVelocity(velocity);
}

void Player::jump_if_possible() {
  if (ticks_since_jump_pressed_ == 0 && ticks_since_release_ <= tuning_.hop_ticks && !is_on_ground()) return hop();
  ticks_since_jump_ = std::min(ticks_since_jump_ + 1, long_ago);
  if (ticks_since_jump_pressed_ > tuning_.jump_buffer_ticks || ticks_off_ground_ > tuning_.coyote_ticks) return;
  if (ticks_since_jump_ < tuning_.jump_pause_ticks) return;
  const b2Vec2 velocity = body_->GetLinearVelocity();
  // A cord that still throws the player up is used to the end.
  const bool is_thrown = was_on_cord_ && is_on_ground() &&
                         static_cast<double>(velocity.y) > std::max(tuning_.sinking_speed, speed_up_before_ + 0.05);
  if (is_thrown) {
    ticks_since_jump_pressed_ = 0;
    return;
  }
  // A jump off a bouncing surface adds a fraction of its speed.
  const double up =
      std::max(tuning_.jump_speed, static_cast<double>(velocity.y) + tuning_.bounce_fraction * tuning_.jump_speed);
  body_->SetLinearVelocity({velocity.x, static_cast<float>(up)});
  jump_can_be_cut_ = !was_on_cord_;
  ticks_since_jump_pressed_ = long_ago;
  ticks_since_jump_ = 0;
  ticks_off_ground_ = tuning_.coyote_ticks + 1;
}

/// A jump off the ground is as high as its key is held. What a cord gives stays.
void Player::cut_jump(bool key_is_down) {
  const b2Vec2 velocity = body_->GetLinearVelocity();
  if (velocity.y <= 0.0F) jump_can_be_cut_ = false;
  if (!jump_can_be_cut_ || key_is_down || is_on_ground()) return;
  jump_can_be_cut_ = false;
  body_->SetLinearVelocity({velocity.x, std::min(velocity.y, static_cast<float>(tuning_.cut_speed))});
}

/// Catches the nearest cord. Returns false if none is in range.
bool Player::catch_cord(ribbon::box2d::Coupling& coupling) {
  std::array<ribbon::box2d::CordId, Lines::most + 2> except{};
  std::size_t excepted = 0;
  if (tether_ && coupling.grip(*tether_).is_valid()) except[excepted++] = coupling.grip(*tether_).state().cord;
  for (const Line& line : lines_.all()) {
    if (line.is_held()) except[excepted++] = *line.cord();
  }
  if (left_cord_) except[excepted++] = *left_cord_;
  const auto nearest = coupling.nearest_place(hand(), tuning_.grab_range, std::span(except).first(excepted));
  if (!nearest) return false;
  lines_.release(coupling);
  const ribbon::box2d::CordRef cord = coupling.cord(nearest->cord);
  grip_ = cord.position(nearest->point, nearest->along) - position();
  can_climb_ = cord.solver() == ribbon::box2d::Solver::direct;
  if (!can_climb_) {
    grip_id_ = coupling.hold(nearest->cord, nearest->point, *body_, to_float(grip_));
    return true;
  }
  ribbon::box2d::GripDef grip;
  grip.cord = nearest->cord;
  grip.arc = cord.arc(nearest->point, nearest->along);
  grip.row = nearest->point % cord.shape().rows;
  grip.local_anchor = to_float(grip_);
  grip_id_ = coupling.hold(*body_, grip);
  return true;
}

/// Catches the edge of a ledge on the side to which the player moves, while it falls.
bool Player::catch_ledge() {
  if (is_on_ground() || direction_ == 0 || lines_.held() != nullptr) return false;
  if (body_->GetLinearVelocity().y > 0.0F) return false;
  ledge_ = find_ledge(*body_, hand(), direction_, tuning_);
  return ledge_.has_value();
}

void Player::leave_ledge() {
  if (!ledge_) return;
  ledge_.reset();
  may_catch_ = false;
}

/// Holds the body below the edge, unless something has pulled it away. A jump leaves it upwards.
void Player::hang_from_ledge(const Command& command, double dt) {
  const Vec2 way = ledge_->edge - Vec2{ledge_->side * tuning_.radius, tuning_.hand_height} - position();
  if (!command.grab || command.jump || length(way) > tuning_.max_arm_length) {
    leave_ledge();
    if (!command.jump) return;
    body_->SetLinearVelocity({0.0F, static_cast<float>(tuning_.jump_speed)});
    ticks_since_jump_pressed_ = long_ago;
    jump_can_be_cut_ = false;
    return;
  }
  const double speed = std::min(tuning_.ledge_speed, length(way) / dt);
  const Vec2 direction = length(way) > 0.0 ? (1.0 / length(way)) * way : Vec2{};
  // Box2D adds gravity before it moves the body.
  body_->SetLinearVelocity(to_float(speed * direction - dt * to_double(body_->GetWorld()->GetGravity())));
}

/// One tick of hanging: the held position moves towards the hand, up and down climb, and left and right push across the
/// cord, since the cord would take a push along it.
void Player::hang(const Command& command, ribbon::box2d::Coupling& coupling, double dt) {
  const Vec2 hand{0.0, tuning_.hand_height};
  grip_ += tuning_.pull_in * (hand - grip_);
  const ribbon::box2d::CordPoint held = *held_place(coupling);
  const Vec2 held_at = coupling.cord(held.cord).position(held.point, held.along);
  if (length(held_at - position() - grip_) > tuning_.max_arm_length) {
    return release_cord(coupling);  // pulled out of the hand
  }
  coupling.grip(*grip_id_).move_anchor(to_float(grip_));
  if (can_climb_) climb(command.climb, held, coupling);
  pump(anchor_of(coupling, held), dt);
}

/// Climbs (1), slides (−1) or stops (0). Up is towards the nearest constrained point, or, without one, towards the
/// higher end.
void Player::climb(int direction, const ribbon::box2d::CordPoint& held, ribbon::box2d::Coupling& coupling) {
  const ribbon::box2d::CordRef cord = coupling.cord(held.cord);
  const double here = cord.arc(held.point, held.along);
  if (direction == 0) return coupling.grip(*grip_id_).climb(here, tuning_.climb_speed);  // stops
  const ribbon::box2d::CordShape shape = cord.shape();
  const int pin = nearest_pin(cord, held.point);
  const bool up_is_first = hangs_from_first(cord, held.point);
  const double whole = cord.arc((shape.columns - 1) * shape.rows);
  const double top = pin < 0 ? (up_is_first ? 0.0 : whole) : cord.arc(pin);
  const double upper_end =
      up_is_first ? std::min(here, top + tuning_.top_margin) : std::max(here, top - tuning_.top_margin);
  const double lower_end = up_is_first ? whole : 0.0;
  climbs_ = true;
  coupling.grip(*grip_id_).climb(direction > 0 ? upper_end : lower_end,
                                 direction > 0 ? tuning_.climb_speed : tuning_.slide_speed);
}

/// Pushes the body perpendicular to the direction from it to `from`, for a moment after each press: a swing wants
/// rhythm.
void Player::pump(Vec2 from, double dt) {
  const Vec2 along = from - position();
  const double distance = length(along);
  if (direction_ == 0 || pump_ticks_left_ == 0 || distance == 0.0) return;
  const Vec2 across = (1.0 / distance) * Vec2{along.y, -along.x};  // to the right for a cord that hangs
  const double impulse = direction_ * tuning_.pump_acceleration * tuning_.mass * dt;
  body_->ApplyLinearImpulseToCenter(to_float(impulse * across), true);
}

void Player::release_cord(ribbon::box2d::Coupling& coupling) {
  if (const auto held = held_place(coupling)) leave(held->cord);
  if (grip_id_) coupling.grip(*grip_id_).release();
  grip_id_.reset();
  may_catch_ = false;
  ticks_since_jump_pressed_ = long_ago;
  ticks_since_release_ = 0;
}

/// Remembers a cord that the hand has let go of. It flies on beside the hand, which reaches for another one.
void Player::leave(ribbon::box2d::CordId cord) {
  left_cord_ = cord;
  ticks_since_left_ = 0;
}

void Player::forget_left_cord(const ribbon::box2d::Coupling& coupling) {
  if (!left_cord_) return;
  const bool is_there = coupling.cord(*left_cord_).is_valid();
  if (is_there && ++ticks_since_left_ <= tuning_.forget_ticks) {
    const auto points = coupling.cord(*left_cord_).positions();
    if (length(points[nearest_point(points, hand())] - hand()) < tuning_.forget_distance) return;
  }
  left_cord_.reset();
}

/// Jumps off a cord: adds hop_speed to the velocity of the swing.
void Player::hop() {
  const b2Vec2 velocity = body_->GetLinearVelocity();
  body_->SetLinearVelocity({velocity.x, velocity.y + static_cast<float>(tuning_.hop_speed)});
  ticks_since_jump_pressed_ = long_ago;
  ticks_since_release_ = long_ago;
}

void Player::add_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(ticks_off_ground_);
  hasher.add(ticks_since_jump_pressed_);
  hasher.add(ticks_since_release_);
  hasher.add(ticks_since_jump_);
  hasher.add(buttons_before_);
  hasher.add(static_cast<int>(may_catch_));
  hasher.add(left_cord_.value_or(-1));
  hasher.add(ticks_since_left_);
  hasher.add(ground_rise_);
  hasher.add(static_cast<int>(jump_can_be_cut_));
  hasher.add(static_cast<int>(was_on_cord_));
  hasher.add(speed_up_before_);
  hasher.add(static_cast<int>(faces_left_));
  hasher.add(direction_);
  hasher.add(pump_ticks_left_);
  hasher.add(can_climb_ ? grip_id_.value_or(-1) : -1);  // recordings have −1 for cords of the thesis's solver
  hasher.add(grip_);
  lines_.add_to(hasher);
  if (ledge_) hasher.add(ledge_->edge);
}

}  // namespace game
