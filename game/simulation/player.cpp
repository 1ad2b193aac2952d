#include "game/simulation/player.h"

#include <algorithm>
#include <cstdlib>

#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr int long_ago = 1'000'000;  // ticks
constexpr double firm_slope = 0.95;  // least upward part of the normal of what one does not slide off

b2Body* make_body(b2World& world, Vec2 feet, const PlayerTuning& tuning) {
  const auto radius = static_cast<float>(tuning.radius);
  const auto straight =
      static_cast<float>(0.5 * tuning.height - tuning.radius);  // half of the part between the circles

  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.fixedRotation = true;
  definition.allowSleep = false;
  definition.position = to_float(feet + Vec2{0.0, 0.5 * tuning.height});
  b2Body* body = world.CreateBody(&definition);

  b2FixtureDef fixture;
  fixture.friction = 0.0F;  // running is the player's own affair; walls must not hold him up
  fixture.filter.categoryBits = player_category;
  b2CircleShape circle;
  circle.m_radius = radius;
  b2PolygonShape box;
  box.SetAsBox(radius, straight);
  fixture.shape = &box;
  body->CreateFixture(&fixture);
  fixture.shape = &circle;
  for (const float y : {-straight, straight}) {
    circle.m_p = {0.0F, y};
    body->CreateFixture(&fixture);
  }
  b2MassData mass;
  mass.mass = static_cast<float>(tuning.mass);
  mass.center.SetZero();
  mass.I = 0.0F;
  body->SetMassData(&mass);
  return body;
}

/// The constrained point nearest to a place along its cord, or −1.
int nearest_pin(const ribbon::box2d::Coupling& coupling, const ribbon::box2d::CordPoint& held) {
  int pin = -1;
  for (int p = 0; p < static_cast<int>(coupling.cord(held.cord).positions().size()); ++p) {
    if (coupling.cord(held.cord).kind(p) != ribbon::PointKind::constrained) continue;
    if (pin < 0 || std::abs(p - held.point) < std::abs(pin - held.point)) pin = p;
  }
  return pin;
}

/// What the held place hangs from: the nearest constrained point, else the cord's first.
Vec2 anchor_of(const ribbon::box2d::Coupling& coupling, const ribbon::box2d::CordPoint& held) {
  return coupling.cord(held.cord).positions()[static_cast<std::size_t>(std::max(nearest_pin(coupling, held), 0))];
}

}  // namespace

/// What the buttons of a tick ask for.
struct Player::Wish {
  Wish(std::uint16_t buttons, std::uint16_t before)
      : direction(axis(buttons, button_right, button_left)),
        climb(axis(buttons, button_up, button_down)),
        reel(axis(buttons, button_reel_out, button_reel_in)),
        grab((buttons & button_grab) != 0),
        jump((buttons & ~before & button_jump) != 0),
        throws((buttons & ~before & button_throw) != 0) {}

  static int axis(std::uint16_t buttons, Button plus, Button minus) {
    return ((buttons & plus) != 0 ? 1 : 0) - ((buttons & minus) != 0 ? 1 : 0);
  }

  int direction;
  int climb;
  int reel;
  bool grab;
  bool jump;    // pressed in this tick
  bool throws;  // pressed in this tick
};

Player::Player(b2World& world, Vec2 feet, const PlayerTuning& tuning, const LineTuning& line_tuning)
    : tuning_(tuning),
      body_(make_body(world, feet, tuning)),
      line_(line_tuning),
      ticks_since_jump_wanted_(long_ago),
      ticks_since_let_go_(long_ago),
      ticks_since_jump_(long_ago) {}

Vec2 Player::position() const { return to_double(body_->GetPosition()); }

Vec2 Player::hand() const { return position() + Vec2{0.0, tuning_.hand_height}; }

void Player::apply(std::uint16_t buttons, std::optional<Vec2> aim, ribbon::box2d::Coupling& coupling, double dt) {
  const Wish wish(buttons, buttons_before_);
  buttons_before_ = buttons;
  if (!wish.grab) wants_to_catch_ = true;
  if (wish.direction != 0) faces_left_ = wish.direction < 0;
  feel_feet(coupling);
  ticks_since_jump_wanted_ = wish.jump ? 0 : std::min(ticks_since_jump_wanted_ + 1, long_ago);
  ticks_since_let_go_ = std::min(ticks_since_let_go_ + 1, long_ago);
  climbs_ = false;

  handle_line(wish, aim, coupling, dt);
  if (holds_cord(coupling)) {
    if (wish.jump || !wish.grab) {
      let_go(coupling);
      if (wish.jump) hop();
    } else {
      hang(wish, coupling, dt);
    }
    return;
  }
  if (line_.state() == Line::State::held && !is_on_ground()) {
    pump(wish.direction, line_.hook(), dt);
    if (wish.jump && line_.let_go(coupling)) hop();
  } else {
    run(wish.direction, dt);
    jump_if_wanted();
  }
  if (wish.grab && wants_to_catch_) catch_cord(coupling);
}

