#pragma once

#include <box2d/b2_fixture.h>

#include <cstdint>
#include <vector>

namespace engine {

/// A number for each fixture that cords come near, the same from tick to tick, counted in the order of meeting them. An
/// address serves to find it again and for nothing else.
class FixtureIds {
 public:
  /// Forgets fixtures that were not asked for since the last call.
  void begin_tick();
  /// The fixture's number, a new one if it was not asked for since the tick before the last.
  std::uint64_t of(const b2Fixture& fixture);
  /// Whether some are not forgotten yet that nobody has asked for since begin_tick, and who knows whether they exist.
  bool misses_some() const;
  /// The number of a fixture of these, which exists then; 0 of any other.
  std::uint64_t find_missed(const b2Fixture& fixture);
  /// Knows a fixture no more: what is at its address gets a new number.
  void forget(const b2Fixture& fixture);
  /// The fixture of that number, null if it was neither asked for nor seen since begin_tick.
  const b2Fixture* fixture(std::uint64_t id) const;

  /// A fixture and its number.
  struct Known {
    const b2Fixture* fixture;  ///< its address, which is looked at and never through
    std::uint64_t id;          ///< its number, from 1
    bool seen;                 ///< asked for since begin_tick
    bool exists = true;        ///< as far as was told since then
  };
  /// Null for one that nobody has asked for lately. Looks at the address alone.
  const Known* find(const b2Fixture& fixture) const;
  /// The number that the next new one gets.
  std::uint64_t next() const { return next_; }
  /// Knows these and no others, which exist. Their fixtures and ids are all different, and the ids below `next`.
  void restore(std::vector<Known> known, std::uint64_t next);

 private:
  std::vector<Known>::const_iterator place(const b2Fixture& fixture) const;

  std::vector<Known> known_;  // by address
  std::uint64_t next_ = 1;
};

}  // namespace engine
