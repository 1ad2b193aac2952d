#pragma once

#include <span>
#include <vector>

#include "ribbon/contact/contacts.h"
#include "ribbon/stage/step_work.h"
#include "ribbon/system/block_system.h"
#include "ribbon/system/held_body.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// The Newton steps of an implicit stage: a direction for all slots, and the tensions after a full step. The stage's
/// energy, which a line search reduces, replaces what tensions hold together by an exact penalty.
class NewtonSolver {
 public:
  static constexpr double max_displacement = 1e12;  ///< m, of a Newton step: beyond it a solve has failed
  static constexpr double min_fraction = 1e-6;      ///< of a Newton step, below which a line search gives up

  void resize(std::size_t slots, std::size_t tensions, std::size_t grips);
  void reserve(std::size_t grips);

  /// Finds the direction from the current positions. Returns false if the matrix is not definite.
  bool find_direction(IslandState& state, const Stage& stage, Contacts& contacts);
  /// The same by the coupled system in any case.
  bool find_coupled_direction(IslandState& state, const Stage& stage, Contacts& contacts);
  /// Takes over the solution of the coupled system. Returns false if it is not finite.
  bool take_solution(IslandState& state, const Stage& stage);
  /// Returns the largest displacement of a point, grip or (coupled) body centre, m; not finite if one is not.
  double largest_displacement(const IslandState& state) const;
  /// Stores the largest displacement of each member's points in the last direction.
  void store_corrections(IslandState& state) const;
  /// Writes the positions after a fraction of the direction. Bodies move straight, so that forces balance and momentum
  /// is conserved to the last bits; the separation that this leaves at an arm is of second order, in a step below the
  /// tolerance.
  void move(const IslandState& state, std::span<Vec2> x, double fraction) const;
  /// Sets the centres of bodies from their points and angles, in the solve of a single cord.
  static void close_arms(const IslandState& state, std::span<Vec2> x);
  /// Returns whether a grip began to slip in the last linear solve.
  bool slip_began() const { return slip_began_; }
  /// Returns whether the last linear system had other supports than the one before, so that their energies differ.
  bool supports_changed() const { return supports_changed_; }
  /// Returns whether each bar was rightly taken for slack or taut, and each support for one that pushes or does not, so
  /// that this iteration may be the last. After some iterations bars are not judged: where nothing pulls, a bar may be
  /// either.
  bool is_settled(IslandState& state, const Stage& stage, int iteration) const;

  /// Resets the slopes of the exact penalty.
  void reset_penalty();
  /// Raises them to at least twice the tensions of the last linear solve; never lowers them.
  void raise_penalty();
  /// Returns what the stage minimises, J, except the energy of contacts. With `with_grips` it includes that of grips.
  double potential(IslandState& state, const Stage& stage, std::span<const Vec2> x, bool with_grips) const;

  BlockSystem& system() { return system_; }
  std::vector<Vec2>& direction() { return direction_; }
  /// Returns the tensions after the step.
  std::vector<double>& next_tensions() { return next_; }
  /// Swaps the tensions of the state with those after the step.
  void take_tensions(IslandState& state) { state.tensions.swap(next_); }
  /// Returns memory for positions that are tried.
  std::vector<Vec2>& trial() { return trial_; }

 private:
  bool find_single_direction(IslandState& state, Stage stage, Contacts& contacts);

  BlockSystem system_;
  std::vector<Vec2> direction_;
  std::vector<double> next_;                // tensions
  std::vector<EliminatedLink> eliminated_;  // memory of the step of a single cord, by tension
  std::vector<Vec2> trial_;
  std::vector<double> penalty_;  // slopes, by tension
  std::vector<HeldStep> held_steps_;
  std::vector<CondensedBody> carried_;
  bool slip_began_ = false;
  bool supports_changed_ = false;
};

/// What the solve of a stage works on.
struct StageContext {
  IslandState& state;
  Contacts& contacts;
  NewtonSolver& newton;
  StepWork& work;

  void count_system() const { work.count_system(newton.system().blocks(), contacts.scene.candidates.take_checks()); }
};

/// Solves a stage without contacts: full Newton steps and, if these do not converge, Newton steps with a line search.
class FreeStage {
 public:
  void resize(std::size_t slots, std::size_t tensions);
  /// Returns false if it did not converge; the state is then the last iterate.
  bool solve(const StageContext& context, Stage& stage);

 private:
  static bool full_steps(const StageContext& context, const Stage& stage);
  static bool searched_steps(const StageContext& context, const Stage& stage);

  std::vector<Vec2> guess_;
  std::vector<double> tension_guess_;
};

}  // namespace ribbon
