#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/geometry/separation.h"
#include "ribbon/touch.h"

namespace ribbon {

/// A disc and a segment that may touch in a step, and the data of their contact. `disc`, `a` and `b` are anchors.
struct ContactPair {
  /// Stiffness of friction as a fraction of that of the contact.
  static constexpr double friction_stiffness_ratio = 0.1;
  /// Share of the contact distance; nearer, disc and segment coincide: neither is at a side of the other.
  static constexpr double coincident_share = 1e-6;

  int disc = 0;
  int a = 0;
  int b = 0;
  int previous = -1;       ///< the anchor before a in the polyline that the segment is part of; −1 if a is its end
  int next = -1;           ///< the anchor behind b; −1 if b is its end
  bool owns_ends = true;   ///< false if other pairs represent the ends of the segment
  bool is_mutual = false;  ///< the disc is a point with links of its own: one of two vertices counts
  double contact_distance = 0.0;     ///< m, sum of the radii
  double initial_penetration = 0.0;  ///< m, penetration that no contact force explains; removed evenly in the step
  double disc_radius = 0.0;          ///< m
  double stiffness = 0.0;            ///< k, N/m
  double friction = 0.0;             ///< μ
  double restitution = 0.0;          ///< e
  double tangent_speed = 0.0;        ///< m/s, of the other surface; see RigidCircle
  Vec2 parting;          ///< unit vector along which the disc leaves a segment that it coincides with, or zero
  std::size_t cord = 0;  ///< index of the cord that stores the contact
  Touch touch;           ///< the contact as it is stored from step to step

  /// N/m.
  double friction_stiffness() const { return friction_stiffness_ratio * stiffness; }
};

/// What a pass over many pairs reads of each.
struct PairGeometry {
  int disc, a, b;
  bool is_mutual;              // as in ContactPair
  double contact_distance;     // m
  double initial_penetration;  // m
  double overlap_fraction;     // of contact_distance: nearer, and the centre line of the cord is inside the other
};

/// All pairs of a step.
class ContactPairs {
 public:
  void clear();
  /// Adds a pair. `cord_radius` is the radius of its cord, m.
  void add(const ContactPair& pair, double cord_radius);

  bool empty() const { return pairs_.empty(); }
  std::size_t size() const { return pairs_.size(); }
  /// Returns the number of pairs that fit into memory without an allocation.
  std::size_t capacity() const { return pairs_.capacity(); }
  std::span<ContactPair> all() { return pairs_; }
  std::span<const ContactPair> all() const { return pairs_; }
  ContactPair& operator[](std::size_t k) { return pairs_[k]; }
  const ContactPair& operator[](std::size_t k) const { return pairs_[k]; }
  std::span<const PairGeometry> geometries() const { return geometries_; }
  const PairGeometry& geometry(std::size_t k) const { return geometries_[k]; }
  /// Indices of the pairs whose stored force or friction is not 0, ascending: few of all.
  std::span<const std::size_t> pressed() const { return pressed_; }
  /// Call these when stored forces have changed.
  void clear_pressed() { pressed_.clear(); }
  void add_pressed(std::size_t k) { pressed_.push_back(k); }
  /// Returns the least contact distance of all pairs, m; 0 if there is none.
  double min_contact_distance() const;

  /// Sets the fraction of the initial penetrations that is removed by now, 0 … 1.
  void set_depenetration(double fraction) { depenetration_fraction_ = fraction; }
  /// Returns the distance below which a pair is in contact now, m.
  double active_distance(const PairGeometry& pair) const {
    return pair.contact_distance - (1.0 - depenetration_fraction_) * pair.initial_penetration;
  }
  /// Returns the depth of penetration, m.
  double depth(std::size_t k, const Separation& gap) const { return active_distance(geometries_[k]) - gap.distance; }

 private:
  std::vector<ContactPair> pairs_;
  std::vector<PairGeometry> geometries_;
  std::vector<std::size_t> pressed_;
  double depenetration_fraction_ = 0.0;
};

/// Assigns the value to each pair. Memory grows as seldom as that of the pairs: assign alone would allocate for each
/// additional pair.
template <typename T>
void assign_by_pair(std::vector<T>& values, const ContactPairs& pairs, T value) {
  values.reserve(pairs.capacity());
  values.assign(pairs.size(), value);
}

/// Returns the separation of the pair's disc at o from its segment from a to b, m. If they coincide and the pair has a
/// direction in which they part, it is the normal.
Separation separation_of(const ContactPair& pair, Vec2 o, Vec2 a, Vec2 b);
/// Returns whether the distance has a local minimum at this pair of the polyline that the segment belongs to. At a
/// vertex only one pair is the minimum: that of the segment before it. `positions` are those of the anchors, m.
bool is_local_minimum(const ContactPair& pair, const Separation& gap, std::span<const Vec2> positions);

}  // namespace ribbon
