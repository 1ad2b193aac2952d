#include "game/simulation/cord_hold.h"

#include <algorithm>

#include "game/simulation/nearest_pin.h"
#include "game/simulation/nearest_point.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::Coupling;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

/// Returns the position from which the held position hangs: the nearest constrained point, else the cord's first point.
Vec2 anchor_of(const Coupling& coupling, const ribbon::box2d::CordPoint& held) {
  const ribbon::box2d::CordView cord = coupling.cord(held.cord);
  return cord.positions()[static_cast<std::size_t>(std::max(nearest_pin(cord, held.point), 0))];
}

}  // namespace

void CordHold::begin_tick(bool grabs, Vec2 hand, const Coupling& coupling, const PlayerTuning& tuning) {
  if (!grabs) may_catch_ = true;
  forget_left_cord(hand, coupling, tuning);
  climbs_ = false;
}

ribbon::box2d::CordPoint CordHold::place(const Coupling& coupling) const {
  const ribbon::box2d::GripState held = coupling.grip(*grip_id_).state();
  return {held.cord, held.point, 0.0, held.along};
}

void CordHold::take(const ribbon::box2d::CordPoint& place, b2Body& body, Coupling& coupling) {
  const ribbon::box2d::CordRef cord = coupling.cord(place.cord);
  grip_ = cord.position(place.point, place.along) - to_double(body.GetPosition());
  can_climb_ = cord.solver() == ribbon::box2d::Solver::direct;
  if (!can_climb_) {
    grip_id_ = coupling.hold(place.cord, place.point, body, to_float(grip_));
    return;
  }
  ribbon::box2d::GripDef grip;
  grip.cord = place.cord;
  grip.arc = cord.arc(place.point, place.along);
  grip.row = place.point % cord.shape().rows;
  grip.local_anchor = to_float(grip_);
  grip_id_ = coupling.hold(body, grip);
}

std::optional<Vec2> CordHold::hang(const ribbon::box2d::CordPoint& held, int climb, const b2Body& body,
                                   Coupling& coupling, const PlayerTuning& tuning) {
  grip_ += tuning.pull_in * (Vec2{0.0, tuning.hand_height} - grip_);
  const Vec2 held_at = coupling.cord(held.cord).position(held.point, held.along);
  if (length(held_at - to_double(body.GetPosition()) - grip_) > tuning.max_arm_length) return std::nullopt;
  coupling.grip(*grip_id_).move_anchor(to_float(grip_));
  if (can_climb_) this->climb(climb, held, coupling, tuning);
  return anchor_of(coupling, held);
}

/// Climbs (1), slides (−1) or stops (0). Up is towards the nearest constrained point, or, without one, towards the
/// higher end.
void CordHold::climb(int direction, const ribbon::box2d::CordPoint& held, Coupling& coupling,
                     const PlayerTuning& tuning) {
  const ribbon::box2d::CordRef cord = coupling.cord(held.cord);
  const double here = cord.arc(held.point, held.along);
  if (direction == 0) return coupling.grip(*grip_id_).climb(here, tuning.climb_speed);  // stops
  const ribbon::box2d::CordShape shape = cord.shape();
  const int pin = nearest_pin(cord, held.point);
  const bool up_is_first = hangs_from_first(cord, held.point);
  const double whole = cord.arc((shape.columns - 1) * shape.rows);
  const double top = pin < 0 ? (up_is_first ? 0.0 : whole) : cord.arc(pin);
  const double upper_end =
      up_is_first ? std::min(here, top + tuning.top_margin) : std::max(here, top - tuning.top_margin);
  const double lower_end = up_is_first ? whole : 0.0;
  climbs_ = true;
  coupling.grip(*grip_id_).climb(direction > 0 ? upper_end : lower_end,
                                 direction > 0 ? tuning.climb_speed : tuning.slide_speed);
}

void CordHold::release(const std::optional<ribbon::box2d::CordPoint>& held, Coupling& coupling) {
  if (held) leave(held->cord);
  if (grip_id_) coupling.grip(*grip_id_).release();
  grip_id_.reset();
  may_catch_ = false;
}

void CordHold::leave(ribbon::box2d::CordId cord) {
  left_cord_ = cord;
  ticks_since_left_ = 0;
}

void CordHold::forget() {
  grip_id_.reset();
  left_cord_.reset();
  may_catch_ = false;
}

void CordHold::forget_left_cord(Vec2 hand, const Coupling& coupling, const PlayerTuning& tuning) {
  if (!left_cord_) return;
  const bool is_there = coupling.cord(*left_cord_).is_valid();
  if (is_there && ++ticks_since_left_ <= tuning.forget_ticks) {
    const auto points = coupling.cord(*left_cord_).positions();
    if (length(points[nearest_point(points, hand)] - hand) < tuning.forget_distance) return;
  }
  left_cord_.reset();
}

void CordHold::add_release_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(static_cast<int>(may_catch_));
  hasher.add(left_cord_.value_or(-1));
  hasher.add(ticks_since_left_);
}

void CordHold::add_grip_to(ribbon::box2d::Hasher& hasher) const {
  hasher.add(can_climb_ ? grip_id_.value_or(-1) : -1);  // recordings have −1 for cords of the thesis's solver
  hasher.add(grip_);
}

}  // namespace game
