#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/replay/solver_step.h"
#include "ribbon/box2d/step_watcher.h"

namespace engine {

/// Which steps are worth a file: those of which any of these holds. None holds unless it is asked for.
struct FlightConditions {
  std::optional<std::int64_t> max_work{};  ///< more work than that, of all islands: CordReport::work
  bool unconverged = false;                ///< a substep that was left unconverged
  std::optional<double> max_speed{};       ///< m/s: a point that is faster after the step
  std::optional<double> max_stretch{};  ///< a link that is longer after it by more than that share of its rest length
  bool not_finite = false;              ///< a position or velocity that is no number after it
};

/// Writes the steps of a coupling's direct solver of which a condition holds, each into a file of its own as
/// load_solver_step reads it: coupling.watch(&recorder). While it is armed it copies what each step begins with: memory
/// is taken only where there is more of something than in any step before.
class FlightRecorder : public ribbon::box2d::StepWatcher {
 public:
  /// The files are PREFIX1.json, PREFIX2.json, …, in place of none that is there; `most_files` of them, and then it is
  /// not armed any more.
  FlightRecorder(const FlightConditions& conditions, std::string prefix, int most_files);

  void before(const ribbon::box2d::SolverInput& input) noexcept override;
  void after(const ribbon::box2d::SolverInput& input, std::span<const ribbon::CordReport> reports,
             const ribbon::CordReport& total) noexcept override;

  /// Whether it still writes: not after the last file, and not after a failure.
  bool is_armed() const { return written_ < most_files_ && failure_.empty(); }
  int written() const { return written_; }                     ///< files
  const std::string& last_file() const { return last_file_; }  ///< empty if there is none
  /// Why a file could not be written, in a sentence; empty if all could.
  const std::string& failure() const { return failure_; }

 private:
  std::string reason(const ribbon::box2d::SolverInput& input, const ribbon::CordReport& total) const;
  void write();
  void fail(const char* sentence) noexcept;

  FlightConditions conditions_;
  std::string prefix_;
  int most_files_;
  int written_ = 0;
  int number_ = 0;  // of the last file tried
  SolverStep step_;
  bool has_step_ = false;
  std::string last_file_;
  std::string failure_;
};

}  // namespace engine
