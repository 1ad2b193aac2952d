#include "game/simulation/player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "game/simulation/buttons.h"
#include "game/simulation/player_body.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

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
    : tuning_(tuning), body_(make_player_body(world, feet, tuning)), lines_(line_tuning, lines) {}

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
  if (command.direction != 0) faces_left_ = command.direction < 0;
  pump_.follow(command.direction, tuning_);
  legs_.begin_tick(command.jump, *body_, coupling, tuning_);
  hold_.begin_tick(command.grab, hand(), coupling, tuning_);

  handle_lines(command, targets, coupling, dt);
  if (hold_.is_valid(coupling)) return stay_on_cord(command, coupling, dt);
  if (ledge_) return hang_from_ledge(command, dt);
  if (const Line* line = lines_.held(); line != nullptr && !is_on_ground()) {
    pump_.push(*body_, line->end(), tuning_, dt);
    if (command.jump) {
      hold_.leave(*line->cord());
      lines_.release(coupling);
      legs_.hop(*body_, tuning_);
    }
  } else {
    legs_.move(command.direction, command.holds_jump, *body_, tuning_, dt);
  }
  if (command.grab && hold_.may_catch() && !catch_cord(coupling)) catch_ledge();
}

void Player::put(Vec2 feet, ribbon::box2d::Coupling& coupling) {
  lines_.release(coupling);
  coupling.body(*body_).release();
  ledge_.reset();
  hold_.forget();
  body_->SetTransform(to_float(feet + Vec2{0.0, 0.5 * tuning_.height}), 0.0F);
  body_->SetLinearVelocity({0.0F, 0.0F});
}

std::optional<ribbon::box2d::CordPoint> Player::held_place(const ribbon::box2d::Coupling& coupling) const {
  if (!tether_) return coupling.body(*body_).held_place();
  if (hold_.is_valid(coupling)) return hold_.place(coupling);
  const Line* line = lines_.held();
  return line != nullptr ? line->held_place(coupling) : std::nullopt;
}

/// Throws, releases, flies, reels and knots the lines. When one arrives, the player lets go of a cord or a ledge.
void Player::handle_lines(const Command& command, const Targets& targets, ribbon::box2d::Coupling& coupling,
                          double dt) {
  lines_.use(command.lines, targets, hand(), coupling, dt);
  if (lines_.arrive()) {
    if (hold_.is_valid(coupling)) release_cord(coupling);
    leave_ledge();
  }
  lines_.move(command.lines, coupling, *body_, {0.0, tuning_.hand_height}, dt);
}

/// Hangs on the cord, or lets go of it.
void Player::stay_on_cord(const Command& command, ribbon::box2d::Coupling& coupling, double dt) {
  if (command.jump || !command.grab) {
    release_cord(coupling);
    if (command.jump) legs_.hop(*body_, tuning_);
    return;
  }
  const auto anchor = hold_.hang(*held_place(coupling), command.climb, *body_, coupling, tuning_);
  if (!anchor) return release_cord(coupling);  // pulled out of the hand
  pump_.push(*body_, *anchor, tuning_, dt);
}

/// Catches the nearest cord. Returns false if none is in range.
bool Player::catch_cord(ribbon::box2d::Coupling& coupling) {
  std::array<ribbon::box2d::CordId, Lines::most + 2> except{};
  std::size_t excepted = 0;
  if (tether_ && coupling.grip(*tether_).is_valid()) except[excepted++] = coupling.grip(*tether_).state().cord;
  for (const Line& line : lines_.all()) {
    if (line.is_held()) except[excepted++] = *line.cord();
  }
  if (hold_.left_cord()) except[excepted++] = *hold_.left_cord();
  const auto nearest = coupling.nearest_place(hand(), tuning_.grab_range, std::span(except).first(excepted));
  if (!nearest) return false;
  lines_.release(coupling);
  hold_.take(*nearest, *body_, coupling);
  return true;
}

/// Catches the edge of a ledge on the side to which the player moves, while it falls.
bool Player::catch_ledge() {
  if (is_on_ground() || pump_.direction() == 0 || lines_.held() != nullptr) return false;
  if (body_->GetLinearVelocity().y > 0.0F) return false;
  ledge_ = find_ledge(*body_, hand(), pump_.direction(), tuning_);
  return ledge_.has_value();
}

void Player::leave_ledge() {
  if (!ledge_) return;
  ledge_.reset();
  hold_.wait_for_button();
}

/// Holds the body below the edge, unless something has pulled it away. A jump leaves it upwards.
void Player::hang_from_ledge(const Command& command, double dt) {
  const Vec2 way = ledge_->edge - Vec2{ledge_->side * tuning_.radius, tuning_.hand_height} - position();
  if (!command.grab || command.jump || length(way) > tuning_.max_arm_length) {
    leave_ledge();
    if (command.jump) legs_.jump_off_ledge(*body_, tuning_);
    return;
  }
  const double speed = std::min(tuning_.ledge_speed, length(way) / dt);
  const Vec2 direction = length(way) > 0.0 ? (1.0 / length(way)) * way : Vec2{};
  // Box2D adds gravity before it moves the body.
  body_->SetLinearVelocity(to_float(speed * direction - dt * to_double(body_->GetWorld()->GetGravity())));
}

void Player::release_cord(ribbon::box2d::Coupling& coupling) {
  hold_.release(held_place(coupling), coupling);
  legs_.leave_cord();
}

void Player::add_to(ribbon::box2d::Hasher& hasher) const {
  legs_.add_times_to(hasher);
  hasher.add(buttons_before_);
  hold_.add_release_to(hasher);
  legs_.add_ground_to(hasher);
  hasher.add(static_cast<int>(faces_left_));
  pump_.add_to(hasher);
  hold_.add_grip_to(hasher);
  lines_.add_to(hasher);
  if (ledge_) hasher.add(ledge_->edge);
}

}  // namespace game
