#include "game/screens/yard_tool.h"

#include <utility>

namespace game {

using ribbon::Vec2;

void YardTool::take(Kind kind, Thing thing) {
  kind_ = kind;
  thing_ = thing;
  forget();
}

std::optional<std::size_t> YardTool::picked(Vec2 at, const Yard& yard) const {
  if (kind_ == Kind::place) return std::nullopt;
  if (kind_ == Kind::move && begun_) return carried_;
  return nearest_thing(yard, at);
}

std::optional<PlacedThing> YardTool::preview(Vec2 at, const Yard& yard) const {
  if (kind_ == Kind::remove || (kind_ == Kind::move && !begun_)) return std::nullopt;
  if (kind_ == Kind::place) return thing_at(thing_, begun_.value_or(at), at);
  const PlacedThing& carried = yard.things[carried_];
  return thing_at(carried.thing, carried.first + at - *begun_, carried.second + at - *begun_);
}

/// The thing that a placed one replaces.
std::optional<std::size_t> YardTool::replaced() const {
  return kind_ == Kind::move && begun_ ? std::optional(carried_) : std::nullopt;
}

std::optional<PlacingFault> YardTool::fault_at(Vec2 at, const Simulation& simulation) const {
  const std::optional<PlacedThing> wanted = preview(at, simulation.level().yard);
  if (!wanted) return std::nullopt;
  const auto fault = fault_of(simulation, *wanted, replaced());
  const bool has_one_end = kind_ == Kind::place && has_two_ends(thing_) && !begun_;
  return has_one_end && fault == PlacingFault::too_short ? std::nullopt : fault;
}

YardTool::Outcome YardTool::use(Vec2 at, const Simulation& simulation) {
  Yard yard = simulation.level().yard;
  if (kind_ != Kind::place && !begun_) {
    const auto index = nearest_thing(yard, at);
    if (!index) return {};
    if (kind_ == Kind::move) {
      begun_ = at;
      carried_ = *index;
      return {};
    }
    yard.things.erase(yard.things.begin() + static_cast<std::ptrdiff_t>(*index));
    return {std::move(yard), {}};
  }
  if (const auto fault = fault_at(at, simulation)) return {{}, fault};
  if (kind_ == Kind::place && has_two_ends(thing_) && !begun_) {
    begun_ = at;
    return {};
  }
  const PlacedThing placed = *preview(at, yard);
  if (const auto index = replaced()) {
    yard.things[*index] = placed;
  } else {
    yard.things.push_back(placed);
  }
  forget();
  return {std::move(yard), {}};
}

}  // namespace game
