#pragma once

#include <cstddef>
#include <cstdint>

#include "ribbon/cord.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// The report of a step, and the limits of the work that it may take.
class StepWork {
 public:
  IslandReport report;

  /// Begins an attempt at the step; its cords and bodies are known. What an attempt before it left unsolved is not
  /// kept.
  void begin_attempt(const IslandState& state);
  /// Begins to solve the step with contacts that are linearised once.
  void begin_linearised();

  /// Counts a linear system of `blocks` blocks, 0 for the band matrix of a single cord, and pairs tested for contact.
  void count_system(std::size_t blocks, std::int64_t tested_pairs);
  /// Returns whether this share of the work that a step may take has been done.
  bool has_spent(double share = 1.0) const;
  /// Returns whether the step may take so much work that a substep that does not converge is halved first, before the
  /// contacts of the whole step are linearised once.
  bool has_large_budget() const;
  /// Returns whether the step has taken many linear systems: more than 30, or more with more than four substeps.
  bool was_hard() const;
  /// Returns whether the attempt has used this share of its work, or all attempts together all of theirs, so that
  /// contacts are linearised once.
  bool attempt_is_over(double share = 1.0) const;
  /// Returns whether substeps are halved no more: half of the work is spent or, unless cells are being turned back,
  /// 180 linear systems, or more with more than four substeps.
  bool halving_is_over(bool unlocking) const;
  /// Returns whether the pieces of a linearised step are redone no more.
  bool redoing_is_over() const;
  /// Returns whether a linearised step is linearised no more.
  bool linearising_is_over() const;

 private:
  std::size_t points_ = 0;
  double max_work_factor_ = 0.0;  // Accuracy::max_work
  double scale_ = 1.0;            // of the limits
  double max_work_ = 0.0;         // in the unit of IslandReport::work
  int attempt_iterations_ = 0;    // of the report when the attempt began
  std::int64_t attempt_work_ = 0;
  // Of the report, after which no piece of a linearised step is redone, and none is linearised again.
  int last_redone_ = 0;
  int last_linearised_ = 0;
};

}  // namespace ribbon
