#include "ribbon/box2d/tie_table.h"

#include <algorithm>
#include <string>
#include <utility>

#include "ribbon/cord_forces.h"
#include "ribbon/definition.h"
#include "ribbon/linear/disjoint_sets.h"

namespace ribbon::box2d {
namespace {

bool comes_before(const TiePlace& a, const TiePlace& b) {
  return std::pair(a.cord, a.point) < std::pair(b.cord, b.point);
}

[[noreturn]] void refuse_itself(const TieMemory& tie) {
  throw CallError("tie is of cord " + std::to_string(tie.place.cord) + " to itself; accepted is a tie of two cords");
}

[[noreturn]] void refuse_tied(const TieMemory& tie) {
  const auto name = [](const TiePlace& place) {
    return "point " + std::to_string(place.point) + " of cord " + std::to_string(place.cord);
  };
  throw CallError(name(tie.place) + " is tied to " + name(tie.other) +
                  " already; accepted are points that no ties connect");
}

/// Returns whether something else than ties and the cord itself pulls at one of its points.
bool is_held(const CoupledCord& cord, int point) {
  if (cord.direct().kind(point) != PointKind::free) return true;
  return std::any_of(cord.grips.begin(), cord.grips.end(), [&](const Grip& grip) {
    return grip.point == point || (grip.along > 0.0 && grip.point + cord.shape().rows == point);
  });
}

}  // namespace

TieId TieTable::add(const TieDef& def, const CordTable& cords) {
  check_range("point", def.point, 0, cords.at(def.cord).direct().size() - 1.0);
  check_range("other_point", def.other_point, 0, cords.at(def.other_cord).direct().size() - 1.0);
  if (!(def.breaking_force > 0.0)) refuse("breaking_force", def.breaking_force, "above 0");
  cords.at(def.cord).check_off_wheels("a tie", def.point);
  cords.at(def.other_cord).check_off_wheels("a tie", def.other_point);
  const TieMemory tie{next_, {def.cord, def.point}, {def.other_cord, def.other_point}, def.breaking_force};
  std::vector<TieMemory> all = ties_;
  all.push_back(tie);
  check_connections(all);
  ties_ = std::move(all);
  of_step_.reserve(ties_.capacity());
  return next_++;
}

void TieTable::remove(TieId id) { ties_.erase(ties_.begin() + (find(id) - ties_.data())); }

const TieMemory* TieTable::find(TieId id) const {
  const auto found = std::lower_bound(ties_.begin(), ties_.end(), id,
                                      [](const TieMemory& tie, TieId wanted) { return tie.id < wanted; });
  return found != ties_.end() && found->id == id ? &*found : nullptr;
}

const TieMemory& TieTable::at(TieId id) const {
  if (const TieMemory* const found = find(id)) return *found;
  throw CallError("tie is " + std::to_string(id) + "; accepted is the id of one that has not been untied");
}

void TieTable::gather(CordTable& cords) const {
  for (const TieMemory& tie : ties_) {
    for (const TiePlace& place : {tie.place, tie.other}) {
      CoupledCord& cord = cords.at(place.cord);
      cords.activate(cord);
      cord.tied = true;
    }
  }
}

std::span<const Tie> TieTable::of_step(const CordTable& cords) {
  of_step_.clear();
  for (const TieMemory& tie : ties_) {
    of_step_.push_back(
        {cords.at(tie.place.cord).step_index, tie.place.point, cords.at(tie.other.cord).step_index, tie.other.point});
  }
  return of_step_;
}

void TieTable::restore(std::span<const TieMemory> ties, TieId next) {
  ties_.assign(ties.begin(), ties.end());
  of_step_.reserve(ties_.capacity());
  next_ = next;
}

void check_connections(std::span<const TieMemory> ties) {
  std::vector<TiePlace> places;
  for (const TieMemory& tie : ties) {
    places.push_back(tie.place);
    places.push_back(tie.other);
  }
  std::sort(places.begin(), places.end(), comes_before);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto number = [&places](const TiePlace& place) {
    return static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), place, comes_before) -
                                    places.begin());
  };
  DisjointSets groups;
  groups.begin(places.size());
  for (const TieMemory& tie : ties) {
    if (tie.place.cord == tie.other.cord) refuse_itself(tie);
    if (groups.root(number(tie.place)) == groups.root(number(tie.other))) refuse_tied(tie);
    groups.join(number(tie.place), number(tie.other));
  }
  std::vector<std::pair<std::size_t, CordId>> members;
  for (std::size_t k = 0; k < places.size(); ++k) members.emplace_back(groups.root(k), places[k].cord);
  std::sort(members.begin(), members.end());
  const auto twice = std::adjacent_find(members.begin(), members.end());
  if (twice == members.end()) return;
  throw CallError("tie connects two points of cord " + std::to_string(twice->second) +
                  " through other cords; accepted is one that does not tie a cord to itself");
}

Vec2 tie_force(const TieMemory& tie, const CordTable& cords, Vec2 gravity) {
  const CoupledCord& cord = cords.at(tie.place.cord);
  const CoupledCord& other = cords.at(tie.other.cord);
  if (!is_held(other, tie.other.point)) return -holding_force(other.direct(), tie.other.point, gravity);
  if (!is_held(cord, tie.place.point)) return holding_force(cord.direct(), tie.place.point, gravity);
  return {};
}

}  // namespace ribbon::box2d
