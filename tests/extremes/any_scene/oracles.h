#pragma once

#include "tests/extremes/any_scene/world.h"

namespace any_scene {

// What must never be, found from where things are at successive ticks, without the solver's help.

/// A cord and what it crosses: itself, another cord or a solid.
struct Meeting {
  int cord = 0;
  int other = 0;         ///< a cord's index, or a solid's
  bool solid = false;    ///< which of these
  bool pressed = false;  ///< of a solid: Box2D has pushed it in the tick or the one before
};

/// How deep something is in something, at its deepest.
struct Depth {
  double share = 0.0;  ///< of the contact distance
  Meeting where;
};

/// Judges a scene's snapshots; what depends on the scene alone is found once.
class Oracles {
 public:
  explicit Oracles(const Scene& scene);

  /// Pairs of a cord and another, itself or a solid that have crossed between two ticks:
  /// - lines of cords that both declare contact, or of one that declares it with itself, cross and did not before, or a
  ///   point has passed through a link; links which are close at rest are left out;
  /// - a line has come nearer to a circle's centre than half of the contact distance, deeper into a box than its radius
  ///   and a fifth of the half thickness, or to the other side of an edge; what ever holds a cord is left out.
  std::vector<Meeting> crossings(const Snapshot& before, const Snapshot& after) const;
  /// The deepest penetration as a share of the contact distance: for a cord and a solid the cord's radius and the
  /// polygon's skin, so that 1 is a line on the surface; for two cords the sum of their radii.
  Depth penetration(const Snapshot& now) const;
  /// m, the deepest overlap of any two of cords and solids, contacts declared or not; holders touch.
  double overlap(const Snapshot& now) const;

 private:
  bool meet(int a, int b) const;
  bool cords_crossed(int a, int b, const Snapshot& before, const Snapshot& after) const;
  bool solid_crossed(int cord, int solid, const Snapshot& before, const Snapshot& after) const;
  bool edge_crossed(int cord, int solid, const Snapshot& before, const Snapshot& after) const;
  double nearest(int a, int b, const Snapshot& now, double within) const;
  double depth_of(int cord, int solid, const Snapshot& now) const;

  Scene scene_;
  std::vector<std::vector<char>> near_;  // by cord: neighbours()
};

/// m, by which two solids overlap, negative where they are apart.
double overlap(const Solid& a, const Solid& b);
/// m, the same of a cord's line with its radius and a solid.
double overlap(const ribbon::CordDef& cord, const Outline& line, const Solid& solid);

}  // namespace any_scene
