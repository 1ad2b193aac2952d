#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/vec2.h"

namespace engine {

/// A part of a fixture that a cord may reach: an edge of a chain, and of any other shape all of it.
struct NearShape {
  b2Fixture* fixture;        ///< of an enabled body, no sensor
  int child;                 ///< of its shape
  double way;                ///< m, that it may go in the tick, and more
  std::uint64_t number = 0;  ///< the fixture's: FixtureIds
};

/// Where a cord looks, and what it meets.
struct Look {
  ribbon::Box reach;     ///< m, of the cord in the tick
  b2Filter filter;       ///< as between two Box2D fixtures
  bool circles = false;  ///< alone are met, as a cord of the thesis's does
  ribbon::Vec2 gravity;  ///< m/s²
  double dt = 0.0;       ///< s
};

/// Whether the numbers of a body are such that a cord can meet it.
bool is_sound(const b2Body& body);
/// Whether they are, and it is no dynamic body without mass.
bool can_be_met(const b2Body& body);

/// Finds what a cord may reach in a tick, by the broad phase of a world, in no order: what is static where it is, the
/// rest on its way. Box2D takes a body no further than b2_maxTranslation in a tick, so what is further off than that,
/// though it turn, is left for the next. What the tree of the broad phase has near is looked at; what it has further
/// off matters only if it is fast, and may be listed and looked at later, or found by going through all that moves.
class NearSearch {
 public:
  /// Adds to `near`. Null for `further`: nothing further off is listed.
  NearSearch(const b2World& world, const Look& look, std::vector<NearShape>& near, std::vector<int>* further);

  /// Looks at all that is near, and lists the proxies of what is further off.
  void look_around();
  /// Looks at one of these.
  void look_at(int proxy);
  /// Looks at a child of a fixture of a body that moves, wherever it is.
  void look_at(b2Fixture& fixture, int child);

  /// Whether a body moves, so that it may be near though the tree has it further off: in a box that it need not leave
  /// where it goes on.
  static bool moves(const b2Body& body);
  /// m, around a child of a fixture, and the way that it may go in a tick of dt seconds; empty if it has numbers that
  /// no cord can meet.
  static ribbon::Box way_box(const b2Fixture& fixture, int child, ribbon::Vec2 gravity, double dt);

 private:
  void take_leaf(int proxy);
  void look_at(b2Fixture& fixture, int child, const b2AABB& box);
  static double way_of(const b2Body& body, const ribbon::Box& box, ribbon::Vec2 gravity, double dt);

  const b2BroadPhase* broad_phase_;
  const Look* look_;
  std::vector<NearShape>* near_;
  std::vector<int>* further_;
  double most_way_;  // m, of a part of a body in the tick
  b2AABB still_;     // in which the cord may reach what does not move
};

}  // namespace engine
