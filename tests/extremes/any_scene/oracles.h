#pragma once

#include "tests/extremes/any_scene/world.h"

namespace any_scene {

// Detects forbidden states from positions at successive ticks, independent of the solver.

/// A cord and what it crosses: itself, another cord or a solid.
struct CrossedPair {
  int cord = 0;
  int other = 0;         ///< index of a cord or of a solid
  bool solid = false;    ///< whether `other` is a solid
  bool pressed = false;  ///< whether Box2D pushed the solid in this tick or the one before
};

/// The greatest depth of a penetration, and its place.
struct Depth {
  double share = 0.0;  ///< divided by the contact distance
  CrossedPair where;
};

/// Judges a scene's snapshots. The constructor computes what depends on the scene alone.
class Oracles {
 public:
  explicit Oracles(const Scene& scene);

  /// Returns the pairs of a cord and a cord (or itself) or a solid that crossed between two ticks:
  /// - Lines of cords that both declare contact, or of one that declares self-contact, cross and did not before, or a
  ///   point passed through a link. Links that are close at rest are exempt.
  /// - A line came nearer to a circle's centre than half of the contact distance, deeper into a box than its radius
  ///   and a fifth of the half thickness, or to the other side of an edge. A solid that ever holds the cord, or carries
  ///   a wheel of it, is exempt, and so are links that were at a wheel before or after the tick.
  std::vector<CrossedPair> crossings(const Snapshot& before, const Snapshot& after) const;
  /// Returns the deepest penetration divided by the contact distance. For a cord and a solid this is the cord's radius
  /// plus the polygon's skin, so that 1 is a line on the surface; for two cords it is the sum of their radii.
  Depth penetration(const Snapshot& now) const;
  /// Returns the deepest overlap of any two objects, with or without contact, m. Holders touch their cords.
  double overlap(const Snapshot& now) const;

 private:
  std::vector<CrossedPair> crossings_off_wheels(const Snapshot& before, const Snapshot& after) const;
  bool meet(int a, int b) const;
  bool is_held_by(int cord, int solid) const;
  bool were_close(int a, int i, int b, int j) const;
  bool are_tied(int a, int i, int b, int j, const Snapshot& now) const;
  bool cords_crossed(int a, int b, const Snapshot& before, const Snapshot& after) const;
  bool solid_crossed(int cord, int solid, const Snapshot& before, const Snapshot& after) const;
  bool edge_crossed(int cord, int solid, const Snapshot& before, const Snapshot& after) const;
  double nearest(int a, int b, const Snapshot& now, double within) const;
  double depth_of(int cord, int solid, const Snapshot& now) const;

  Scene scene_;
  std::vector<std::vector<char>> near_;    // by cord: the result of neighbours()
  std::vector<int> links_;                 // by cord
  std::vector<std::vector<char>> joined_;  // by cord: the same for the one that it was cut from; empty if none
};

/// Returns the overlap of two solids, m; negative if they are apart.
double overlap(const Solid& a, const Solid& b);
/// Returns the overlap of a solid and a cord's line with its radius, m.
double overlap(const ribbon::CordDef& cord, const Outline& line, const Solid& solid);

}  // namespace any_scene
