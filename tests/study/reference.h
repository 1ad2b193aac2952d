#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "tests/study/players.h"
#include "tests/study/setting.h"
#include "tests/study/statistics.h"
#include "tests/study/trace.h"

namespace study {

/// The results of the converged runs of a level.
struct Reference {
  Mesh mesh;
  std::size_t ticks = 0;      ///< while the runs differ by at most 0.1 mm, and probes by max_probe_difference
  double agreement_m = 0.0;   ///< difference of two converged runs with different substeps in these ticks
  Statistics chaotic;         ///< difference of these two runs after these ticks
  int unconverged_ticks = 0;  ///< of the reference
  int posed = 0;              ///< IslandReport::posed of the reference: such steps are not converged
};

/// The runs that show which ticks can be compared: two converged ones, and two probes with opposite kicks.
struct ReferenceRuns {
  const Trace& finer;  ///< what others are compared with
  const Trace& other;
  const Trace& left;
  const Trace& right;
};
Reference reference_of(const Mesh& mesh, const ReferenceRuns& runs);

/// Runs a moderate setting twice side by side, with velocities that differ by twice probe_kick, until they differ by
/// more than max_probe_difference: what comes later is not compared. Returns the one to the left and the one to the
/// right.
std::pair<Trace, Trace> run_probes(const game::Level& moderate, std::span<const engine::TickInput> inputs);

/// Which of two converged runs goes on where nothing is compared.
enum class GoesOn {
  both,   ///< for statistics
  second  ///< for what goes through what
};

/// Runs two converged motions side by side, and from the tick after that in which they differ by more than
/// max_reference_difference on, or from `change` on, with the accuracy of `change`: nothing is compared there, and
/// where converged runs part they are most expensive. Returns the records of the first and the second.
std::pair<Trace, Trace> run_converged(const game::Level& first, const game::Level& second, const Inputs& inputs,
                                      const AccuracyChange& change, GoesOn goes_on = GoesOn::both);

/// Returns where converged runs take the probe's setting: after the ticks in which the probes agree. From there on no
/// path is compared, only statistics, and what goes through what.
AccuracyChange end_of_reference(const Mesh& mesh, const Trace& left, const Trace& right);

/// Returns why a run does not count: it became unstable, tunnelled where its reference did not (see
/// tunnelling_failure), or did not converge in all ticks; empty if it counts.
std::string failure_of(const Trace& run, const Trace& reference, std::size_t ticks);

}  // namespace study
