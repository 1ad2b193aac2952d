// Who holds which cord, and where along it.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_grips.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double same_place = 1e-6;   // columns
constexpr double drawn_share = 0.2;   // of its way, that a cord is drawn in a tick to a hand that Box2D holds up,
constexpr double closed_way = 1e-6;   // m, of it, that rounds away
constexpr double fastest_draw = 0.5;  // m/s, and at the most

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

void Coupling::check_cord(CordIndex cord) const {
  if (cord >= 0 && cord < size()) return;
  throw ribbon::DefinitionError("cord is " + std::to_string(cord) + "; accepted is an index from 0 to " +
                                std::to_string(size() - 1));
}

void Coupling::check_enabled(CordIndex cord) const {
  check_cord(cord);
  if (is_enabled(cord)) return;
  throw ribbon::DefinitionError("cord " + std::to_string(cord) + " is switched off; accepted is one that is enabled");
}

/// A length that links sum up to may round to a little less than what they were made with.
void Coupling::check_arc(CordIndex cord, double arc) const {
  const double whole = arc_at(cord, this->cord(cord).def().points - 1.0);
  if (!(arc <= whole * (1.0 + 1e-9))) ribbon::check_range("arc", arc, 0.0, whole);
  ribbon::check_range("arc", arc, 0.0, whole * (1.0 + 1e-9));
}

void Coupling::hold(CordIndex cord, int point, b2Body& body, b2Vec2 local_hand) {
  check_enabled(cord);
  std::visit([point](const auto& held) { held.check_point(point); }, cords_[at(cord)].cord);
  ribbon::check_coordinates("local_hand", to_double(local_hand));
  enter(*body.GetWorld());
  drop_if_replaced(body);
  if (Holder* held = holder(body)) {
    if (held->cord != cord || held->point != point) held->local_hand = local_hand;
    held->cord = cord;
    held->point = point;
    held->along = 0.0;
    held->climb_to = -1.0;
    held->next_hand = local_hand;
  } else {
    holders_.push_back({{next_grip_++, cord, point, local_hand, local_hand}, &body, SeenBody(body)});
  }
}

GripId Coupling::grip(b2Body& body, const GripDef& def) {
  check_enabled(def.cord);
  if (solver(def.cord) != Solver::direct) {
    throw ribbon::DefinitionError(
        "cord " + std::to_string(def.cord) +
        " is of the thesis's solver, which is held at points; accepted is one of the direct solver");
  }
  if (body.GetWorld()->IsLocked()) {
    throw ribbon::DefinitionError("world is locked; accepted is one that is not inside its Step");
  }
  const ribbon::Cord& cord = this->cord(def.cord);
  ribbon::check_range("row", def.row, 0, cord.def().rows - 1);
  check_arc(def.cord, def.arc);
  ribbon::check_coordinates("local_hand", to_double(def.local_hand));
  if (!(def.strength >= 0.0)) ribbon::refuse("strength", def.strength, "0 or more");
  enter(*body.GetWorld());
  drop_if_replaced(body);
  Holder held{{next_grip_, def.cord, def.row, def.local_hand, def.local_hand}, &body, SeenBody(body)};
  held.strength = def.lets_go ? std::numeric_limits<double>::infinity() : def.strength;
  held.lets_go = def.lets_go;
  held.most_pull = def.strength;
  set_column(held, column_at(def.cord, def.arc));
  for (const Holder& other : holders_) {
    if (other.body == &body && other.cord == def.cord && std::abs(column(other) - column(held)) <= same_place) {
      throw ribbon::DefinitionError("arc is " + std::to_string(def.arc) +
                                    ", where the body holds the cord already; accepted is any other place");
    }
  }
  holders_.push_back(held);
  return next_grip_++;
}

