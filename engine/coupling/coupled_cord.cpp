#include "ribbon/box2d/coupled_cord.h"

#include "ribbon/box2d/leaf_search.h"
#include "ribbon/box2d/slot.h"
#include "ribbon/cord_sweep.h"
#include "ribbon/pulley.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace ribbon::box2d {
namespace {

// Memory that every cord has from the start.
constexpr std::size_t usual_fixtures = 64;
constexpr std::size_t usual_grips = 8;
constexpr std::size_t usual_supports = 32;
constexpr std::size_t usual_touches = 16;

CordShape shape_of(const ThesisCord& cord) {
  const Mesh& mesh = cord.mesh();
  return {mesh.w, mesh.h, (mesh.h - 1) * mesh.spacing, true};
}

CordShape shape_of(const Cord& cord) {
  const CordDef& def = cord.def();
  const bool braced = def.rows > 1 && def.elements == Elements::bars;
  return {def.points, def.rows, def.width + 2.0 * def.radius, braced};
}

[[noreturn]] void refuse_solver(const CoupledCord& coupled, Solver wanted) {
  throw CallError("cord " + std::to_string(coupled.id) + " is of the " + std::string(solver_name(coupled.solver())) +
                  " solver; accepted is one of the " + std::string(solver_name(wanted)) + " solver");
}

}  // namespace

CoupledCord::CoupledCord(std::variant<ThesisCord, Cord> of_solver, const b2Filter& cord_filter)
    : filter(cord_filter), cord(std::move(of_solver)) {
  if (const Cord* const of_direct = std::get_if<Cord>(&cord)) def = std::make_shared<const CordDef>(of_direct->def());
}

std::string_view solver_name(Solver solver) { return solver == Solver::direct ? "direct" : "thesis"; }

Cord& CoupledCord::direct() { return const_cast<Cord&>(std::as_const(*this).direct()); }

const Cord& CoupledCord::direct() const {
  if (!is_direct()) refuse_solver(*this, Solver::direct);
  return std::get<Cord>(cord);
}

ThesisCord& CoupledCord::thesis() { return const_cast<ThesisCord&>(std::as_const(*this).thesis()); }

const ThesisCord& CoupledCord::thesis() const {
  if (is_direct()) refuse_solver(*this, Solver::thesis);
  return std::get<ThesisCord>(cord);
}

CordShape CoupledCord::shape() const {
  return std::visit([](const auto& of_solver) { return shape_of(of_solver); }, cord);
}

Vec2 CoupledCord::position(int point, double along) const {
  const auto x = positions();
  if (along == 0.0) return x[slot(point)];
  return x[slot(point)] + along * (x[slot(point + shape().rows)] - x[slot(point)]);
}

double CoupledCord::arc_at(double column) const {
  if (!is_direct()) return 0.0;
  const Cord& direct = this->direct();
  double arc = 0.0;
  int whole = 0;
  for (; whole + 1 <= column && whole + 1 < direct.def().points; ++whole) arc += direct.rest_length(whole);
  return whole + 1 < direct.def().points ? arc + (column - whole) * direct.rest_length(whole) : arc;
}

double CoupledCord::column_at(double arc) const {
  const Cord& direct = this->direct();
  int column = 0;
  while (column + 2 < direct.def().points && arc > direct.rest_length(column)) arc -= direct.rest_length(column++);
  return column + std::min(1.0, arc / direct.rest_length(column));
}

bool CoupledCord::may_be_within(Vec2 position, double distance) const {
  if (!enabled) return false;
  if (!is_direct()) return true;
  return overlap(widened(sweep_of(direct()).box, distance), {position, position});
}

void CoupledCord::reserve() {
  if (auto* thesis = std::get_if<ThesisCord>(&cord)) {
    thesis->reserve(usual_fixtures, usual_fixtures, usual_grips);
  } else {
    direct().free_solver();
    direct().reserve(usual_grips);
  }
  circles.reserve(usual_fixtures);
  segments.reserve(usual_fixtures);
  near.reserve(usual_fixtures);
  grips.reserve(usual_grips);
  supports.reserve(usual_supports);
  grip_ids.reserve(usual_grips);
  touching.reserve(usual_touches);
  touching_before.reserve(usual_touches);
}

const Pulley* CoupledCord::wheel_at(double column) const {
  if (!is_direct()) return nullptr;
  const std::span<const Pulley> pulleys = pulleys_of(direct());
  const auto found = std::find_if(pulleys.begin(), pulleys.end(), [column](const Pulley& pulley) {
    return column > pulley.def.before && column < pulley.def.after;
  });
  return found == pulleys.end() ? nullptr : &*found;
}

