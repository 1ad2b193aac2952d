#include "game/view/camera.h"

#include <algorithm>
#include <cmath>

namespace game {
namespace {

using ribbon::Vec2;

constexpr double slow_height = 12.0;    // m, the height of the view at rest
constexpr double fast_height = 14.5;    // m, at full speed
constexpr double full_speed = 12.0;     // m/s
constexpr double facing_ahead = 1.2;    // m, ahead in the direction that the player faces
constexpr double seconds_ahead = 0.32;  // s, ahead at the player's velocity
constexpr double max_ahead = 3.6;       // m
constexpr double above = 0.8;           // m, above the centre of the player
constexpr double follow = 0.10;         // fraction of the remaining distance per tick
constexpr double follow_height = 0.03;  // the same for the height of the view
constexpr double smoothing = 0.08;      // the same for the velocity
constexpr double hard_landing = 7.0;    // m/s
constexpr double shake_size = 0.012;    // m per m/s above hard_landing
constexpr double shake_decay = 0.86;    // per tick

Vec2 clamp_length(Vec2 v, double max_length) {
  const double l = length(v);
  return l > max_length ? (max_length / l) * v : v;
}

/// Clamps the centre of the view to the level; returns the middle of a level that is smaller than the view.
double clamp_center(double x, double half_view, double size) {
  return 2.0 * half_view >= size ? 0.5 * size : std::clamp(x, half_view, size - half_view);
}

}  // namespace

Camera::Place Camera::wanted(const CameraSubject& subject) {
  const Vec2 ahead = clamp_length(seconds_ahead * subject.velocity, max_ahead);
  const double side = subject.faces_left ? -facing_ahead : facing_ahead;
  const double speed = std::min(length(subject.velocity) / full_speed, 1.0);
  return {
      subject.at + Vec2{side + ahead.x, above + 0.8 * ahead.y}, slow_height + (fast_height - slow_height) * speed, {}};
}

void Camera::jump_to(const CameraSubject& subject) {
  ahead_velocity_ = subject.velocity;
  now_ = before_ = wanted(subject);
  shaking_ = 0.0;
}

void Camera::tick(const CameraSubject& subject) {
  before_ = now_;
  ahead_velocity_ += smoothing * (subject.velocity - ahead_velocity_);
  CameraSubject smoothed = subject;
  smoothed.velocity = ahead_velocity_;
  const Place goal = wanted(smoothed);
  // Exponential smoothing lags behind a constant velocity by 1 / follow − 1 ticks: aim ahead by as much.
  const Vec2 lag = (1.0 / 60.0) * (1.0 / follow - 1.0) * ahead_velocity_;
  now_.at += follow * (goal.at + lag - now_.at);
  now_.height += follow_height * (goal.height - now_.height);
  if (subject.lands && subject.impact > hard_landing) shaking_ += shake_size * (subject.impact - hard_landing);
  shaking_ = std::min(shake_decay * shaking_, 0.25);
  ++ticks_;
  now_.shake = shaking_ * Vec2{std::sin(2.1 * ticks_), std::cos(2.9 * ticks_)};
}

engine::View Camera::view(double alpha, int width, int height, bool reduced_motion) const {
  const auto between = [alpha](Vec2 a, Vec2 b) { return a + alpha * (b - a); };
  // A level that is lower or narrower than the view is enlarged, so that its outside is never visible.
  const double wanted_height =
      reduced_motion ? 0.5 * (slow_height + fast_height) : before_.height + alpha * (now_.height - before_.height);
  const double metres_high = std::min({wanted_height, level_.y, level_.x * height / width});
  const double scale = height / metres_high;
  Vec2 center = between(before_.at, now_.at);
  if (!reduced_motion) center += between(before_.shake, now_.shake);
  return {{clamp_center(center.x, 0.5 * width / scale, level_.x), clamp_center(center.y, 0.5 * metres_high, level_.y)},
          scale};
}

}  // namespace game
