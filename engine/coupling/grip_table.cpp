#include "ribbon/box2d/grip_table.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/near_finder.h"
#include "ribbon/box2d/velocity_carry.h"
#include "ribbon/cord_forces.h"

namespace ribbon::box2d {
namespace {

constexpr double same_place = 1e-6;          // columns
constexpr double return_share = 0.2;         // of its distance that a cord returns in a tick to a blocked anchor
constexpr double closed_distance = 1e-6;     // m, below which the anchor has been reached
constexpr double max_return_speed = 0.5;     // m/s
constexpr double max_slip_return = 3.0;      // m/s, the same for a grip that has slipped beside its cord
constexpr double arc_rounding = 1.0 + 1e-9;  // links may add up to a little more than the length in the definition
// m, from an anchor to its cord, from which on a support need not touch
constexpr double kept_off_distance = 10.0 * static_cast<double>(b2_linearSlop);

/// Sets the place of a new grip from its definition.
void set_place(BodyGrip& grip, const GripDef& def, const CoupledCord& cord) {
  if (def.point) {
    check_range("point", *def.point, 0, static_cast<double>(cord.positions().size()) - 1.0);
    grip.point = *def.point;
    return;
  }
  const CordShape shape = cord.shape();
  check_range("row", def.row, 0, shape.rows - 1);
  check_arc(cord, def.arc);
  grip.point = def.row;
  set_column(grip, cord.column_at(def.arc), shape.columns, shape.rows);
}

/// Returns the vector from the body's centre to the anchor that the cord is to be at, m. If the body is elsewhere than
/// where the cord took it, because Box2D's contacts kept it away or because it slipped past a bend, the anchor is
/// assumed to be at the cord, and returns to its place over several ticks. A return in one tick would throw the lighter
/// of the two, again in each tick.
Vec2 anchor_for_step(BodyGrip& grip, const CoupledCord& cord, Vec2 center, Vec2 anchor, double dt) {
  if (!cord.is_direct()) return anchor;
  const Vec2 at_cord = cord.position(grip.point, grip.along) - center;
  const Vec2 distance = anchor - at_cord;
  grip.blocked = length(distance) > closed_distance && (grip.blocked || grip.slips || meets_anything(*grip.body));
  if (!grip.blocked) return anchor;
  const double speed = grip.may_slip() ? max_slip_return : max_return_speed;
  return at_cord + std::min(return_share, speed * dt / length(distance)) * distance;
}

/// Returns how far a grip climbs in a tick, columns.
double climb_in_tick(const BodyGrip& grip, const CoupledCord& cord, double dt) {
  if (grip.climb_to < 0.0) return 0.0;
  const double column = column_of(grip, cord);
  const double most = grip.climb_speed * dt;
  return cord.free_of_wheels(column, column + std::clamp(grip.climb_to - column, -most, most)) - column;
}

bool is_at_end(const BodyGrip& grip, const CoupledCord& cord) {
  const int column = grip.point / cord.shape().rows;
  return grip.along == 0.0 && (column == 0 || column == cord.shape().columns - 1);
}

/// Reads the result of a step for one grip of a cord: its force, and the distance that it slid and climbed. Returns
/// whether it slid past an end.
bool follow_grip(BodyGrip& grip, const CoupledCord& cord, std::size_t index) {
  grip.pull = {};
  grip.drives_point = true;
  double slid = 0.0;
  grip.slips = false;
  for (const Cord::Holder& solved : cord.direct().holders()) {
    if (solved.grip != static_cast<int>(index)) continue;
    grip.pull = solved.pull;
    grip.drives_point = false;
    slid = solved.slid;
    grip.slips = solved.slips;
  }
  const CordShape shape = cord.shape();
  const double before = column_of(grip, cord);
  const double column = cord.free_of_wheels(before, before + cord.grips[index].climb + slid);
  if (column != before) set_column(grip, column, shape.columns, shape.rows);
  if (grip.climb_to >= 0.0 && std::abs(grip.climb_to - column_of(grip, cord)) <= same_place) grip.climb_to = -1.0;
  return grip.slips && (column < -same_place || column > shape.columns - 1 + same_place);
}

}  // namespace

void set_column(GripMemory& grip, double column, int columns, int rows) {
  if (std::isnan(column)) return;
  const double last = columns - 1.0;
  const double inside = std::clamp(column, 0.0, last);
  const double whole =
      std::min(std::round(inside * 1e9) == std::round(inside) * 1e9 ? std::round(inside) : std::floor(inside), last);
  grip.point = static_cast<int>(whole) * rows + grip.point % rows;
  grip.along = std::max(0.0, inside - whole);
  if (grip.along < 1e-9) grip.along = 0.0;
}

void check_arc(const CoupledCord& cord, double arc) {
  const double whole = cord.arc_at(cord.shape().columns - 1.0);
  if (!(arc <= whole * arc_rounding)) check_range("arc", arc, 0.0, whole);
  check_range("arc", arc, 0.0, whole * arc_rounding);
}

double column_of(const GripMemory& grip, const CoupledCord& cord) {
  const int whole = grip.point / cord.shape().rows;
  return whole + grip.along;
}

BodyGrip GripTable::make(b2Body& body, const GripDef& def, const CoupledCord& cord) const {
  if (!cord.is_direct() && (!def.point || def.strength != std::numeric_limits<double>::infinity())) {
    throw CallError("cord " + std::to_string(cord.id) +
                    " is of the thesis solver; accepted is a grip at a point, with infinite strength");
  }
  check_coordinates("local_anchor", to_double(def.local_anchor));
  if (!(def.strength >= 0.0)) refuse("strength", def.strength, "0 or more");
  BodyGrip grip{{next_, cord.id, 0, def.local_anchor, def.local_anchor}, &body, SeenBody(body)};
  grip.strength = def.lets_go ? std::numeric_limits<double>::infinity() : def.strength;
  grip.lets_go = def.lets_go;
  grip.most_pull = def.strength;
  set_place(grip, def, cord);
  cord.check_off_wheels("a grip", column_of(grip, cord));
  for (const BodyGrip& other : grips_) {
    const bool same_row = (other.point - grip.point) % cord.shape().rows == 0;
    if (other.body != &body || !other.seen.is(body) || other.cord != cord.id || !same_row) continue;
    if (std::abs(column_of(other, cord) - column_of(grip, cord)) > same_place) continue;
    throw CallError("the body holds cord " + std::to_string(cord.id) + " at point " + std::to_string(other.point) +
                    " already, by grip " + std::to_string(other.id) +
                    "; accepted is another place, or a move of that grip");
  }
  return grip;
}

GripId GripTable::add(const BodyGrip& grip) {
  grips_.push_back(grip);
  return next_++;
}

void GripTable::remove(GripId id) { grips_.erase(grips_.begin() + (find(id) - grips_.data())); }

const BodyGrip* GripTable::find(GripId id) const {
  const auto found = std::lower_bound(grips_.begin(), grips_.end(), id,
                                      [](const BodyGrip& grip, GripId wanted) { return grip.id < wanted; });
  return found != grips_.end() && found->id == id ? &*found : nullptr;
}

BodyGrip* GripTable::find(GripId id) { return const_cast<BodyGrip*>(std::as_const(*this).find(id)); }

BodyGrip& GripTable::at(GripId id) { return const_cast<BodyGrip&>(std::as_const(*this).at(id)); }

const BodyGrip& GripTable::at(GripId id) const {
  if (const BodyGrip* const found = find(id)) return *found;
  throw CallError("grip is " + std::to_string(id) + "; accepted is the id of one that has not been released");
}

const BodyGrip* GripTable::first_of(const b2Body& body) const {
  for (const BodyGrip& grip : grips_) {
    if (grip.body == &body && grip.seen.is(body)) return &grip;
  }
  return nullptr;
}

bool GripTable::has_predecessor(const b2Body& body) const {
  return std::any_of(grips_.begin(), grips_.end(),
                     [&body](const BodyGrip& grip) { return grip.body == &body && !grip.seen.is(body); });
}

void GripTable::forget(const b2Body& body) {
  std::erase_if(grips_, [&body](const BodyGrip& grip) { return grip.body == &body; });
}

void GripTable::forget_gone(BodyFinder& finder) {
  if (grips_.empty()) return;
  finder.clear();
  for (const BodyGrip& grip : grips_) finder.want(grip.body);
  finder.search();
  std::erase_if(grips_, [&finder](const BodyGrip& grip) { return !finder.was_found(grip.seen); });
}

void GripTable::drop_unable() {
  std::erase_if(grips_, [](const BodyGrip& grip) { return !grip.body->IsEnabled() || !is_sound(*grip.body); });
  for (BodyGrip& grip : grips_) grip.seen = SeenBody(*grip.body);
}

/// A grip that slides stops at an end of its cord that is fixed or that another grip holds without slipping. Off
/// another end it slips.
bool GripTable::stops_at(const CoupledCord& cord, int point, GripId grip) const {
  return cord.direct().kind(point) != PointKind::free ||
         std::any_of(grips_.begin(), grips_.end(), [&](const BodyGrip& other) {
           return other.cord == cord.id && other.point == point && other.along == 0.0 && !other.may_slip() &&
                  other.id != grip;
         });
}

SlipPlace GripTable::place_of(BodyGrip& grip, const CoupledCord& cord, Vec2 hand) const {
  move_to_nearest(grip, cord, hand);
  return slip_place(grip, cord, hand, is_at_end(grip, cord) && stops_at(cord, grip.point, grip.id));
}

void GripTable::gather(CordTable& cords, double dt, const std::function<int(b2Body&)>& index_of) {
  for (BodyGrip& held : grips_) {
    const b2Body& body = *held.body;
    if (!can_be_met(body)) continue;
    CoupledCord& cord = cords.at(held.cord);
    cords.activate(cord);
    const Vec2 center = to_double(body.GetWorldCenter());
    const Vec2 anchor = to_double(body.GetWorldPoint(held.local_anchor)) - center;
    const Vec2 travel = to_double(body.GetWorldVector(held.next_anchor - held.local_anchor));
    const SlipPlace place = held.may_slip() ? place_of(held, cord, center + anchor) : SlipPlace{held.point, held.along};
    const Vec2 offset = anchor_for_step(held, cord, center, anchor, dt);
    Grip grip{place.point, index_of(*held.body), offset, travel};
    grip.along = place.along;
    grip.climb = climb_in_tick(held, cord, dt);
    grip.returns = held.blocked;
    grip.beside = anchor - offset;
    grip.across = grip.climb == 0.0 ? place.across : Vec2{};
    if (!place.stops) grip.strength = held.strength;
    grip.caught = place.is_caught;
    cord.grips.push_back(grip);
    cord.grip_ids.push_back(held.id);
  }
}

double GripTable::reach_of_kept_off(const CoupledCord& cord, int body, double dt) const {
  double reach = 0.0;
  for (std::size_t k = 0; k < cord.grips.size(); ++k) {
    const Grip& grip = cord.grips[k];
    if (grip.body != body || !grip.returns) continue;
    const BodyGrip& held = at(cord.grip_ids[k]);
    const Vec2 anchor = to_double(held.body->GetWorldPoint(held.local_anchor) - held.body->GetWorldCenter());
    const double distance = length(anchor - grip.offset);
    if (!(distance > kept_off_distance)) continue;
    const double speed = length(cord.direct().velocities()[static_cast<std::size_t>(grip.point)]) +
                         length(to_double(held.body->GetLinearVelocity()));
    reach = std::max(reach, distance + dt * speed);
  }
  return reach;
}

void GripTable::follow(const CordTable& cords, Vec2 gravity) {
  if (grips_.empty()) return;
  for (BodyGrip& grip : grips_) grip.local_anchor = grip.next_anchor;
  for (const CoupledCord& cord : cords.active()) {
    if (!cord.is_direct()) continue;
    for (std::size_t k = 0; k < cord.grips.size(); ++k) {
      BodyGrip* const held = find(cord.grip_ids[k]);
      if (held == nullptr) continue;  // it was released since gather
      held->slipped_off = follow_grip(*held, cord, k) && !stops_at(cord, held->point, held->id);
      if (held->drives_point && held->may_slip() && cord.direct().kind(held->point) == PointKind::free) {
        held->pull = -holding_force(cord.direct(), held->point, gravity);  // tells whether a bend still catches it
      }
    }
  }
}

void GripTable::clear(GripId next) {
  grips_.clear();
  next_ = next;
}

void GripTable::restore(const GripMemory& memory, b2Body& body) { grips_.push_back({memory, &body, SeenBody(body)}); }

}  // namespace ribbon::box2d
