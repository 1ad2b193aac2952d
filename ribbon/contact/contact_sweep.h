#pragma once

#include <span>
#include <vector>

#include "ribbon/contact/contact_scene.h"
#include "ribbon/linear/index.h"

namespace ribbon {

/// How near a pair may come on a path: to this fraction of its contact distance, or, if it is nearer already, to
/// `of_start` times its distance at the start.
struct Clearance {
  double fraction;
  double of_start;

  static constexpr double of_start_in_a_move = 0.98;
  /// Of a collision-free step.
  static constexpr Clearance collision_free() { return {0.9, of_start_in_a_move}; }
  /// Nearer than this a pair has passed through each other.
  static constexpr Clearance passing() { return {0.5, of_start_in_a_move}; }
};

/// Of which pairs a contact is an impact: all, or those of a cord and a body that moves.
enum class ImpactsOf { all, moving_bodies };

/// Continuous collision detection (conservative advancement, Mirtich 1996): what touches on the straight path of all
/// anchors between two states. Fractions of the path are 0 … 1.
class ContactSweep {
 public:
  /// Reserves memory for scenes of so many anchors and slots.
  void reserve(std::size_t anchors, std::size_t slots);
  /// Sets the path from `from`, the start of the stage, to `to`, and lists the candidates for it.
  void set_path(ContactScene& scene, std::span<const Vec2> from, std::span<const Vec2> to);
  /// Returns the largest fraction of the path, at most `max`, on which the pair keeps the clearance.
  double free_fraction(const PairGeometry& pair, Clearance clearance, double max) const;
  /// Sets the positions [m] of the pair's anchors to those at this fraction of the path. Returns the separation there.
  Separation gap_at(const ContactPair& pair, double fraction, std::span<Vec2> positions) const;
  /// Returns false only if the pair is further apart than `distance` [m] at the end of the path. Cheaper than the
  /// separation there.
  bool may_end_within(const PairGeometry& pair, double distance) const;

  /// Returns the largest fraction of the path from x to `to` that is collision-free: no pair comes nearer than nine
  /// tenths of its contact distance, or, if it is nearer already, by more than two hundredths of its distance.
  /// Kinematic bodies stay, or move to their targets.
  double collision_free_fraction(ContactScene& scene, std::span<const Vec2> x, std::span<const Vec2> to,
                                 KinematicTime kinematic_end);
  /// Returns whether no pair passes through each other on the path from `from`, the start of the stage, to x. If one
  /// does, x is a solution on the other side of something.
  bool path_is_clear(ContactScene& scene, std::span<const Vec2> from, std::span<const Vec2> x);
  /// Returns the fraction of the path from x to `to`, with kinematic bodies moving to their targets, up to the first
  /// contact of a pair, or of a cord and a moving body, that would overlap later; 1 if there is none. A pair overlaps
  /// if the centre line of the cord is inside the other feature.
  double fraction_to_impact(ContactScene& scene, std::span<const Vec2> x, std::span<const Vec2> to, ImpactsOf what);
  /// Reduces the fractions by group of the path from `from`, the start of the stage, to `to` until no pair overlaps.
  /// All slots of a group move by the fraction of their group; −1 is no group. Returns false if it reduced any.
  bool separate_groups(ContactScene& scene, std::span<const Vec2> from, std::span<const Vec2> to,
                       std::span<const int> group_of, std::span<double> fractions);

 private:
  void move_groups(const ContactScene& scene, std::span<const int> group_of, std::span<const double> fractions);
  bool limit_groups(ContactScene& scene, std::span<const int> group_of, bool is_last);

  std::vector<Vec2> from_;            // m, by anchor
  std::vector<Vec2> to_;              // m, by anchor
  std::vector<Vec2> ends_;            // m, by anchor: to_ with fractions of 1
  std::vector<double> group_limits_;  // by group: the fraction of the path that it may go
};

}  // namespace ribbon
