#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/contact/compliant_contacts.h"
#include "ribbon/contact/contact_sweep.h"
#include "ribbon/convex/limited_rows.h"

namespace ribbon {

/// Contacts that are linearised once: each keeps its normal, its tangent and its place along the segment, while the
/// cords are linearised again and again. So every linearisation of the cords leaves a convex problem.
class LinearisedContacts {
 public:
  /// Starts a substep, in which the contacts are not linearised yet.
  void begin_substep(const ContactScene& scene, const ContactForces& forces);
  /// Linearises the pairs that may press on the sweep's path, each where it ends, or, if the pair would pass through
  /// each other, where it touches first. A pair that has a force and is not found again stays. Returns whether other
  /// pairs are linearised than before.
  bool find(ContactScene& scene, const ContactSweep& sweep, const ContactForces& forces);
  /// Linearises, again or for the first time, the pairs that overlap on the sweep's path, or end deeper than their
  /// force explains by more than `tolerance` [m]: their rotation or slip is too large for their rows. Returns whether
  /// there are any.
  bool find_missed(ContactScene& scene, const ContactSweep& sweep, const ContactForces& forces, double tolerance);
  void clear();

  /// Appends normal forces and friction as rows that are linear about x. Friction is limited by the normal forces that
  /// were found last. A part of a step that is shorter by `shortening` has contacts that are stiffer by its square.
  void append_rows(const ContactScene& scene, const SlipReference& reference, const ContactForces& forces,
                   std::span<const Vec2> x, double shortening, LimitedRows& rows);
  /// Takes over the forces that were found, in the order of append_rows. Limits of friction follow the normal forces
  /// only if `updates_limits`, otherwise limits and forces can alternate forever.
  void take_forces(const ContactPairs& pairs, const LimitedRows& rows, bool updates_limits, ContactForces& forces);
  /// Sets all forces to 0: those of a solve that went wrong have an energy that nothing ever had.
  void forget_forces(ContactForces& forces);
  /// Stores the contacts and forces; restores them.
  void store(const ContactForces& forces);
  void restore(ContactForces& forces);

  std::span<const ActiveContact> all() const { return contacts_; }
  /// Whether the forces of the last linear solve are those of linearised contacts.
  bool has_forces() const { return has_forces_; }
  /// Stiffness of the contacts relative to that of the pairs.
  double stiffness_ratio() const { return stiffness_ratio_; }

 private:
  void find_pair(const ContactScene& scene, const ContactSweep& sweep, std::size_t k);
  template <typename Condition>
  void keep_previous(Condition&& is_kept);
  double friction_limit(const ContactPairs& pairs, std::size_t pair) const;

  std::vector<ActiveContact> contacts_;  // by pair, ascending
  std::vector<ActiveContact> previous_;  // the same, before they were found again
  std::vector<ActiveContact> stored_;
  ContactForces stored_forces_;
  std::vector<double> limiting_forces_;  // N, by pair: the normal force that limits friction
  std::vector<Vec2> positions_;          // m, by anchor; of those that are looked at
  double stiffness_ratio_ = 1.0;
  bool has_forces_ = false;
};

}  // namespace ribbon
