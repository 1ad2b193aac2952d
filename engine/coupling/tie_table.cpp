#include "ribbon/box2d/tie_table.h"

#include <algorithm>
#include <string>

#include "ribbon/definition.h"

namespace ribbon::box2d {
namespace {

/// Adds what ties connect with the first of some places.
void complete_group(std::span<const TieMemory> ties, std::vector<TiePlace>& places) {
  const auto add = [&](const TiePlace& place) {
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  };
  for (std::size_t k = 0; k < places.size(); ++k) {
    const TiePlace from = places[k];
    for (const TieMemory& tie : ties) {
      if (tie.place == from) add(tie.other);
      if (tie.other == from) add(tie.place);
    }
  }
}

/// Throws CallError if a new tie would make two points of a cord one, or connect what is connected.
void check_loop(std::span<const TieMemory> ties, const TieMemory& tie) {
  if (tie.place.cord == tie.other.cord) {
    throw CallError("tie is of cord " + std::to_string(tie.place.cord) + " to itself; accepted is a tie of two cords");
  }
  std::vector<TiePlace> group{tie.place};
  complete_group(ties, group);
  if (std::find(group.begin(), group.end(), tie.other) != group.end()) {
    throw CallError("point " + std::to_string(tie.place.point) + " of cord " + std::to_string(tie.place.cord) +
                    " is tied to point " + std::to_string(tie.other.point) + " of cord " +
                    std::to_string(tie.other.cord) + " already; accepted are points that no ties connect");
  }
  std::vector<TiePlace> others{tie.other};
  complete_group(ties, others);
  for (const TiePlace& place : group) {
    const auto of_same_cord = [&](const TiePlace& other) { return other.cord == place.cord; };
    if (std::none_of(others.begin(), others.end(), of_same_cord)) continue;
    throw CallError("tie connects two points of cord " + std::to_string(place.cord) +
                    " through other cords; accepted is one that does not tie a cord to itself");
  }
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
  const TieMemory tie{next_, {def.cord, def.point}, {def.other_cord, def.other_point}, def.breaking_force};
  check_loop(ties_, tie);
  ties_.push_back(tie);
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

void check_loops(std::span<const TieMemory> ties) {
  for (std::size_t k = 0; k < ties.size(); ++k) check_loop(ties.first(k), ties[k]);
}

Vec2 tie_force(const TieMemory& tie, const CordTable& cords, Vec2 gravity) {
  const CoupledCord& cord = cords.at(tie.place.cord);
  const CoupledCord& other = cords.at(tie.other.cord);
  if (!is_held(other, tie.other.point)) return -other.direct().holding_force(tie.other.point, gravity);
  if (!is_held(cord, tie.place.point)) return cord.direct().holding_force(tie.place.point, gravity);
  return {};
}

}  // namespace ribbon::box2d
