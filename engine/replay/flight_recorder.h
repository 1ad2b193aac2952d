#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/replay/solver_step.h"
#include "ribbon/box2d/step_watcher.h"

namespace engine {

/// The steps to record: those for which at least one condition holds. By default all conditions are off.
struct FlightConditions {
  std::optional<std::int64_t> max_work{};  ///< more work in all islands than this: IslandReport::work
  bool unconverged = false;                ///< a substep that did not converge
  std::optional<double> max_speed{};       ///< m/s: a point that is faster than this after the step
  std::optional<double> max_stretch{};     ///< a link whose strain is larger than this after the step
  bool not_finite = false;                 ///< a position or velocity that is not finite after the step
};

/// Records steps of a coupling's direct solver for which a condition holds, each in a file of its own that
/// load_solver_step reads. Attach it with coupling.watch(&recorder). While it is armed it copies the input of every
/// step; it allocates only if a step has more data than all before.
class FlightRecorder : public ribbon::box2d::StepWatcher {
 public:
  /// The files are PREFIX1.json, PREFIX2.json, …; existing files are not overwritten. After `max_files` files it is
  /// disarmed.
  FlightRecorder(const FlightConditions& conditions, std::string prefix, int max_files);

  void before(const ribbon::box2d::SolverInput& input) noexcept override;
  void after(const ribbon::box2d::SolverInput& input, std::span<const ribbon::IslandReport> reports,
             const ribbon::IslandReport& total) noexcept override;

  /// False after the last file and after a failure.
  bool is_armed() const { return written_ < max_files_ && failure_.empty(); }
  int written() const { return written_; }                     ///< files
  const std::string& last_file() const { return last_file_; }  ///< empty if there is none
  /// The reason why a file could not be written; empty if there was no failure.
  const std::string& failure() const { return failure_; }

 private:
  std::string reason(const ribbon::box2d::SolverInput& input, const ribbon::IslandReport& total) const;
  void write();
  void fail(const char* sentence) noexcept;

  FlightConditions conditions_;
  std::string prefix_;
  int max_files_;
  int written_ = 0;
  int number_ = 0;  // in the name of the last file tried
  SolverStep step_;
  bool has_step_ = false;
  std::string last_file_;
  std::string failure_;
};

}  // namespace engine
