#pragma once

#include <box2d/b2_fixture.h>

#include <cstdint>
#include <vector>

#include "ribbon/box2d/address_table.h"
#include "ribbon/box2d/still_there.h"

namespace engine {

/// A number for each fixture that cords come near, the same from tick to tick, counted in the order of meeting them. An
/// address serves to find it again and for nothing else.
class FixtureIds {
 public:
  /// A fixture and its number.
  struct Known {
    SeenFixture seen_as;  ///< looked at and never through
    std::uint64_t id;     ///< its number, from 1
    bool seen;            ///< asked for since begin_tick
    bool exists = true;   ///< as far as was told since then
  };

  /// Takes the memory for so many fixtures.
  void reserve(std::size_t count);
  /// Forgets fixtures that were not asked for since the last call.
  void begin_tick();
  /// The fixture's number; 0 if it was not asked for since the tick before the last.
  std::uint64_t of(const b2Fixture& fixture);
  /// A new number for one that has none.
  std::uint64_t add(const b2Fixture& fixture);
  /// Whether some are not forgotten yet that were not asked for since begin_tick, and may exist or not.
  bool misses_some() const;
  /// One of these by its number; null for any other.
  Known* missed(std::uint64_t id);
  /// Knows a fixture no more: what is at its address gets a new number.
  void forget(const b2Fixture& fixture);
  /// Knows none any more, and counts on.
  void forget_all();
  /// The fixture of that number, null if it was neither asked for nor seen since begin_tick.
  const b2Fixture* fixture(std::uint64_t id) const;
  /// What is known of the number; null if nothing is.
  const Known* known(std::uint64_t id) const;

  /// Null for one that was not asked for lately.
  const Known* find(const b2Fixture& fixture) const;
  /// The number that the next new one gets.
  std::uint64_t next() const { return next_; }
  /// Knows these and no others, which exist. Their fixtures and ids are all different, the ids rise and are below
  /// `next`.
  void restore(std::vector<Known> known, std::uint64_t next);

 private:
  void list_places();

  std::vector<Known> known_;  // by number
  AddressTable places_;       // in known_, by the fixture's address
  std::uint64_t next_ = 1;
};

}  // namespace engine