void Player::put(Vec2 feet, ribbon::box2d::Coupling& coupling) {
  line_.let_go(coupling);
  coupling.release(*body_);
  grip_id_.reset();
  wants_to_catch_ = false;
  body_->SetTransform(to_float(feet + Vec2{0.0, 0.5 * tuning_.height}), 0.0F);
  body_->SetLinearVelocity({0.0F, 0.0F});
}

/// Not counting the line, which has a grip of its own.
bool Player::holds_cord(const ribbon::box2d::Coupling& coupling) const {
  return grip_id_ && coupling.grip(*grip_id_).is_valid();
}

void Player::feel_feet(const ribbon::box2d::Coupling& coupling) {
  if (!feels_ground_) feel_ground(coupling);
  ticks_off_ground_ = *feels_ground_ ? 0 : std::min(ticks_off_ground_ + 1, long_ago);
  feels_ground_.reset();
}

/// Throws the line or lets it go, has it fly on, and reels. Who takes it in hand has no hand for another cord.
void Player::handle_line(const Wish& wish, std::optional<Vec2> aim, ribbon::box2d::Coupling& coupling, double dt) {
  line_.follow(coupling);
  if (wish.throws && !line_.let_go(coupling) && aim) line_.throw_at(*aim, hand(), dt);
  if (line_.arrives() && holds_cord(coupling)) let_go(coupling);
  line_.fly(coupling, *body_, {0.0, tuning_.hand_height});
  line_.reel(wish.reel, coupling, dt);
}

void Player::feel_ground(const ribbon::box2d::Coupling& coupling) {
  bool on_ground = false;
  on_firm_ground_ = false;
  for (const b2ContactEdge* edge = body_->GetContactList(); edge != nullptr; edge = edge->next) {
    if (!edge->contact->IsTouching() || edge->contact->GetFixtureA()->IsSensor() ||
        edge->contact->GetFixtureB()->IsSensor()) {
      continue;
    }
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    const bool is_b = edge->contact->GetFixtureB()->GetBody() == body_;
    const double up = static_cast<double>(is_b ? manifold.normal.y : -manifold.normal.y);
    on_ground = on_ground || up > tuning_.ground_slope;
    const b2Body* other = (is_b ? edge->contact->GetFixtureA() : edge->contact->GetFixtureB())->GetBody();
    on_firm_ground_ = on_firm_ground_ || (up > firm_slope && other->GetType() == b2_staticBody);
  }
  feels_ground_ = on_ground || stands_on_cord(coupling);
}

/// A solid cord below the feet carries, once it has stopped the fall: a jump before that would waste what it stores.
bool Player::stands_on_cord(const ribbon::box2d::Coupling& coupling) const {
  if (coupling.velocity(*body_).y < tuning_.sinking_speed) return false;
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    for (const ribbon::box2d::FixtureTouch& touch : coupling.cord(c).touching()) {
      const b2Fixture* fixture = coupling.fixture(touch.fixture);
      if (fixture == nullptr || fixture->GetBody() != body_ || touch.impulse <= 0.0) continue;
      if (touch.point.y < position().y - 0.5 * tuning_.height + tuning_.radius) return true;
    }
  }
  return false;
}

void Player::run(int direction, double dt) {
  b2Vec2 velocity = body_->GetLinearVelocity();
  const double speed = static_cast<double>(velocity.x);
  const double target = direction * tuning_.run_speed;
  double most = (is_on_ground() ? tuning_.ground_gain : tuning_.air_gain) * dt;
  const bool would_lose_speed = direction == 0 || speed * direction > tuning_.run_speed;
  if (!is_on_ground() && would_lose_speed) most = 0.0;
  velocity.x = static_cast<float>(speed + std::clamp(target - speed, -most, most));
  body_->SetLinearVelocity(velocity);
}

void Player::jump_if_wanted() {
  if (ticks_since_jump_wanted_ == 0 && ticks_since_let_go_ <= tuning_.hop_ticks && !is_on_ground()) return hop();
  ticks_since_jump_ = std::min(ticks_since_jump_ + 1, long_ago);
  if (ticks_since_jump_wanted_ > tuning_.jump_buffer_ticks || ticks_off_ground_ > tuning_.coyote_ticks) return;
  if (ticks_since_jump_ < tuning_.jump_pause_ticks) return;
  const b2Vec2 velocity = body_->GetLinearVelocity();
  // Off what throws one up already, a jump adds its share.
  const double up =
      std::max(tuning_.jump_speed, static_cast<double>(velocity.y) + tuning_.spring_share * tuning_.jump_speed);
  body_->SetLinearVelocity({velocity.x, static_cast<float>(up)});
  ticks_since_jump_wanted_ = long_ago;
  ticks_since_jump_ = 0;
  ticks_off_ground_ = tuning_.coyote_ticks + 1;
}

