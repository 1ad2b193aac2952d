#pragma once

#include <cstdint>

namespace ribbon {

/// Statistics of one step of an island: of cords that were solved together, or of a single cord. They are summed over
/// its substeps. A game needs only `unconverged` and, for the cost, `work`; the other counts are for diagnosis: those
/// from `searches` to `unlocked`, other than `impacts`, are 0 if full Newton steps were enough.
struct IslandReport {
  int stages = 0;        ///< implicit solves: two per substep of TR-BDF2, one per substep of implicit Euler
  int iterations = 0;    ///< Newton steps, each of which solves one linear system in O(points)
  int searches = 0;      ///< stages restarted with a line search, because full Newton steps did not converge
  int fallbacks = 0;     ///< substeps redone by implicit Euler, because a stage did not converge
  int energy_gains = 0;  ///< substeps redone, by implicit Euler or with a smaller tolerance, because the energy rose
                         ///< without a cause; not checked while drives, or what it touches, move at several velocities
  int halvings = 0;      ///< substeps of implicit Euler that did not converge and were split in two
  int impacts = 0;       ///< substeps in which a contact began or ended, integrated by implicit Euler and BDF2
  int posed = 0;     ///< steps that were taken with contacts that are linearised once (posed as one convex problem),
                     ///< because Newton steps did not converge in them or in a step shortly before
  int cuts = 0;      ///< parts of such steps in which a point was stopped to prevent penetration or an energy gain, and
                     ///< lost velocity
  int unlocked = 0;  ///< steps in which inverted cells were turned back
  int unconverged = 0;  ///< substeps that did not converge and were kept as they are
  /// Work done, in a unit that does not depend on the machine: 1 for each 2 × 2 block of the matrix of a linear system
  /// (4 per point for the band matrix of a single cord), and 1 for each pair tested for contact.
  std::int64_t work = 0;
  // The largest residuals of unconverged substeps, each by itself; 0 if all substeps converged:
  double position_error = 0.0;  ///< m, correction of a point by the last linear solve
  double force_error = 0.0;     ///< N, inertia force of that correction

  bool operator==(const IslandReport&) const = default;
  /// Adds the counts of another step and keeps the larger residuals.
  IslandReport& operator+=(const IslandReport& other);
};

/// What one step did to one cord.
struct CordReport {
  /// Index of its island in the step: cords with the same index were solved together. DirectSolver::island_reports and
  /// CordView::island_report have the report of the island.
  int island = 0;
  int contacts = 0;               ///< at the end of the step, or hit in it; one with another cord counts for both
  double max_normal_force = 0.0;  ///< N, of a contact at the end of the step
  int cuts = 0;                   ///< times that it was stopped to prevent penetration, and lost velocity
  /// m, as IslandReport::position_error, of its own points; 0 if no correction of them was above the tolerance: then
  /// only other cords of its island, or bodies, did not converge, or everything did.
  double position_error = 0.0;

  bool operator==(const CordReport&) const = default;
};

}  // namespace ribbon
