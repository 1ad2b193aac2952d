#include "ribbon/box2d/coupling_parts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "ribbon/cord_forces.h"
#include "ribbon/pulley.h"

namespace ribbon::box2d {
namespace {

constexpr std::size_t usual_bodies = 64;
constexpr std::size_t usual_found_supports = 16;  // of a body
constexpr std::size_t usual_events = 16;

}  // namespace

CordId CouplingParts::add(std::unique_ptr<CoupledCord> cord) {
  const CordId id = cords.add(std::move(cord));
  bodies.reserve(usual_bodies);
  fixtures.reserve(usual_bodies);
  finder.reserve(usual_bodies);
  near_fixtures.reserve(usual_bodies);
  found_supports.reserve(usual_found_supports);
  supported.reserve(usual_bodies);
  touches.reserve(usual_events);
  cuts.reserve(usual_events);
  overloaded.reserve(usual_events);
  overloaded_ties.reserve(usual_events);
  relieved.reserve(2 * usual_events);
  gatherer.reserve(usual_bodies, cords.ids().size());
  return id;
}

void CouplingParts::reserve(std::size_t new_cords, int points) {
  spares.reserve(new_cords, points);
  const std::size_t all = cords.ids().size() + new_cords;
  cords.reserve(all);
  cuts.reserve(cuts.events().size() + all);
  blade_cuts.reserve(all);
  overloaded.reserve(all);
  island_cords.reserve(all);
  reports.reserve(all);
  gatherer.reserve(usual_bodies, all);
  solver.reserve(all);
}

void CouplingParts::remove(CordId cord) {
  touches.end_all(cords.at(cord));
  sensors.end_all(cords.at(cord));
  detach(cord);
  cords.remove(cord);
}

void CouplingParts::enter(const b2World& world) {
  if (!finder.enter(world)) return;
  carry.clear();
  fixtures.forget_all();
  grips.forget_gone(finder);
}

void CouplingParts::forget_predecessor(const b2Body& body) {
  if (!grips.has_predecessor(body) && !carry.has_predecessor(body)) return;
  grips.forget(body);
  pulleys.forget(body, cords);
  carry.forget(body);
}

/// A static or kinematic body that holds a point drives it, unless a pin does. Several share the force: how it divides
/// among rigid bodies, statics does not determine.
Vec2 CouplingParts::pull(const BodyGrip& grip) const {
  if (!grip.drives_point) return grip.pull;
  const Cord& cord = cords.at(grip.cord).direct();
  if (cord.kind(grip.point) != PointKind::free) return {};
  const auto drives_it = [&](const BodyGrip& other) {
    return other.drives_point && other.cord == grip.cord && other.point == grip.point;
  };
  const auto drives = std::count_if(grips.all().begin(), grips.all().end(), drives_it);
  return (-1.0 / static_cast<double>(drives)) * holding_force(cord, grip.point, conditions.gravity);
}

bool CouplingParts::release(GripId grip) {
  const BodyGrip* const found = grips.find(grip);
  if (found == nullptr) return false;
  b2Body* const body = found->body;
  const bool exists = finder.exists(found->seen);
  grips.remove(grip);
  if (!exists) return true;
  body->SetAwake(true);
  if (grips.first_of(*body) == nullptr) carry.release(*body);
  return true;
}

/// Without the tie, the accelerations that its cords have are out of date.
bool CouplingParts::untie(TieId tie) {
  const TieMemory* const found = ties.find(tie);
  if (found == nullptr) return false;
  for (const TiePlace& place : {found->place, found->other}) {
    Cord& cord = cords.at(place.cord).direct();
    cord.set_velocity(place.point, cord.velocities()[static_cast<std::size_t>(place.point)]);
  }
  ties.remove(tie);
  return true;
}

bool CouplingParts::remove_pulley(PulleyId pulley) {
  const BodyPulley* const found = pulleys.find(pulley);
  if (found == nullptr) return false;
  b2Body* const body = found->body;
  const bool exists = finder.exists(found->seen);
  pulleys.remove(pulley, cords);
  if (exists) body->SetAwake(true);
  return true;
}

void CouplingParts::detach(CordId cord) {
  may_have_left_bodies = true;
  for (std::size_t k = 0; k < grips.all().size();) {
    if (grips.all()[k].cord == cord) {
      release(grips.all()[k].id);
    } else {
      ++k;
    }
  }
  for (std::size_t k = 0; k < ties.all().size();) {
    const TieMemory& tie = std::as_const(ties).all()[k];
    if (tie.place.cord == cord || tie.other.cord == cord) {
      untie(tie.id);
    } else {
      ++k;
    }
  }
  pulleys.remove_all(cords.at(cord));
  for (CoupledCord& other : cords) {
    if (!other.is_direct() || other.id == cord) continue;
    const auto contacts = other.direct().touches();
    const bool touches_removed = std::any_of(contacts.begin(), contacts.end(),
                                             [cord](const Touch& touch) { return touch.other == solver_id(cord); });
    if (touches_removed) other.direct().wake();
  }
}

void check_without_pulleys(const CoupledCord& cord) {
  if (!cord.is_direct() || pulleys_of(cord.direct()).empty()) return;
  throw CallError("the cord has pulleys; accepted is one without, to which Coupling::add_pulley adds them");
}

void check_nothing_held(const CouplingParts& parts, const CoupledCord& cord, const PulleyDef& def) {
  const auto check_place = [&](const char* what, int id, double column) {
    if (column <= def.before || column >= def.after) return;
    throw CallError(std::string(what) + " " + std::to_string(id) + " is between points " + std::to_string(def.before) +
                    " and " + std::to_string(def.after) + " of cord " + std::to_string(cord.id) +
                    "; accepted is a wheel where nothing holds the cord");
  };
  for (const BodyGrip& grip : parts.grips.all()) {
    if (grip.cord == cord.id) check_place("grip", grip.id, column_of(grip, cord));
  }
  for (const TieMemory& tie : parts.ties.all()) {
    for (const TiePlace& place : {tie.place, tie.other}) {
      if (place.cord == cord.id) check_place("tie", tie.id, place.point);
    }
  }
}

void check_between_ticks(const CouplingParts& parts, const char* what) {
  const std::string call(what);
  if (parts.finder.is_locked())
    throw CallError("world is locked; accepted is a " + call + " that is not inside its Step");
  if (parts.phase == TickPhase::between_ticks) return;
  throw CallError(call + " is between gather and apply; accepted is one before gather or after apply");
}

}  // namespace ribbon::box2d
