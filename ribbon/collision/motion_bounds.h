#pragma once

#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/linear/reserve_more.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// How far points and bodies may move from the straight line of their free motion in a step. Contacts are looked for
/// within these bounds. A step in which something leaves its bound is redone with a larger one.
class MotionBounds {
 public:
  /// Returns the bound of a cord that nothing hits hard, m: a quarter of a link, twice the fall, 0.3 of its own
  /// displacement, that by its loads (at most a link), that of the fastest body near it, and what overstretched links
  /// regain.
  static double bound_of(const CordParts& cord, const Surroundings& surroundings, std::span<const RigidBody> bodies,
                         double dt, Vec2 gravity);

  /// Begins the first attempt at a step.
  void begin_step(std::size_t members);
  /// Enlarges all bounds for a step whose contacts are linearised once, because that is expensive to redo. In it a cord
  /// that becomes taut, or the body that holds it, may stop.
  void enlarge_for_linearised();
  /// Finds the bounds and the ends of the free motion at the start of an attempt.
  void find(const IslandState& state);
  /// Without contacts there is nothing to bound.
  void disable() { enabled_ = false; }
  bool enabled() const { return enabled_; }
  /// Stores where points and bodies are at the start of the attempt.
  void store_start(const IslandState& state) {
    reserve_more(start_, state.positions.size());
    start_ = state.positions;
  }

  /// Returns the bound of the points of a member, m.
  double of(std::size_t member) const { return bounds_[member].all; }
  /// Returns how much the displacements of two points near each other along the outline may differ, m.
  double near_of(std::size_t member) const { return bounds_[member].near; }
  /// Returns where the points are at the end of their free motion, m.
  std::span<const Vec2> ends() const { return ends_; }
  /// Returns a box in which an anchor of a body stays in the step.
  Box anchor_box(const IslandState& state, const RigidBody& body, Vec2 arm) const;

  /// After an attempt: enlarges the bounds that something left, as far as it went. Returns false if nothing did, or the
  /// bounds are as large as they get.
  bool enlarge(const IslandState& state);
  /// Reduces `shares` [0 … 1], by group, of the displacement since `from`, so that no slot leaves its bound. Returns
  /// false if one was reduced.
  bool limit(const IslandState& state, std::span<const Vec2> from, std::span<const int> groups,
             std::span<double> shares) const;

 private:
  struct Bound {
    double all = 0.0;   // m
    double near = 0.0;  // m
    double enlargement = 1.0;
    double near_enlargement = 1.0;
  };
  double excess_of_bodies(const IslandState& state) const;
  double excess(const IslandState& state, std::size_t member) const;
  double near_excess(const IslandState& state, std::size_t member) const;
  bool may_have_touched(const IslandState& state, const Member& member, int k, int link) const;
  double share_within(Vec2 from, Vec2 to, Vec2 start, Vec2 end, double bound) const;

  bool enabled_ = false;
  bool may_stop_ = false;      // what moves as fast as anything in its cord
  std::vector<Bound> bounds_;  // by member
  double body_bound_ = 0.0;    // m
  std::vector<Vec2> start_;
  std::vector<Vec2> ends_;
};

}  // namespace ribbon
