#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/contact/active_contacts.h"
#include "ribbon/contact/compliant_contacts.h"
#include "ribbon/contact/contact_scene.h"
#include "ribbon/contact/contact_sweep.h"
#include "ribbon/contact/impacts.h"
#include "ribbon/contact/linearised_contacts.h"
#include "ribbon/convex/limited_rows.h"

namespace ribbon {

/// The contacts of cords that are solved together: its parts, and what takes several of them. x is a state by slot of
/// points and bodies.
struct Contacts {
  ContactScene scene;
  ActiveContacts active;
  ContactSweep sweep;
  SlipReference slip_reference;
  ContactForces forces;
  CompliantContacts compliant;
  LinearisedContacts linearised;
  Impacts impacts;

  /// Removes all pairs and body anchors; the cords have so many points.
  void clear(std::size_t points);
  bool empty() const { return scene.pairs.empty(); }
  /// Starts a substep at x that ends at this fraction of the step, 0 … 1: slip is measured from x, and so much of the
  /// initial penetrations is removed.
  void begin_substep(std::span<const Vec2> x, double fraction);
  /// Returns whether other pairs are in contact at x than at the start of the substep.
  bool changed_at(std::span<const Vec2> x);
  /// Stores forces and impulses, and the elongations of friction springs at x, with the pairs.
  void store(std::span<const Vec2> x);
  /// Returns the elastic energy of the contacts, J, in the state that was evaluated last.
  double energy() const;
  /// Returns the elastic energy by the forces that were found last, J; at the start of a substep by the stored ones.
  double energy_of_forces() const;
  /// Adds the impulses of the contact forces at x, which act for `duration` [s].
  void record_impacts(std::span<const Vec2> x, double duration);

  // Newton steps:

  /// Finds the contacts for a linear solve at x. A pair that had a force in the last one remains in contact if it is a
  /// little apart, because on a curved path a step leaves what it should stay on. `strict` takes contacts and friction
  /// as they are at x.
  void find_for_solve(std::span<const Vec2> x, bool strict);
  /// Adds forces and the positive semidefinite part of the Hessian at x, where the contacts were found for it.
  void load(std::span<const Vec2> x, BlockLdlt& matrix, std::span<Vec2> force);
  /// Takes over the solution of the linear system.
  void take_solution(std::span<const Vec2> step);
  /// Returns the potential at x, J, with friction limited by the normal forces of the last linear solve.
  double potential(std::span<const Vec2> x);
  /// Returns whether the forces at x agree with those of the last linear solve, see CompliantContacts::are_settled.
  bool are_settled(std::span<const Vec2> x, double tolerance);

  // Restitution, see Impacts:

  bool begin_restitution(std::span<const Vec2> x, const ImpactVelocities& velocities, double dt) {
    return impacts.find_restitution(scene, x, velocities, dt, active);
  }
  /// Takes over the solution of the linear system, and ends the restitution.
  void end_restitution(std::span<const Vec2> x, const std::vector<Vec2>* step);

  // Contacts that are linearised once, see LinearisedContacts. The path is that from `from`, the start of the stage, to
  // `to`:

  bool linearise(std::span<const Vec2> from, std::span<const Vec2> to);
  bool linearise_missed(std::span<const Vec2> from, std::span<const Vec2> to, double tolerance);
  void append_rows(std::span<const Vec2> x, double shortening, LimitedRows& rows);
  void take_forces(const LimitedRows& rows, bool updates_limits);

 private:
  ContactState state(std::span<const Vec2> x) const { return {scene, active, slip_reference, x}; }
  void store_impacts();
  void set_path(std::span<const Vec2> from, std::span<const Vec2> to);
};

}  // namespace ribbon
