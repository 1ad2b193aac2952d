#pragma once

#include <box2d/box2d.h>

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "ribbon/box2d/body_finder.h"
#include "ribbon/box2d/body_identity.h"
#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/slip_place.h"

namespace ribbon::box2d {

/// A grip and the body that holds.
struct BodyGrip : GripMemory {
  b2Body* body = nullptr;
  SeenBody seen;
  bool drives_point = false;  // in the last step: its body is static or kinematic, and it holds a point
  bool slipped_off = false;   // in the last step, off an end of its cord

  bool may_slip() const { return strength < std::numeric_limits<double>::infinity(); }
};

/// Moves a grip to a column of its cord, 0 … columns − 1, at the same row: to the nearest end if the column is beyond
/// it, and nowhere if it is not a number. Within 1e-9 of a point it is at the point.
void set_column(GripMemory& grip, double column, int columns, int rows);

/// Throws DefinitionError unless `arc` is on a cord of the direct solver, 0 … its length [m].
void check_arc(const CoupledCord& cord, double arc);

/// All grips of a coupling, ordered by id.
class GripTable {
 public:
  /// Returns a grip as `def` describes it, with the next id. Throws CallError or DefinitionError as Coupling::hold
  /// does.
  BodyGrip make(b2Body& body, const GripDef& def, const CoupledCord& cord) const;
  /// Adds a grip that make returned.
  GripId add(const BodyGrip& grip);
  /// Removes the grip with that id, which exists.
  void remove(GripId id);
  /// Returns a grip, or null if there is none with that id.
  BodyGrip* find(GripId id);
  const BodyGrip* find(GripId id) const;
  /// Returns a grip. Throws CallError if there is none with that id.
  BodyGrip& at(GripId id);
  const BodyGrip& at(GripId id) const;
  /// Returns the first grip of a body, or null.
  const BodyGrip* first_of(const b2Body& body) const;
  /// Returns how far a gathered cord may draw a body, by its index in the step, in a tick of dt seconds, m; 0 unless
  /// Box2D has stopped the body more than 5 cm off the cord.
  double reach_of_kept_off(const CoupledCord& cord, int body, double dt) const;
  /// Returns whether there is a grip of a body that is not this one but had its address.
  bool has_predecessor(const b2Body& body) const;
  /// Returns the grips, by id.
  std::span<const BodyGrip> all() const { return grips_; }

  /// Removes the grips of a body.
  void forget(const b2Body& body);
  /// Removes the grips of bodies that no longer exist. O(bodies) if there is a grip.
  void forget_gone(BodyFinder& finder);
  /// Removes the grips of bodies that cannot hold: disabled ones and those with values out of range.
  void drop_unable();

  /// Passes each grip of a body that cords can meet to its cord, for a step of dt seconds. `index_of` returns the index
  /// of a body in the step.
  void gather(CordTable& cords, double dt, const std::function<int(b2Body&)>& index_of);
  /// Reads the forces and positions of the grips after a step, under `gravity` [m/s²].
  void follow(const CordTable& cords, Vec2 gravity);

  /// Returns the id of the next grip to be added.
  GripId next() const { return next_; }
  /// Removes all grips.
  void clear(GripId next);
  /// Adds a grip that was saved.
  void restore(const GripMemory& memory, b2Body& body);

 private:
  bool stops_at(const CoupledCord& cord, int point, GripId grip) const;
  SlipPlace place_of(BodyGrip& grip, const CoupledCord& cord, Vec2 hand) const;

  std::vector<BodyGrip> grips_;
  GripId next_ = 1;
};

/// Returns the position of a grip along its cord, columns.
double column_of(const GripMemory& grip, const CoupledCord& cord);

}  // namespace ribbon::box2d
