#pragma once

#include <cstddef>
#include <cstdint>

#include "ribbon/cord.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// The report of a step, and the limits of the work that it may take.
class StepWork {
 public:
  CordReport report;

  /// Begins an attempt at the step; its cords and bodies are known.
  void begin_attempt(const IslandState& state);
  /// Begins to solve the step with contacts that are linearised once.
  void begin_linearised();

  /// Counts a linear system of `blocks` blocks, 0 for the band matrix of a single cord, and pairs tested for contact.
  void count_system(std::size_t blocks, std::int64_t tested_pairs);
  /// Returns whether this share of the work that a step may take has been done.
  bool is_spent(double share = 1.0) const;
  /// Returns whether there is so much work to spend that a substep that does not converge is halved before its contacts
  /// are linearised once.
  bool is_patient() const;
  /// Returns whether the attempt, or all attempts together, have done enough work to linearise contacts once.
  bool is_tried() const;
  /// Returns whether halving has spent half of the work or, unless cells are being turned back, 180 linear systems.
  bool is_halved_out(bool unlocking) const;
  /// Returns whether no piece of a linearised step is redone any more.
  bool is_enough() const;
  /// Returns whether a linearised step takes no more linearisations.
  bool is_exhausted() const;

 private:
  std::size_t points_ = 0;
  double max_work_factor_ = 0.0;  // Accuracy::max_work
  double max_work_ = 0.0;         // in the unit of CordReport::work
  int attempt_iterations_ = 0;    // of the report when the attempt began
  std::int64_t attempt_work_ = 0;
  int linearised_iterations_ = 0;  // of the report when linearising began
};

}  // namespace ribbon
