#include "game/view/camera.h"

#include <algorithm>
#include <cmath>

namespace game {
namespace {

using ribbon::Vec2;

constexpr double slow_height = 12.0;    // m of the level that the picture shows from top to bottom
constexpr double fast_height = 14.5;    // at full speed
constexpr double full_speed = 12.0;     // m/s
constexpr double facing_ahead = 1.2;    // m, in front of who stands
constexpr double seconds_ahead = 0.32;  // of the way he goes
constexpr double most_ahead = 3.6;      // m
constexpr double above = 0.8;           // m, over his middle
constexpr double follow = 0.10;         // of what is left, a tick
constexpr double follow_height = 0.03;  // likewise of the zoom
constexpr double smoothing = 0.08;      // of the velocity that it looks along
constexpr double hard_landing = 7.0;    // m/s
constexpr double shake_size = 0.012;    // m for a m/s above that
constexpr double shake_decay = 0.86;    // a tick

Vec2 no_longer(Vec2 v, double most) {
  const double l = length(v);
  return l > most ? (most / l) * v : v;
}

/// Within the level; in its middle if it is smaller than the picture.
double kept_within(double x, double half_view, double size) {
  return 2.0 * half_view >= size ? 0.5 * size : std::clamp(x, half_view, size - half_view);
}

}  // namespace

Camera::Place Camera::wanted(const CameraSubject& subject) {
  const Vec2 ahead = no_longer(seconds_ahead * subject.velocity, most_ahead);
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
  // What follows by a share of the distance lags behind by the way of 1 / share ticks: it aims that far ahead.
  const Vec2 lag = (1.0 / 60.0) * (1.0 / follow - 1.0) * ahead_velocity_;
  now_.at += follow * (goal.at + lag - now_.at);
  now_.metres_high += follow_height * (goal.metres_high - now_.metres_high);
  if (subject.lands && subject.impact > hard_landing) shaking_ += shake_size * (subject.impact - hard_landing);
  shaking_ = std::min(shake_decay * shaking_, 0.25);
  ++ticks_;
  now_.shake = shaking_ * Vec2{std::sin(2.1 * ticks_), std::cos(2.9 * ticks_)};
}

engine::View Camera::view(double alpha, int width, int height, bool calm) const {
  const auto between = [alpha](Vec2 a, Vec2 b) { return a + alpha * (b - a); };
  // A level lower or narrower than the picture is shown larger rather than with its outside.
  const double wanted_height =
      calm ? 0.5 * (slow_height + fast_height) : before_.metres_high + alpha * (now_.metres_high - before_.metres_high);
  const double metres_high = std::min({wanted_height, level_.y, level_.x * height / width});
  const double scale = height / metres_high;
  Vec2 center = between(before_.at, now_.at);
  if (!calm) center += between(before_.shake, now_.shake);
  return {{kept_within(center.x, 0.5 * width / scale, level_.x), kept_within(center.y, 0.5 * metres_high, level_.y)},
          scale};
}

}  // namespace game
