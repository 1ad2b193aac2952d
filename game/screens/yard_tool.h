#pragma once

#include <cstddef>
#include <optional>

#include "game/simulation/simulation.h"
#include "game/simulation/yard.h"
#include "ribbon/vec2.h"

namespace game {

/// The tool in the hand of a player that builds in a sandbox: a kind of thing to place, or to move or remove things. It
/// works at places of the world; a thing with two ends takes two, and so does a move.
class YardTool {
 public:
  enum class Kind : unsigned char { place, move, remove };

  /// What the use of a tool has led to.
  struct Outcome {
    std::optional<Yard> changed{};        ///< the new yard
    std::optional<PlacingFault> fault{};  ///< why there is none
  };

  /// Takes a tool, and forgets the first place of the one before.
  void take(Kind kind, Thing thing = Thing::rope);
  Kind kind() const { return kind_; }
  Thing thing() const { return thing_; }

  /// Uses the tool at a place. `simulation`: a run that has just begun with the yard.
  Outcome use(ribbon::Vec2 at, const Simulation& simulation);
  /// The first of two places, if it is known: the first end, or where a thing was picked up.
  const std::optional<ribbon::Vec2>& begun() const { return begun_; }
  void forget() { begun_.reset(); }

  /// Returns the thing as it would be placed or moved to now; nothing if the tool does neither here.
  std::optional<PlacedThing> preview(ribbon::Vec2 at, const Yard& yard) const;
  /// Returns why that would fail.
  std::optional<PlacingFault> fault_at(ribbon::Vec2 at, const Simulation& simulation) const;
  /// Returns the index of the thing that the tool would pick up or remove, or has picked up.
  std::optional<std::size_t> picked(ribbon::Vec2 at, const Yard& yard) const;

 private:
  std::optional<std::size_t> replaced() const;

  Kind kind_ = Kind::place;
  Thing thing_ = Thing::rope;
  std::optional<ribbon::Vec2> begun_;
  std::size_t carried_ = 0;  // index of the thing that is moved
};

}  // namespace game
