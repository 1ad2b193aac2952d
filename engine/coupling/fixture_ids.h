#pragma once

#include <box2d/b2_fixture.h>

#include <cstdint>
#include <span>
#include <vector>

#include "ribbon/box2d/address_table.h"
#include "ribbon/box2d/body_identity.h"

namespace ribbon::box2d {

/// Assigns a number to each fixture that is near a cord. A fixture keeps its number from tick to tick; numbers are
/// counted up. Addresses are used only for lookup, so results do not depend on them.
class FixtureIds {
 public:
  /// A fixture and its number.
  struct Known {
    SeenFixture seen_as;  ///< identity; never dereferenced
    std::uint64_t id;     ///< its number, from 1
    bool seen;            ///< used since begin_tick
    bool exists = true;   ///< false once it was forgotten
  };

  /// Reserves memory for so many fixtures.
  void reserve(std::size_t count);
  /// Starts a tick: removes fixtures that were not used since the last call.
  void begin_tick();
  /// Starts the tick again, as if no fixture had been used since begin_tick.
  void repeat_tick();
  /// Returns the number of a fixture, or 0 if it has none.
  std::uint64_t of(const b2Fixture& fixture);
  /// Assigns a new number to a fixture without one.
  std::uint64_t add(const b2Fixture& fixture);
  /// Returns whether there are fixtures that were not used since begin_tick and may be destroyed.
  bool misses_some() const;
  /// Returns such a fixture by its number, or null.
  Known* missed(std::uint64_t id);
  /// Removes a fixture. A new one at its address gets a new number.
  void forget(const b2Fixture& fixture);
  /// Removes all fixtures, and continues counting.
  void forget_all();
  /// Returns the fixture with that number, or null if it was not used since begin_tick.
  const b2Fixture* fixture(std::uint64_t id) const;
  /// Returns the entry of a number, or null.
  const Known* known(std::uint64_t id) const;

  /// Returns the entry of a fixture, or null.
  const Known* find(const b2Fixture& fixture) const;
  /// Returns the next new number.
  std::uint64_t next() const { return next_; }
  /// Returns the entries, by number.
  std::span<const Known> all() const { return known_; }
  /// Removes all fixtures, and continues counting from `next`.
  void clear(std::uint64_t next);
  /// Adds an entry that was saved. Its fixture exists and has no entry; its id is above those of all entries and below
  /// the next one.
  void restore(const Known& known);

 private:
  void list_places();

  std::vector<Known> known_;  // by number
  AddressTable places_;       // in known_, by the fixture's address
  std::uint64_t next_ = 1;
};

}  // namespace ribbon::box2d
