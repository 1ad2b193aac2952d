#pragma once

#include <box2d/b2_world.h>

#include <cstddef>

#include "ribbon/box2d/address_table.h"
#include "ribbon/box2d/body_identity.h"

namespace ribbon::box2d {

/// Finds out whether bodies that were seen earlier still exist. Their memory is read only if they do.
class BodyFinder {
 public:
  /// Sets the world to search. Returns whether it is another one than before.
  bool enter(const b2World& world);
  /// Returns whether that world is inside its Step.
  bool is_locked() const { return world_ != nullptr && world_->IsLocked(); }
  /// With true, every body that was not forgotten exists, and the world need not be searched.
  void trust_forget(bool trusted) { trusts_forget_ = trusted; }
  bool trusts_forget() const { return trusts_forget_; }
  /// Returns whether one body still exists. O(bodies), or O(1) with trust_forget.
  bool exists(const SeenBody& seen) const;

  // To find out about several bodies in one walk through the list of the world:
  void reserve(std::size_t bodies) { wanted_.reserve(bodies); }
  /// Forgets the wanted bodies of the last search.
  void clear() { wanted_.clear(); }
  /// Adds a body to the search.
  void want(const b2Body* address) { wanted_.set(address, wanted); }
  /// Marks a body as found without a search.
  void take_as_found(const b2Body* address) { wanted_.set(address, found); }
  /// Walks through all bodies of the world.
  void search();
  /// Returns whether a wanted body was found, and is not a new one at the same address.
  bool was_found(const SeenBody& seen) const { return wanted_.find(seen.body) == found && seen.is(*seen.body); }

 private:
  static constexpr int wanted = 0;
  static constexpr int found = 1;

  const b2World* world_ = nullptr;
  bool trusts_forget_ = false;
  AddressTable wanted_;
};

/// Returns the fixture that was seen, or null if it is no longer on a body of the list that begins with `newest`.
/// O(bodies + fixtures of its body).
b2Fixture* find_fixture(b2Body* newest, const SeenFixture& seen);

}  // namespace ribbon::box2d
