#pragma once

#include <span>
#include <vector>

#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/tie.h"

namespace ribbon::box2d {

/// All ties of a coupling, ordered by id.
class TieTable {
 public:
  /// Adds a tie between cords that exist. Throws CallError or DefinitionError as Coupling::tie does.
  TieId add(const TieDef& def, const CordTable& cords);
  /// Removes the tie with that id, which exists.
  void remove(TieId id);
  /// Returns a tie, or null if there is none with that id.
  const TieMemory* find(TieId id) const;
  /// Returns a tie. Throws CallError if there is none with that id.
  const TieMemory& at(TieId id) const;
  /// Returns the ties, by id.
  std::span<const TieMemory> all() const { return ties_; }
  /// The same, to change what they tie.
  std::span<TieMemory> all() { return ties_; }

  /// Makes all tied cords active in this tick.
  void gather(CordTable& cords) const;
  /// Returns the ties of a step, by the places of the cords in it.
  std::span<const Tie> of_step(const CordTable& cords);

  /// Returns the id of the next tie to be added.
  TieId next() const { return next_; }
  /// Replaces all ties.
  void restore(std::span<const TieMemory> ties, TieId next);

 private:
  std::vector<TieMemory> ties_;
  std::vector<Tie> of_step_;
  TieId next_ = 1;
};

/// Throws CallError if ties connect two points of a cord, or two points in two ways.
void check_connections(std::span<const TieMemory> ties);

/// Returns the force [N] of the other cord on the first one where they are tied, under `gravity` [m/s²].
Vec2 tie_force(const TieMemory& tie, const CordTable& cords, Vec2 gravity);

}  // namespace ribbon::box2d
