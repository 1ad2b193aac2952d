#include "game/player.h"

#include <algorithm>
#include <cstdlib>

#include "engine/convert.h"
#include "game/buttons.h"

namespace game {
namespace {

using engine::to_double;
using engine::to_float;
using ribbon::Vec2;

constexpr int long_ago = 1'000'000;  // ticks

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

/// What the held point hangs from: the constrained point nearest to it along the cord, else the cord's first.
Vec2 anchor_of(const engine::Coupling& coupling, const engine::CordPoint& held) {
  const auto positions = coupling.positions(held.cord);
  int anchor = -1;
  for (int p = 0; p < static_cast<int>(positions.size()); ++p) {
    if (coupling.kind(held.cord, p) != ribbon::PointKind::constrained) continue;
    if (anchor < 0 || std::abs(p - held.point) < std::abs(anchor - held.point)) anchor = p;
  }
  return positions[static_cast<std::size_t>(std::max(anchor, 0))];
}

}  // namespace

Player::Player(b2World& world, Vec2 feet, const PlayerTuning& tuning)
    : tuning_(tuning), body_(make_body(world, feet, tuning)), ticks_since_jump_wanted_(long_ago) {}

Vec2 Player::position() const { return to_double(body_->GetPosition()); }

Vec2 Player::hand() const { return position() + Vec2{0.0, tuning_.hand_height}; }

void Player::apply(std::uint16_t buttons, engine::Coupling& coupling, double dt) {
  const int direction = ((buttons & button_right) != 0 ? 1 : 0) - ((buttons & button_left) != 0 ? 1 : 0);
  const bool jump_down = (buttons & button_jump) != 0;
  const bool jump_pressed = jump_down && !jump_was_down_;
  const bool grab_down = (buttons & button_grab) != 0;
  jump_was_down_ = jump_down;
  if (!grab_down) wants_to_catch_ = true;
  if (direction != 0) faces_left_ = direction < 0;

  if (!feels_ground_) feel_ground();
  ticks_off_ground_ = *feels_ground_ ? 0 : std::min(ticks_off_ground_ + 1, long_ago);
  feels_ground_.reset();
  ticks_since_jump_wanted_ = jump_pressed ? 0 : std::min(ticks_since_jump_wanted_ + 1, long_ago);
  const auto held = coupling.held_by(*body_);
  if (held && (jump_pressed || !grab_down)) {
    let_go(coupling);
  } else if (held) {
    hang(direction, coupling, *held, dt);
  } else {
    run(direction, dt);
    jump_if_wanted();
    if (grab_down && wants_to_catch_) catch_cord(coupling);
  }
}

void Player::feel_ground() {
  bool on_ground = false;
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
  }
  feels_ground_ = on_ground;
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
  if (ticks_since_jump_wanted_ > tuning_.jump_buffer_ticks || ticks_off_ground_ > tuning_.coyote_ticks) return;
  body_->SetLinearVelocity({body_->GetLinearVelocity().x, static_cast<float>(tuning_.jump_speed)});
  ticks_since_jump_wanted_ = long_ago;
  ticks_off_ground_ = tuning_.coyote_ticks + 1;
}

void Player::catch_cord(engine::Coupling& coupling) {
  const auto nearest = coupling.nearest_point(hand(), tuning_.reach);
  if (!nearest) return;
  grip_ = coupling.positions(nearest->cord)[static_cast<std::size_t>(nearest->point)] - position();
  coupling.hold(nearest->cord, nearest->point, *body_, to_float(grip_));
}

/// Hanging: the cord point comes to the hand little by little, and left and right push across the cord, the only
/// direction in which a push is not lost to it.
void Player::hang(int direction, engine::Coupling& coupling, const engine::CordPoint& held, double dt) {
  const Vec2 hand{0.0, tuning_.hand_height};
  grip_ += tuning_.pull_in * (hand - grip_);
  const auto point = coupling.positions(held.cord)[static_cast<std::size_t>(held.point)];
  if (length(point - position() - grip_) > tuning_.longest_arm) return let_go(coupling);  // torn out of the hand
  coupling.hold(held.cord, held.point, *body_, to_float(grip_));

  const Vec2 along = anchor_of(coupling, held) - position();
  const double distance = length(along);
  if (direction == 0 || distance == 0.0) return;
  const Vec2 across = (1.0 / distance) * Vec2{along.y, -along.x};  // to the right for a cord that hangs
  const double impulse = direction * tuning_.pump_gain * tuning_.mass * dt;
  body_->ApplyLinearImpulseToCenter(to_float(impulse * across), true);
}

void Player::let_go(engine::Coupling& coupling) {
  coupling.release(*body_);
  wants_to_catch_ = false;
  ticks_since_jump_wanted_ = long_ago;
}

void Player::add_to(engine::Hasher& hasher) const {
  hasher.add(ticks_off_ground_);
  hasher.add(ticks_since_jump_wanted_);
  hasher.add(static_cast<int>(jump_was_down_));
  hasher.add(static_cast<int>(wants_to_catch_));
  hasher.add(static_cast<int>(faces_left_));
  hasher.add(grip_);
}

}  // namespace game
