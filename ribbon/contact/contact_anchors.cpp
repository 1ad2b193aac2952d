#include "ribbon/contact/contact_anchors.h"

#include <algorithm>

#include "ribbon/geometry/rotation.h"

namespace ribbon {
namespace {

constexpr std::size_t initial_bodies = 16;  // few scenes need more body anchors, so few steps allocate

}  // namespace

void ContactAnchors::clear(std::size_t points) {
  points_ = points;
  bodies_.clear();
  time_ = target_time_ = 0.0;
}

int ContactAnchors::add(const BodyAnchor& anchor) {
  if (bodies_.empty()) bodies_.reserve(initial_bodies);
  bodies_.push_back(anchor);
  return static_cast<int>(points_ + bodies_.size()) - 1;
}

void ContactAnchors::positions(std::span<const Vec2> x, KinematicTime time, std::vector<Vec2>& positions) const {
  positions.reserve(capacity());
  positions.resize(size());
  std::copy(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(points_), positions.begin());
  int rotated = -1;  // the slot of the angle that `turn` belongs to: anchors of one body follow each other
  Vec2 turn;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const BodyAnchor& body = bodies_[k];
    Vec2& position = positions[points_ + k];
    if (body.is_kinematic()) {
      position = time == KinematicTime::target ? body.target : time == KinematicTime::start ? body.start : body.current;
      continue;
    }
    position = x[at(body.center)];
    if (body.arm == Vec2{}) continue;
    if (rotated != body.center + 1) {
      rotated = body.center + 1;
      turn = rotation(x[at(rotated)].x);
    }
    position += times(turn, body.arm);
  }
}

int ContactAnchors::group(int anchor, std::span<const int> group_of) const {
  if (is_point(anchor)) return group_of[at(anchor)];
  const int center = body(anchor).center;
  return center < 0 ? -1 : group_of[at(center)];
}

void ContactAnchors::set_kinematic_targets(double time) {
  target_time_ = time;
  for (BodyAnchor& body : bodies_) {
    if (!body.is_kinematic()) continue;
    body.start = body.current;
    body.target_angle = time * body.angular_velocity;
    body.target = body.body_position + time * body.velocity + times(rotation(body.target_angle), body.arm);
  }
}

void ContactAnchors::advance_kinematics(double fraction) {
  time_ = fraction == 1.0 ? target_time_ : time_ + fraction * (target_time_ - time_);
  for (BodyAnchor& body : bodies_) {
    if (!body.is_kinematic()) continue;
    if (fraction == 1.0) {
      body.current = body.target;
      body.angle = body.target_angle;
    } else {
      body.current += fraction * (body.target - body.current);
      body.angle += fraction * (body.target_angle - body.angle);
    }
  }
}

void ContactAnchors::place_kinematics(double time) {
  set_kinematic_targets(time);
  advance_kinematics(1.0);
}

}  // namespace ribbon
