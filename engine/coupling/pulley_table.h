#pragma once

#include <box2d/box2d.h>

#include <functional>
#include <span>
#include <vector>

#include "ribbon/box2d/body_finder.h"
#include "ribbon/box2d/body_identity.h"
#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"

namespace ribbon::box2d {

/// A pulley and the body that carries its wheel.
struct BodyPulley : PulleyMemory {
  b2Body* body = nullptr;
  SeenBody seen;
};

/// All pulleys of a coupling, ordered by id.
class PulleyTable {
 public:
  /// Lays a cord around a wheel that a body carries. Throws as Coupling::add_pulley does.
  PulleyId add(CoupledCord& cord, b2Body& body, const PulleyDef& def);
  /// Takes the cord off the wheel of the pulley with that id, which exists.
  void remove(PulleyId id, CordTable& cords);
  /// Removes the pulleys of a cord that is about to be removed or disabled.
  void remove_all(CoupledCord& cord);
  /// Returns a pulley, or null if there is none with that id.
  const BodyPulley* find(PulleyId id) const;
  /// Returns a pulley. Throws CallError if there is none with that id.
  const BodyPulley& at(PulleyId id) const;
  /// Returns the pulleys, by id.
  std::span<const BodyPulley> all() const { return pulleys_; }

  /// Removes the pulleys of a body.
  void forget(const b2Body& body, CordTable& cords);
  /// Removes the pulleys of bodies that no longer exist, unless `trusts_forget`, and of those that cannot carry one:
  /// disabled ones and those with values out of range. O(bodies) if there is a pulley.
  void drop_unable(BodyFinder& finder, bool trusts_forget, CordTable& cords);
  /// Gives the axles to the cords of a step. `index_of` returns the index of a body in the step.
  void gather(CordTable& cords, const std::function<int(b2Body&)>& index_of) const;
  /// Moves the pulleys of a cord to its pieces. `wholly_on` returns the piece that has a pulley, or null.
  void follow_cut(CoupledCord& whole, const std::function<CoupledCord*(const Pulley&)>& piece_of);

  /// Returns the id of the next pulley to be added.
  PulleyId next() const { return next_; }
  /// Removes all pulleys, but not from their cords.
  void clear(PulleyId next);
  /// Adds a pulley that was saved. Its cord has it.
  void restore(const PulleyMemory& memory, b2Body& body);

 private:
  template <typename Condition>
  void remove_if(CordTable& cords, Condition&& condition);

  std::vector<BodyPulley> pulleys_;
  PulleyId next_ = 1;
};

}  // namespace ribbon::box2d
