#include "game/simulation/line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/simulation/player.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr double rope_friction = 0.5;
constexpr double air_drag = 0.3;  // 1/s

/// `is_pinned`: to a place that does not move.
ribbon::CordDef line_def(const LineTuning& tuning, double length, bool is_pinned) {
  ribbon::CordDef def;
  def.points = tuning.points;
  def.length = length;
  def.radius = tuning.radius;
  def.mass_per_length = tuning.mass_per_length;
  def.stretch_stiffness = tuning.stretch_stiffness;
  def.damping = tuning.damping;
  def.drag = air_drag;
  def.tension_only = true;
  def.friction = rope_friction;
  def.accuracy = tuning.accuracy;
  if (is_pinned) def.pins = {0};
  return def;
}

/// A place and its velocity.
struct End {
  Vec2 at;        // m
  Vec2 velocity;  // m/s
};

/// Returns a straight line between two ends. Its velocities change linearly from one to the other.
ribbon::Cord straight_cord(const LineTuning& tuning, const End& far, const End& hand, double length, bool is_pinned) {
  ribbon::CordDef def = line_def(tuning, length, is_pinned);
  const double last = tuning.points - 1.0;
  for (int p = 0; p < tuning.points; ++p) def.positions.push_back(far.at + (p / last) * (hand.at - far.at));
  ribbon::Cord cord(def);
  for (int p = is_pinned ? 1 : 0; p < tuning.points; ++p)
    cord.set_velocity(p, far.velocity + (p / last) * (hand.velocity - far.velocity));
  return cord;
}

/// Returns the same line with links that resist compression, for a line that was released. It recoils at 100 m/s, and
/// without resistance to compression and bending the solution for its folds is not unique.
ribbon::Cord released_cord(const LineTuning& tuning, double length, const ribbon::Cord& held, bool is_pinned) {
  ribbon::CordDef def = line_def(tuning, length, is_pinned);
  def.tension_only = false;
  def.positions.assign(held.positions().begin(), held.positions().end());
  ribbon::Cord released(def);
  for (int p = is_pinned ? 1 : 0; p < tuning.points; ++p)
    released.set_velocity(p, held.velocities()[static_cast<std::size_t>(p)]);
  return released;
}

b2Filter line_filter() {
  b2Filter filter;
  filter.maskBits = static_cast<std::uint16_t>(~player_category);
  return filter;
}

}  // namespace

Vec2 Line::tip(Vec2 hand) const {
  if (flight_ticks_ == 0) return end();
  return hand + (1.0 - static_cast<double>(ticks_left_) / flight_ticks_) * (end() - hand);
}

void Line::throw_at(const Target& target, Vec2 hand, double dt) {
  state_ = State::flying;
  target_ = target;
  flight_ticks_ = std::max(1, static_cast<int>(std::ceil(ribbon::length(end() - hand) / (tuning_.flight_speed * dt))));
  ticks_left_ = flight_ticks_;
}

bool Line::fly(ribbon::box2d::Coupling& coupling, b2Body& body, Vec2 hand) {
  is_new_ = false;
  if (state_ != State::flying || --ticks_left_ > 0) return false;
  const Vec2 at_hand = to_double(body.GetPosition()) + hand;
  const double distance = ribbon::length(end() - at_hand);
  if (distance > tuning_.max_length) {  // the player moved too far during the flight
    state_ = cord_ ? State::released : State::stowed;
    return false;
  }
  length_ = std::max(distance, tuning_.min_length);
  const Vec2 drift =
      target_.body == nullptr ? Vec2{} : to_double(target_.body->GetLinearVelocityFromLocalPoint(target_.local));
  put_cord(straight_cord(tuning_, {end(), drift}, {at_hand, coupling.body(body).velocity()}, length_,
                         target_.body == nullptr),
           coupling);
  ribbon::box2d::GripDef grip;
  grip.cord = *cord_;
  grip.arc = length_;
  grip.local_anchor = to_float(hand);
  grip_ = coupling.hold(body, grip);
  state_ = State::held;
  is_new_ = true;
  return true;
}

std::optional<ribbon::box2d::CordPoint> Line::held_place(const ribbon::box2d::Coupling& coupling) const {
  if (state_ != State::held || !grip_ || !coupling.grip(*grip_).is_valid()) return std::nullopt;
  const ribbon::box2d::GripState held = coupling.grip(*grip_).state();
  return ribbon::box2d::CordPoint{held.cord, held.point, 0.0, held.along};
}

void Line::reel(int direction, ribbon::box2d::Coupling& coupling, double dt) {
  if (state_ != State::held || direction == 0) return;
  const double speed = direction < 0 ? tuning_.reel_in_speed : tuning_.reel_out_speed;
  length_ = std::clamp(length_ + direction * speed * dt, tuning_.min_length, tuning_.max_length);
  coupling.cord(*cord_).direct().reel(0, tuning_.points - 1, length_, speed);
}

bool Line::release(ribbon::box2d::Coupling& coupling) {
  if (state_ != State::held && state_ != State::flying) return false;
  if (grip_) coupling.grip(*grip_).release();
  set_released(coupling);
  return true;
}

void Line::follow(ribbon::box2d::Coupling& coupling) {
  if (state_ == State::held && !coupling.grip(*grip_).is_valid()) set_released(coupling);
}

ribbon::box2d::CordId Line::leave(ribbon::box2d::Coupling& coupling) {
  const ribbon::box2d::CordId left = *cord_;
  release(coupling);
  cord_.reset();
  state_ = State::stowed;
  return left;
}

ribbon::box2d::CordId Line::hand_over(ribbon::box2d::Coupling& coupling) {
  const ribbon::box2d::CordId left = *cord_;
  if (grip_) coupling.grip(*grip_).release();
  grip_.reset();
  cord_.reset();
  is_new_ = false;
  if (state_ != State::flying) state_ = State::stowed;
  return left;
}

/// Makes this the cord of the line. A body that moves holds its far end.
void Line::put_cord(ribbon::Cord cord, ribbon::box2d::Coupling& coupling) {
  if (cord_) {
    coupling.cord(*cord_).replace(std::move(cord), line_filter());
  } else {
    cord_ = coupling.add(std::move(cord), line_filter());
  }
  if (target_.body == nullptr) return;
  ribbon::box2d::GripDef grip;
  grip.cord = *cord_;
  grip.local_anchor = target_.local;
  coupling.hold(*target_.body, grip);
}

void Line::set_released(ribbon::box2d::Coupling& coupling) {
  if (grip_) {
    put_cord(released_cord(tuning_, length_, coupling.cord(*cord_).direct(), target_.body == nullptr), coupling);
  }
  grip_.reset();
  state_ = cord_ ? State::released : State::stowed;
}

void Line::add_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(static_cast<int>(state_));
  hasher.add(target_.at);
  if (target_.body != nullptr) hasher.add(end());
  hasher.add(flight_ticks_);
  hasher.add(ticks_left_);
  hasher.add(length_);
  hasher.add(cord_.value_or(-1));
  hasher.add(grip_.value_or(-1));
}

}  // namespace game
