#pragma once

#include <span>

#include "ribbon/island_cord.h"
#include "ribbon/system/cord_parts.h"
#include "ribbon/system/tie_groups.h"

namespace ribbon {

/// A grip that may become a ring, see island/rings.h. The wheel of the ring takes up a point of the rope, and runs from
/// the point before that one to the point behind it.
struct RingCandidate {
  const IslandCord& cord;
  const CordParts& parts;
  std::size_t index;          ///< of the grip, in the surroundings of the cord
  int taken_up = 0;           ///< the point
  Vec2 anchor{};              ///< m
  Vec2 velocity{};            ///< m/s, of the anchor
  double lead = 0.0;          ///< m, at rest, from the point before to the anchor
  double trail = 0.0;         ///< m, from the anchor to the point behind
  double speed = 0.0;         ///< m/s, at which the rope runs through the anchor, towards its end
  double runs = 0.0;          ///< sign of the direction in which the rope runs, or will: 1 towards its end
  double slides = 0.0;        ///< links, in the step
  bool is_sliding = false;    ///< it has slid in the last step, or begins to
  bool is_in_bend = false;    ///< it is at a point, at which the rope bends
  bool is_near_bend = false;  ///< it is in a bend, or may come to one in the step

  /// Makes the candidate of a grip, for a step of dt seconds. The rope has three points or more.
  RingCandidate(const IslandCord& of_cord, std::size_t grip, const RigidBody& body, double dt);

  /// Makes it slide. The rope begins to run with this sign: 1 towards its end.
  void begin(double runs);

  const Grip& grip() const { return cord.surroundings.grips[index]; }
  /// Points on each side of the one taken up that may get near the anchor in the step.
  int reach() const;
  /// The mean rest length of the links beside the point, m.
  double link() const { return 0.5 * (lead + trail); }
  Vec2 before() const { return parts.state.positions[static_cast<std::size_t>(taken_up) - 1]; }
  Vec2 after() const { return parts.state.positions[static_cast<std::size_t>(taken_up) + 1]; }
  /// N, by which the rope is pulled towards its end: the difference of the tensions beside the point.
  double pulled() const;

  /// Returns whether a wheel can be there, on the member with this index: the rope runs through the anchor, not near an
  /// end off which the hand would slide, and nothing else holds the point or its links.
  bool has_place(std::span<const TiedPoint> tied, std::size_t member) const;
  /// Returns whether nothing can touch the rope near the anchor in the step of dt seconds: on a wheel it touches
  /// nothing.
  bool is_alone(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt) const;
  /// Returns the wheel.
  Pulley wheel() const;
};

/// Returns the mass of a link, kg.
double link_mass(const CordDef& def);
/// Returns whether grips of a cord can become rings: of a rope without bending stiffness that does not touch itself, is
/// not reeled, has three points or more and no pulleys.
bool may_have_rings(const CordParts& cord);
/// Returns whether a grip may slip along such a rope, and its body is so heavy that the rope follows it.
bool may_become_ring(const CordParts& cord, const Grip& grip, const RigidBody& body);

}  // namespace ribbon
