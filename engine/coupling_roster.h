#pragma once

#include <box2d/box2d.h>

#include <cstddef>
#include <span>
#include <vector>

namespace engine {

/// The bodies and fixtures that a world had when it was last recorded, in its own order: they tell a body or fixture
/// that is still there from one that was made since at the same address. Box2D puts a new body at the head of its
/// world's list, a new fixture at the head of its body's, and moves none; so what is still there is the tail of the
/// list, in the recorded order, and all before that is new.
///
/// What is called new is new. What is new at the address of one that is gone is not recognised where the order of the
/// list is as before: where the newest body of a world, or the newest fixture of a body, is replaced by another one.
/// Recorded addresses are compared, and never looked through.
class WorldRoster {
 public:
  /// Takes the memory for so many bodies, and as many fixtures.
  void reserve(std::size_t bodies);
  /// Records the world as it is. O(bodies + fixtures).
  void record(const b2World& world);
  /// The first body of the world's list that was recorded; null if none is left. All that follow it were, too.
  const b2Body* first_kept(const b2World& world) const;
  /// Whether a body was recorded at this address and is kept. O(bodies).
  bool keeps(const b2World& world, const b2Body* body) const;
  /// Whether a fixture of a body that is kept was recorded at this address, and is kept. O(bodies).
  bool keeps(const b2Body& body, const b2Fixture* fixture) const;

 private:
  std::vector<const b2Body*> bodies_;        // by the world's order, newest first
  std::vector<std::size_t> first_fixtures_;  // of each, and the end of the last one's
  std::vector<const b2Fixture*> fixtures_;   // by body, newest first
};

}  // namespace engine
