#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/elastic/link.h"
#include "ribbon/elastic/stage.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

/// A link that a Newton step of a chain has eliminated: its tension and the step δa of its far end follow from the step
/// δb of its near end,
///
///     λ = tension + slope·δb,     δa = shift + matrix·δb.
struct EliminatedLink {
  double tension;
  Vec2 slope;
  Vec2 shift;
  Vec2 matrix_x;  ///< first row
  Vec2 matrix_y;  ///< second row
};

/// Receives the slot of a point.
using PointCallback = std::function<void(int)>;

/// The elastic energy of a cord, and the solver of its Newton step. Spans of points are indexed by point, spans of
/// tensions by tension.
class Elasticity {
 public:
  Elasticity() = default;
  Elasticity(const Elasticity&) = delete;
  Elasticity& operator=(const Elasticity&) = delete;
  virtual ~Elasticity() = default;

  /// Returns the number of tensions, which are unknowns of mixed Newton.
  virtual std::size_t tension_count() const = 0;
  /// Returns the number of its terms. The tensions of one follow those of the one before it.
  virtual std::size_t terms() const { return 1; }
  /// Returns the number of tensions of a term. They are ordered by column, and each column but the last has as many.
  virtual std::size_t tension_count(std::size_t /*term*/) const { return tension_count(); }

  /// Sets the rest length [m] of each link along the cord: columns − 1 values.
  virtual void set_rest_lengths(std::span<const double> lengths) = 0;

  /// Leaves out the links [by link] for which 1 is given: they exert no force, and keep the tensions that they have. An
  /// empty list leaves out none.
  virtual void leave_out(std::span<const char> /*links*/) {}

  /// Writes the static tensions [N, of cells J] at positions x [m]; 0 for inextensible bars.
  virtual void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const = 0;

  /// Adds `sign` times the damping part of the tensions, β·ċ/α, at these velocities.
  virtual void add_damping(const Motion& motion, double sign, std::span<double> tensions) const = 0;

  /// Adds the damping tension of rotational_extension_rate, which the solve of implicit Euler leaves out. So the
  /// tensions fit the velocities at the end of any stage.
  virtual void add_rotational_damping(const Stage& stage, std::span<const Vec2> x,
                                      std::span<double> tensions) const = 0;

  /// Computes one step of mixed Newton from positions x and the tensions of the last iteration. Writes the
  /// displacements of the points to `direction` [m] and the tensions after a full step to `next`. Returns false if the
  /// system is singular. `eliminated` is memory of one entry for each tension. It belongs to the solver and not to the
  /// cord, so that it stays in the cache from cord to cord. Cost: O(points).
  virtual bool newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                           std::span<Vec2> direction, std::span<double> next, std::span<EliminatedLink> eliminated) = 0;

  // The same step in a coupled solve. The slots of the points start at `first`, in sequence, and those of the tensions
  // that stay unknowns at `first_dual`.

  /// Returns the number of tensions that stay unknowns.
  virtual std::size_t dual_count() const { return 0; }
  /// Appends the slots in an order of elimination, and calls on_point(slot) after each point.
  virtual void order(int first, int first_dual, std::vector<int>& slots, const PointCallback& on_point) const = 0;
  /// Adds the couplings to the pattern.
  virtual void couple(BlockLdlt& blocks, int first, int first_dual) const = 0;
  /// Adds the matrix, inertia included, and writes the right-hand side by slot. The caller holds constrained points.
  virtual void load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks,
                    int first, int first_dual, std::span<Vec2> right_side) = 0;
  /// Writes the tensions after the step that solves the system: `direction` by point [m], `duals` by dual slot.
  virtual void update(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                      std::span<const Vec2> direction, std::span<const Vec2> duals, std::span<double> next) = 0;

  /// Appends the bars that cannot push, for Stage::bars_are_rows, in the order of their tensions.
  virtual void append_bars(const Stage& /*stage*/, std::span<const Vec2> /*x*/, std::span<const double> /*tensions*/,
                           std::vector<OneSidedBar>& /*bars*/) {}

  /// Returns how far the last step moved points wrongly [m], because it took a bar that cannot push for slack or taut
  /// and the bar is not. A short Newton step is near the solution only if this is small too.
  virtual double active_set_error(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) = 0;

  /// Returns the part of the minimised function of a stage [J] that is not inertia or a constant force: elastic energy
  /// and dissipation potential. An element with a tension counts as its exact_penalty of the slope `max_tensions`.
  virtual double potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> max_tensions) = 0;

  /// Returns the elastic energy [J]. Elements with a tension compute it from that tension, less its damping part at the
  /// velocities of `motion`, if it has any.
  virtual double energy(const Motion& motion, std::span<const double> tensions) const = 0;

  /// Returns the elastic force on a point with the damping force at the velocities of `motion`, N. The tensions include
  /// their damping part, if `motion` has velocities. O(tensions).
  virtual Vec2 force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const = 0;

  /// Returns the force with which all elements of a ribbon between column `link` and the next one pull at the former,
  /// N, with the damping force as in force_on; 0 for a rope, whose links have tensions. O(rows).
  virtual Vec2 section_force(std::size_t /*link*/, const Motion& /*motion*/,
                             std::span<const double> /*tensions*/) const {
    return {};
  }
  /// Starts to fetch from memory what each Newton step reads. It changes nothing but the speed.
  virtual void fetch() const {}
  /// Becomes the elastic energy of another cord in the same memory, if it can. Returns whether it has.
  virtual bool become(const CordDef& /*def*/) { return false; }

  /// Finds inverted cells at the start of a step, and gives them an energy that turns them back during this step.
  /// Returns whether there are any.
  virtual bool unlock(std::span<const Vec2> /*x*/) { return false; }
  /// Returns 1 for each cell that is being turned back, 0 for others: state from step to step. Empty without such
  /// cells.
  virtual std::span<char> unlocked() { return {}; }
  /// Takes unlock() back: the cells keep their own energy in this step.
  virtual void lock() {}
  /// Returns whether a cell is inverted so deeply that it may not turn back by itself.
  virtual bool has_deep_inversion(std::span<const Vec2> /*x*/) const { return false; }
};

}  // namespace ribbon