/// Null if there is none of that number. They are in the order in which they were taken, and so of their numbers.
const Coupling::Holder* Coupling::find_holder(GripId grip) const {
  const auto held = std::lower_bound(holders_.begin(), holders_.end(), grip,
                                     [](const Holder& holder, GripId id) { return holder.id < id; });
  return held != holders_.end() && held->id == grip ? &*held : nullptr;
}

Coupling::Holder* Coupling::find_holder(GripId grip) {
  return const_cast<Holder*>(std::as_const(*this).find_holder(grip));
}

Coupling::Holder& Coupling::grip_of_direct(GripId grip) {
  Holder* const held = find_holder(grip);
  if (held != nullptr && solver(held->cord) == Solver::direct) return *held;
  throw ribbon::DefinitionError("grip is " + std::to_string(grip) +
                                "; accepted is one of a cord of the direct solver that has not been let go");
}

void Coupling::climb(GripId grip, double arc, double speed) {
  Holder& held = grip_of_direct(grip);
  const ribbon::Cord& cord = this->cord(held.cord);
  check_arc(held.cord, arc);
  if (!(speed > 0.0)) ribbon::refuse("speed", speed, "above 0, up to 1e+06");
  ribbon::check_range("speed", speed, 0.0, 1e6);
  held.climb_to = column_at(held.cord, arc);
  held.climb_speed = speed / cord.rest_length(0);
}

void Coupling::move_hand(GripId grip, b2Vec2 local_hand) {
  Holder& held = grip_of_direct(grip);
  ribbon::check_coordinates("local_hand", to_double(local_hand));
  held.next_hand = local_hand;
}

bool Coupling::let_go(GripId grip) {
  const Holder* const held = find_holder(grip);
  if (held == nullptr) return false;
  b2Body* const body = held->body;
  const SeenBody seen = held->seen;
  holders_.erase(holders_.begin() + (held - holders_.data()));
  if (!world_has(seen)) return true;
  body->SetAwake(true);
  if (holder(*body) == nullptr) let_run(*body);
  return true;
}

void Coupling::let_go_of(CordIndex cord) {
  for (std::size_t k = 0; k < holders_.size();) {
    if (holders_[k].cord == cord) {
      let_go(holders_[k].id);
    } else {
      ++k;
    }
  }
}

std::optional<GripState> Coupling::state(GripId grip) const {
  const Holder* const held = find_holder(grip);
  if (held == nullptr) return std::nullopt;
  const CordPoint place{held->cord, held->point, 0.0, held->along};
  return GripState{held->cord, arc_at(held->cord, column(*held)), position(place), held->pull, held->slips};
}

bool Coupling::release(b2Body& body) {
  if (!held_by(body)) return false;
  body.SetAwake(true);
  let_run(body);
  drop(body);
  return true;
}

const Coupling::Holder* Coupling::holder(const b2Body& body) const {
  for (const Holder& holder : holders_) {
    if (holder.body == &body && holder.seen.is(body)) return &holder;
  }
  return nullptr;
}

Coupling::Holder* Coupling::holder(const b2Body& body) {
  return const_cast<Holder*>(std::as_const(*this).holder(body));
}

std::optional<CordPoint> Coupling::held_by(const b2Body& body) const {
  const Holder* held = holder(body);
  if (held == nullptr) return std::nullopt;
  return CordPoint{held->cord, held->point, 0.0, held->along};
}

double Coupling::column(const Holder& holder) const {
  const int whole = holder.point / shape(holder.cord).rows;
  return whole + holder.along;
}

void Coupling::set_column(Holder& holder, double column) const {
  const CordShape shape = this->shape(holder.cord);
  engine::set_column(holder, column, shape.columns, shape.rows);
}

/// m at rest, to columns and back.
double Coupling::column_at(CordIndex cord, double arc) const {
  const ribbon::Cord& direct = this->cord(cord);
  int column = 0;
  while (column + 2 < direct.def().points && arc > direct.rest_length(column)) arc -= direct.rest_length(column++);
  return column + std::min(1.0, arc / direct.rest_length(column));
}

