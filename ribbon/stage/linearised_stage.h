#pragma once

#include <limits>
#include <span>
#include <vector>

#include "ribbon/collision/motion_bounds.h"
#include "ribbon/stage/contact_stage.h"
#include "ribbon/stage/convex_solver.h"
#include "ribbon/stage/motion_groups.h"
#include "ribbon/system/bar_rows.h"
#include "ribbon/system/link_lengths.h"

namespace ribbon {

/// How the contacts of a stage are solved.
enum class ContactSolve {
  newton,             ///< as terms of the Newton steps
  linearised,         ///< linearised once, see LinearisedStage
  linearised_impact,  ///< the same, in a piece of a step that takes an impact
  truncated,          ///< the same, ended after a few linear systems
};

/// How a linearised stage ended.
struct LinearisedResult {
  bool converged = false;
  bool cut = false;                                                 ///< something was stopped to prevent penetration
  double position_error = std::numeric_limits<double>::infinity();  ///< m, correction by the last linear solve
  double force_error = 0.0;                                         ///< N, inertia force of that correction
};

/// Solves a stage of implicit Euler whose contacts are linearised at most a few times and then kept. Each linearisation
/// of the cords then leaves a convex problem, which has a solution and is solved in bounded work. Whatever iterate the
/// stage ends with is one that may be kept: nothing has passed through anything.
class LinearisedStage {
 public:
  void resize(std::size_t slots, std::size_t tensions);
  /// Reserves memory for a step of an island with so many contacts.
  void reserve(const IslandState& state, const Contacts& contacts);
  /// Solves the stage. A piece that takes an impact is so short that nothing moves far, and a few linearisations do. A
  /// truncated solve ends with whatever a few linear systems give; the contacts that they leave wrong are those of a
  /// heap, and the next step begins with their forces.
  LinearisedResult solve(const StageContext& context, const MotionBounds& bounds, const StageRequest& request,
                         Stage& stage, ContactSolve kind);
  /// Returns memory for shares of motions.
  MotionGroups& groups() { return groups_; }

 private:
  /// The course of one solve.
  struct Course {
    LinearisedResult result;
    bool has_best = false;
    int misses = 0;  // times that contacts were linearised that the solution would have missed
  };
  enum class Iteration { next, ended };

  void begin(const StageContext& context, const StageRequest& request) const;
  Iteration iterate(const StageContext& context, const StageRequest& request, Stage& stage, int k, Course& course);
  void truncate(const StageContext& context, const StageRequest& request, const Stage& stage, Course& course);
  void settle(const StageContext& context, const StageRequest& request, Course& course);
  void end(const StageContext& context, const Stage& stage, Course& course);
  void restore_lengths(const StageContext& context, const MotionBounds& bounds, const StageRequest& request,
                       const Stage& stage, int most);
  void append_rows(const StageContext& context, const Stage& stage);
  double energy(const StageContext& context, const Stage& stage, std::span<const Vec2> x);
  bool is_worse_than_best(const StageContext& context, const Stage& stage);
  void store_best(const StageContext& context, const Stage& stage, Course& course);
  bool return_to_best(const StageContext& context, const Stage& stage);
  double step_fraction(const StageContext& context, const Stage& stage);
  void store_solved(const StageContext& context);
  void return_to_solved(const StageContext& context) const;

  ConvexSolver solver_;
  BarRows bar_rows_;
  std::vector<Vec2> best_;
  std::vector<double> best_tensions_;
  // A solution that may have missed contacts.
  std::vector<Vec2> solved_positions_;
  std::vector<double> solved_tensions_;
  std::vector<HeldBody> solved_held_;
  MotionGroups groups_;
  LinkLengths link_lengths_;
};

}  // namespace ribbon