void CoupledCord::check_off_wheels(const char* what, double column) const {
  const Pulley* const pulley = wheel_at(column);
  if (pulley == nullptr) return;
  throw CallError(std::string(what) + " is on a wheel of cord " + std::to_string(id) + ", between points " +
                  std::to_string(pulley->def.before) + " and " + std::to_string(pulley->def.after) +
                  "; accepted is one off its wheels");
}

double CoupledCord::free_of_wheels(double from, double to) const {
  if (!is_direct()) return to;
  for (const Pulley& pulley : pulleys_of(direct())) {
    if (from <= pulley.def.before) to = std::min(to, static_cast<double>(pulley.def.before));
    if (from >= pulley.def.after) to = std::max(to, static_cast<double>(pulley.def.after));
  }
  return to;
}

void CoupledCord::clear_surroundings() {
  circles.clear();
  segments.clear();
  grips.clear();
  grip_ids.clear();
  axles.clear();
  supports.clear();
  tied = false;
}

void fetch_coupled(const CoupledCord& cord, CordMemory what) {
  constexpr std::ptrdiff_t cache_line = 64;  // bytes
  const auto fetch = [](const void* first, const void* last) {
    const auto* const end = static_cast<const std::byte*>(last);
    for (const auto* at = static_cast<const std::byte*>(first); at < end; at += cache_line) prefetch(at);
  };
  if (what == CordMemory::surroundings) return fetch(&cord, &cord.touching);
  prefetch(&cord);
  fetch(&cord.touching, &cord.error + 1);
}

void fetch_solver(const CoupledCord& cord) {
  if (cord.is_direct()) fetch(cord.direct());
}

CordId CordTable::add(std::unique_ptr<CoupledCord> cord) {
  cord->id = next_;
  cord->reserve();
  cords_.push_back(std::move(cord));
  ids_.push_back(next_);
  active_.reserve(cords_.capacity());
  active_.push_back(cords_.back().get());
  resting_.reserve(cords_.capacity());
  return next_++;
}

void CordTable::reserve(std::size_t cords) {
  cords_.reserve(cords);
  ids_.reserve(cords);
  active_.reserve(cords_.capacity());
  resting_.reserve(cords_.capacity());
}

void CordTable::put(CoupledCord cord) {
  if (find(cord.id) != nullptr) remove(cord.id);
  cord.reserve();
  const auto at = static_cast<std::ptrdiff_t>(place(cord.id));
  ids_.insert(ids_.begin() + at, cord.id);
  cords_.insert(cords_.begin() + at, std::make_unique<CoupledCord>(std::move(cord)));
  CoupledCord* const added = cords_[static_cast<std::size_t>(at)].get();
  const auto by_id = [](const CoupledCord* a, const CoupledCord* b) { return a->id < b->id; };
  active_.insert(std::lower_bound(active_.begin(), active_.end(), added, by_id), added);
  resting_.reserve(cords_.capacity());
}

void CordTable::remove(CordId id) {
  const auto at = static_cast<std::ptrdiff_t>(place(id));
  CoupledCord* const cord = cords_[place(id)].get();
  activate(*cord);
  active_.erase(std::find(active_.begin(), active_.end(), cord));
  cords_.erase(cords_.begin() + at);
  ids_.erase(ids_.begin() + at);
}

void CordTable::activate(CoupledCord& cord) {
  if (!cord.resting) return;
  activate_if([&](const CoupledCord& resting) { return &resting == &cord; });
}

/// The number of cords with smaller ids. A cord is at its id until one before it has been removed.
std::size_t CordTable::place(CordId id) const {
  if (id >= 0 && id < size() && ids_[slot(id)] == id) return slot(id);
  return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

const CoupledCord* CordTable::find(CordId id) const {
  const std::size_t at = place(id);
  return at < ids_.size() && ids_[at] == id ? cords_[at].get() : nullptr;
}

CoupledCord* CordTable::find(CordId id) { return const_cast<CoupledCord*>(std::as_const(*this).find(id)); }

const CoupledCord& CordTable::at(CordId id) const {
  if (const CoupledCord* found = find(id)) return *found;
  throw CallError("cord is " + std::to_string(id) + "; accepted is the id of a cord that was added and not removed");
}

CoupledCord& CordTable::at(CordId id) { return const_cast<CoupledCord&>(std::as_const(*this).at(id)); }

CoupledCord& CordTable::enabled(CordId id) {
  CoupledCord& found = at(id);
  if (found.enabled) return found;
  throw CallError("cord " + std::to_string(id) + " is disabled; accepted is one that is enabled");
}

}  // namespace ribbon::box2d
