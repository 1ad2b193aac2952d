#include "game/view/camera.h"

#include <algorithm>
#include <cmath>

#include "engine/math/smoothstep.h"
#include "game/simulation/tick_rate.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double slow_height = 12.0;      // m, the height of the view at rest
constexpr double fast_height = 14.5;      // m, at full speed
constexpr double full_speed = 12.0;       // m/s
constexpr double facing_ahead = 1.2;      // m, ahead in the direction that the player faces
constexpr double seconds_ahead = 0.32;    // s, ahead at the player's velocity
constexpr double max_ahead = 3.6;         // m
constexpr double subject_height = 0.8;    // m, above the centre of the player
constexpr double stiffness = 6.0;         // rad/s, of the spring
constexpr double zooming = 0.03;          // fraction of the remaining height of the view per tick
constexpr double smoothing = 0.08;        // the same for the velocity and the direction that the player faces
constexpr double rise_zone = 2.3;         // m, by which a player in the air rises without moving the camera: a jump
constexpr double fall_zone = 0.4;         // m, by which it falls
constexpr double catch_up = 0.12;         // fraction per tick of the remaining distance after a jump
constexpr double soles = 0.75;            // m, below the centre of the player
constexpr double below_ground = 0.8;      // m, of ground in the picture during a jump
constexpr double min_above_player = 1.4;  // m, from its centre to the edge of the picture
constexpr double up_ahead = 0.15;         // s, ahead of a player that rises, for the same
constexpr double jump_height = 16.0;      // m, max. height of the view to show the ground
constexpr double edge_zone = 2.5;         // m
constexpr double around_target = 0.65;    // m, from the middle of a target to the edge of the picture
constexpr double most_rise = 2.0;         // m, by which the camera rises for a target; from twice that on it does not
constexpr double beside_players = 4.0;    // m, from the outer one of two players to the edge of the picture
constexpr double over_players = 3.0;      // m, the same up and down
constexpr double most_for_two = 26.0;     // m, max. height of the view to show both
constexpr double usual_aspect = 16.0 / 9.0;
constexpr double steady_height = 0.5 * (slow_height + fast_height);  // m, with reduced motion
constexpr double max_acceleration = 45.0;                            // m/s²
constexpr double hard_landing = 7.0;                                 // m/s
constexpr double shake_size = 0.012;                                 // m per m/s above hard_landing
constexpr double shake_decay = 0.86;                                 // per tick

Vec2 clamp_length(Vec2 v, double max_length) {
  const double l = length(v);
  return l > max_length ? (max_length / l) * v : v;
}

/// Returns the height that has to be in the picture during a jump, m.
double highest_shown(const CameraSubject& subject) {
  return subject.at.y + min_above_player + up_ahead * std::max(0.0, subject.velocity.y);
}

/// Returns the height of the view that shows both players, m; 0 for one.
double height_for_two(const CameraSubject& subject) {
  if (!subject.spread) return 0.0;
  const double across = 2.0 * (subject.spread->x + beside_players) / usual_aspect;
  return std::min(std::max(across, 2.0 * (subject.spread->y + over_players)), most_for_two);
}

/// Clamps the centre of the view to the level; returns the middle of a level that is smaller than the view.
double clamp_center(double x, double half_view, double size) {
  return 2.0 * half_view >= size ? 0.5 * size : std::clamp(x, half_view, size - half_view);
}

/// Does so smoothly: the centre approaches the limit exponentially from edge_zone before it.
double ease_center(double x, double half_view, double size) {
  const double room = 0.5 * size - half_view;  // to either side of the middle
  if (room <= 0.0) return 0.5 * size;
  const double zone = std::min(edge_zone, room);
  const double beyond = std::abs(x - 0.5 * size) - (room - zone);
  if (beyond <= 0.0) return x;
  return 0.5 * size + std::copysign(room - zone * std::exp(-beyond / zone), x - 0.5 * size);
}

}  // namespace

/// Updates the height to follow and the ground below. Returns the vertical velocity of that height, m/s, without what
/// it catches up.
double Camera::follow_height(const CameraSubject& subject) {
  if (subject.hangs) ground_.reset();
  if (subject.on_ground) ground_ = subject.at.y - soles;
  if (subject.on_ground || subject.hangs) {
    level_height_ += tick_dt * subject.velocity.y;
    level_height_ += catch_up * (subject.at.y - level_height_);
    return subject.velocity.y;
  }
  const double before = level_height_;
  level_height_ = std::clamp(before, subject.at.y - rise_zone, subject.at.y + fall_zone);
  return (level_height_ - before) / tick_dt;
}

