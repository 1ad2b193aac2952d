#pragma once

#include <box2d/b2_body.h>

#include <cstddef>
#include <limits>
#include <vector>

#include "ribbon/box2d/address_table.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/velocity_carry.h"
#include "ribbon/rigid_circle.h"

namespace ribbon::box2d {

/// A body that cords may touch in a tick, or that holds one.
struct TickBody {
  b2Body* body;             // null once it was forgotten
  CordId thesis_cord = -1;  // the last cord of the thesis's solver that it is near or holds
  bool holds = false;       // it holds a cord or carries a wheel
  /// m/s, with which a tick may press it on its supports; see append_supports.
  double max_push = std::numeric_limits<double>::infinity();
};

/// The bodies of a tick: Box2D's and the solver's view of each, at the same index.
class TickBodies {
 public:
  void reserve(std::size_t bodies);
  void clear();
  /// Returns the index of a body, which is added if it is new.
  int index_of(b2Body& body, VelocityCarry& carry, const StepConditions& conditions);
  /// Returns the body with an address, or null if it is not one of this tick.
  const b2Body* find(const b2Body* address) const;
  /// Forgets a body that is about to be destroyed.
  void forget(const b2Body& body);

  std::vector<TickBody> entries;
  std::vector<RigidBody> rigid;

 private:
  AddressTable places_;
};

}  // namespace ribbon::box2d