void Player::catch_cord(ribbon::box2d::Coupling& coupling) {
  const bool on_line = line_.state() == Line::State::held;
  const auto nearest = coupling.nearest_place(hand(), tuning_.reach, on_line ? line_.cord() : std::nullopt);
  if (!nearest) return;
  line_.let_go(coupling);
  grip_ = coupling.position(*nearest) - position();
  can_climb_ = coupling.cord(nearest->cord).solver() == ribbon::box2d::Solver::direct;
  if (!can_climb_) {
    grip_id_ = coupling.hold(nearest->cord, nearest->point, *body_, to_float(grip_));
    return;
  }
  ribbon::box2d::GripDef grip;
  grip.cord = nearest->cord;
  grip.arc = coupling.arc(*nearest);
  grip.row = nearest->point % coupling.cord(nearest->cord).shape().rows;
  grip.local_anchor = to_float(grip_);
  grip_id_ = coupling.hold(*body_, grip);
}

/// Hanging: the held place comes to the hand little by little; up and down climb, and left and right push across the
/// cord, the only direction in which a push is not lost to it.
void Player::hang(const Wish& wish, ribbon::box2d::Coupling& coupling, double dt) {
  const Vec2 hand{0.0, tuning_.hand_height};
  grip_ += tuning_.pull_in * (hand - grip_);
  const ribbon::box2d::CordPoint held = *coupling.held_by(*body_);
  if (length(coupling.position(held) - position() - grip_) > tuning_.longest_arm) {
    return let_go(coupling);  // torn out of the hand
  }
  coupling.grip(*grip_id_).move_anchor(to_float(grip_));
  if (can_climb_) climb(wish.climb, held, coupling);
  pump(wish.direction, anchor_of(coupling, held), dt);
}

/// Up is towards the nearest constrained point, where the cord has one, and else where it is higher.
void Player::climb(int direction, const ribbon::box2d::CordPoint& held, ribbon::box2d::Coupling& coupling) {
  const double here = coupling.arc(held);
  if (direction == 0) return coupling.grip(*grip_id_).climb(here, tuning_.climb_speed);  // stops
  const ribbon::box2d::CordShape shape = coupling.cord(held.cord).shape();
  const auto x = coupling.cord(held.cord).positions();
  const int pin = nearest_pin(coupling, held);
  const bool up_is_first = pin >= 0 ? pin <= held.point : x.front().y >= x.back().y;
  const double whole = coupling.arc({held.cord, (shape.columns - 1) * shape.rows});
  const double top = pin < 0 ? (up_is_first ? 0.0 : whole) : coupling.arc({held.cord, pin});
  const double highest =
      up_is_first ? std::min(here, top + tuning_.top_margin) : std::max(here, top - tuning_.top_margin);
  const double lowest = up_is_first ? whole : 0.0;
  climbs_ = true;
  coupling.grip(*grip_id_).climb(direction > 0 ? highest : lowest,
                                 direction > 0 ? tuning_.climb_speed : tuning_.slide_speed);
}

/// Pushes across what leads from the body to `from`.
void Player::pump(int direction, Vec2 from, double dt) {
  const Vec2 along = from - position();
  const double distance = length(along);
  if (direction == 0 || distance == 0.0) return;
  const Vec2 across = (1.0 / distance) * Vec2{along.y, -along.x};  // to the right for a cord that hangs
  const double impulse = direction * tuning_.pump_gain * tuning_.mass * dt;
  body_->ApplyLinearImpulseToCenter(to_float(impulse * across), true);
}

void Player::let_go(ribbon::box2d::Coupling& coupling) {
  coupling.release(*body_);
  grip_id_.reset();
  wants_to_catch_ = false;
  ticks_since_jump_wanted_ = long_ago;
  ticks_since_let_go_ = 0;
}

/// Off the cord: what the swing gave is kept, and a little is added.
void Player::hop() {
  const b2Vec2 velocity = body_->GetLinearVelocity();
  body_->SetLinearVelocity({velocity.x, velocity.y + static_cast<float>(tuning_.hop_speed)});
  ticks_since_jump_wanted_ = long_ago;
  ticks_since_let_go_ = long_ago;
}

void Player::add_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(ticks_off_ground_);
  hasher.add(ticks_since_jump_wanted_);
  hasher.add(ticks_since_let_go_);
  hasher.add(ticks_since_jump_);
  hasher.add(buttons_before_);
  hasher.add(static_cast<int>(wants_to_catch_));
  hasher.add(static_cast<int>(faces_left_));
  hasher.add(can_climb_ ? grip_id_.value_or(-1) : -1);  // recordings have −1 for cords of the thesis's solver
  hasher.add(grip_);
  line_.add_to(hasher);
}

}  // namespace game