/// Returns by how much a view with this centre has to rise to show the targets above it, m. A target that comes into
/// its width raises it bit by bit.
double Camera::rise_to_targets(Vec2 center) const {
  double rise = 0.0;
  for (const Vec2 target : targets_) {
    const double missing = target.y + around_target - (center.y + 0.5 * now_.height);
    if (missing <= 0.0) continue;
    const double inside = 0.5 * usual_aspect * now_.height - std::abs(target.x - center.x);
    const double share =
        engine::smoothstep(0.0, edge_zone, inside) * engine::smoothstep(2.0 * most_rise, most_rise, missing);
    rise = std::max(rise, share * missing);
  }
  return rise;
}

Camera::Place Camera::wanted(const CameraSubject& subject) const {
  const Vec2 ahead = clamp_length(seconds_ahead * subject_velocity_, max_ahead);
  const double speed = std::min(length(subject_velocity_) / full_speed, 1.0);
  Place place;
  place.height = slow_height + (fast_height - slow_height) * speed;
  // The spring lags behind a constant velocity: aim ahead by as much.
  const Vec2 lag = (2.0 / stiffness) * subject_velocity_;
  place.at =
      Vec2{subject.at.x + facing_ahead * facing_ + ahead.x, level_height_ + subject_height + 0.8 * ahead.y} + lag;
  if (ground_) {
    const double lowest = *ground_ - below_ground;
    const double highest = highest_shown(subject);
    place.height = std::max(place.height, std::min(highest - lowest, jump_height));
    const double room = lowest + 0.5 * now_.height - place.at.y;
    place.at.y +=
        std::clamp(rise_to_targets({clamp_center(place.at.x, 0.5 * usual_aspect * now_.height, level_.x), place.at.y}),
                   0.0, std::max(room, 0.0));
    // The player has priority.
    place.at.y = std::max(std::min(place.at.y, lowest + 0.5 * now_.height), highest - 0.5 * now_.height);
  }
  place.least = height_for_two(subject);
  place.height = std::max(place.height, place.least);
  // The edge of the level does not stop the camera at once.
  const double view_height = std::max(now_.height, steady_height);
  place.at.x = ease_center(place.at.x, 0.5 * usual_aspect * view_height, level_.x);
  place.at.y = ease_center(place.at.y, 0.5 * view_height, level_.y);
  if (ground_) {
    const double highest = std::min(highest_shown(subject), level_.y);
    place.at.y = std::max(place.at.y, highest - 0.5 * now_.height);
  }
  return place;
}

void Camera::jump_to(const CameraSubject& subject) {
  subject_velocity_ = {subject.velocity.x, subject.hangs ? subject.velocity.y : 0.0};
  facing_ = subject.faces_left ? -1.0 : 1.0;
  level_height_ = subject.at.y;
  ground_.reset();
  if (subject.on_ground) ground_ = subject.at.y - soles;
  velocity_ = subject_velocity_;
  now_.height = wanted(subject).height;
  const Place goal = wanted(subject);
  ground_.reset();
  now_.height = goal.height;
  now_.least = goal.least;
  now_.at = goal.at - (2.0 / stiffness) * velocity_;
  now_.shake = {};
  before_ = now_;
  shaking_ = 0.0;
}

void Camera::tick(const CameraSubject& subject) {
  before_ = now_;
  const Vec2 moving{subject.velocity.x, follow_height(subject)};
  subject_velocity_ += smoothing * (moving - subject_velocity_);
  facing_ += smoothing * ((subject.faces_left ? -1.0 : 1.0) - facing_);
  const Place goal = wanted(subject);
  const Vec2 pull = stiffness * (stiffness * (goal.at - now_.at) - 2.0 * velocity_);
  velocity_ += tick_dt * clamp_length(pull, max_acceleration);
  now_.at += tick_dt * velocity_;
  now_.height += zooming * (goal.height - now_.height);
  now_.least += zooming * (goal.least - now_.least);
  if (subject.lands && subject.impact > hard_landing) shaking_ += shake_size * (subject.impact - hard_landing);
  shaking_ = std::min(shake_decay * shaking_, 0.25);
  ++ticks_;
  now_.shake = shaking_ * Vec2{std::sin(2.1 * ticks_), std::cos(2.9 * ticks_)};
}

engine::View Camera::view(double alpha, int width, int height, bool reduced_motion) const {
  const auto between = [alpha](Vec2 a, Vec2 b) { return a + alpha * (b - a); };
  // A level that is lower or narrower than the view is enlarged, so that its outside is never visible.
  const auto at_alpha = [alpha](double a, double b) { return a + alpha * (b - a); };
  const double wanted_height = reduced_motion ? std::max(steady_height, at_alpha(before_.least, now_.least))
                                              : at_alpha(before_.height, now_.height);
  const double metres_high = std::min({wanted_height, level_.y, level_.x * height / width});
  const double scale = height / metres_high;
  Vec2 center = between(before_.at, now_.at);
  if (!reduced_motion) center += between(before_.shake, now_.shake);
  return {{clamp_center(center.x, 0.5 * width / scale, level_.x), clamp_center(center.y, 0.5 * metres_high, level_.y)},
          scale};
}

}  // namespace game
