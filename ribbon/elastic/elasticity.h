#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ribbon/elastic/stage.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

using PointDone = std::function<void(int)>;

/// The elastic terms of a cord, and the solve of their Newton step.
class Elasticity {
 public:
  Elasticity() = default;
  Elasticity(const Elasticity&) = delete;
  Elasticity& operator=(const Elasticity&) = delete;
  virtual ~Elasticity() = default;

  /// How many tensions are unknowns of their own.
  virtual std::size_t tension_count() const = 0;

  /// The rest length [m] of each link along the cord: points − 1 of them.
  virtual void set_rest_lengths(std::span<const double> lengths) = 0;

  /// Tensions of these positions at rest; 0 of what does not stretch.
  virtual void find_tensions(std::span<const Vec2> x, std::span<double> tensions) const = 0;

  /// Adds `sign` times what damping is of the tensions, β·ċ/α, at these velocities.
  virtual void add_damping(const Motion& at, double sign, std::span<double> tensions) const = 0;

  /// Adds what damping is at the velocities that implicit Euler ends with, beyond what it was in the solve, see
  /// `turning_rate`: so that tensions and velocities belong together after any stage.
  virtual void add_turning(const Stage& stage, std::span<const Vec2> x, std::span<double> tensions) const = 0;

  /// One step of mixed Newton from positions x and the tensions of the iteration before, O(points): `direction` is by
  /// how much the points move, `next` are the tensions after a full step. False if the system was singular.
  virtual bool newton_step(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                           std::span<Vec2> direction, std::span<double> next) = 0;

  // The same for a solve together with others, as blocks: the points' slots follow each other from `first` on, and
  // those of tensions that stay unknowns from `first_dual` on.

  virtual std::size_t dual_count() const { return 0; }
  /// Appends the slots in an order to eliminate them in, and tells point_done(i) after each point.
  virtual void order(int first, int first_dual, std::vector<int>& slots, const PointDone& point_done) const = 0;
  virtual void couple(BlockLdlt& blocks, int first, int first_dual) const = 0;
  /// Adds the matrix, inertia included, and the right-hand side by slot; constrained points are the caller's to hold.
  virtual void load(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions, BlockLdlt& blocks,
                    int first, int first_dual, std::span<Vec2> right_side) = 0;
  /// The tensions after the step that solves it.
  virtual void update(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions,
                      std::span<const Vec2> direction, std::span<const Vec2> duals, std::span<double> next) = 0;

  /// m, how far points moved in the step that led here because bars that cannot push were taken for slack or taut and
  /// are not. Newton's method on what bends converges fast, so that a short step is near the solution; one that took a
  /// bar for slack is as far from it as the step is long.
  virtual double misjudged_way(const Stage& stage, std::span<const Vec2> x, std::span<const double> tensions) = 0;

  /// What a stage minimises besides inertia and constant forces, J: the elastic energy and what damping takes, but of
  /// elements with a tension the exact penalty that grows no steeper than `most`, one a tension. See `exact_penalty`.
  virtual double potential(const Stage& stage, std::span<const Vec2> x, std::span<const double> most) = 0;

  /// The elastic energy, J, of elements with a tension by that, less what of it is damping: nothing without velocities.
  virtual double energy(const Motion& at, std::span<const double> tensions) const = 0;

  /// Looks for cells that are turned inside out, at the start of a step, and makes their energy for this step one that
  /// turns them back. True if there are any.
  virtual bool unlock(std::span<const Vec2> /*x*/) { return false; }
  /// Which cells are, by cell: memory from step to step. Empty where there is no such thing.
  virtual std::span<char> unlocked() { return {}; }
};

}  // namespace ribbon