double Coupling::arc_at(CordIndex cord, double column) const {
  if (solver(cord) != Solver::direct) return 0.0;
  const ribbon::Cord& direct = this->cord(cord);
  double arc = 0.0;
  int whole = 0;
  for (; whole + 1 <= column && whole + 1 < direct.def().points; ++whole) arc += direct.rest_length(whole);
  return whole + 1 < direct.def().points ? arc + (column - whole) * direct.rest_length(whole) : arc;
}

void Coupling::gather_grips() {
  for (Holder& held : holders_) {
    const b2Body& body = *held.body;
    if (!can_be_met(body)) continue;
    const Vec2 center = to_double(body.GetWorldCenter());
    const Vec2 hand = drawn(held, center, to_double(body.GetWorldPoint(held.local_hand)) - center);
    const Vec2 travel = to_double(body.GetWorldVector(held.next_hand - held.local_hand));
    ribbon::Grip grip{held.point, body_index(*held.body), hand, travel};
    gathered_[at(grip.body)].holds = true;
    grip.along = held.along;
    grip.climb = climb_in_tick(held);
    grip.strength = held.strength;
    CoupledCord& coupled = cords_[at(held.cord)];
    coupled.grips.push_back(grip);
    coupled.grip_ids.push_back(held.id);
    held.local_hand = held.next_hand;
  }
}

/// The hand, m from the centre. That of a body which Box2D has kept from where its cord led it is taken to be where the
/// cord is, and comes to its own place by and by: all at once it would throw what it holds, again in each tick.
Vec2 Coupling::drawn(Holder& held, Vec2 center, Vec2 hand) const {
  if (solver(held.cord) != Solver::direct) return hand;
  const auto x = positions(held.cord);
  const Vec2 point = x[at(held.point)];
  const Vec2 next = held.along > 0.0 ? x[at(held.point + shape(held.cord).rows)] : point;
  const Vec2 arm = point + held.along * (next - point) - center;
  const Vec2 way = hand - arm;
  held.held_up = length(way) > closed_way && (held.held_up || meets_anything(*held.body));
  if (!held.held_up) return hand;
  const double share = std::min(drawn_share, fastest_draw * dt_ / length(way));
  return arm + share * way;
}

/// Columns.
double Coupling::climb_in_tick(Holder& holder) const {
  if (holder.climb_to < 0.0) return 0.0;
  const double left = holder.climb_to - column(holder);
  const double most = holder.climb_speed * dt_;
  return std::clamp(left, -most, most);
}

/// Where grips have come to, and what they pulled with; who pulled with more than his strength lets go.
void Coupling::follow_grips() {
  for (CordIndex c = 0; c < size(); ++c) {
    if (solver(c) != Solver::direct) continue;
    const CoupledCord& coupled = cords_[at(c)];
    for (std::size_t k = 0; k < coupled.grips.size(); ++k) {
      Holder* const held = find_holder(coupled.grip_ids[k]);
      if (held == nullptr) continue;  // let go of since the tick was gathered for
      held->pull = {};
      double slid = 0.0;
      for (const ribbon::Cord::Holder& solved : cord(c).holders()) {
        if (solved.grip != static_cast<int>(k)) continue;
        held->pull = solved.pull;
        slid = solved.slid;
      }
      held->slips = slid != 0.0;
      const double moved = coupled.grips[k].climb + slid;
      if (moved != 0.0) set_column(*held, column(*held) + moved);
      if (held->climb_to >= 0.0 && std::abs(held->climb_to - column(*held)) <= same_place) held->climb_to = -1.0;
    }
  }
}

/// After the bodies have been moved.
void Coupling::let_go_who_must() {
  for (std::size_t k = 0; k < holders_.size();) {
    if (holders_[k].lets_go && length(holders_[k].pull) > holders_[k].most_pull) {
      let_go(holders_[k].id);
    } else {
      ++k;
    }
  }
}

}  // namespace engine
