#pragma once

#include <cstdint>
#include <vector>

#include "engine/replay/solver_step.h"
#include "ribbon/direct_solver.h"
#include "ribbon/weather.h"

/// Recorded steps of the direct solver: replay, inspection, shrinking and printing.
namespace flight {

/// A recorded step that can be taken any number of times.
class Replay {
 public:
  /// Throws ribbon::DefinitionError for a step that engine::check refuses.
  explicit Replay(const engine::SolverStep& step);
  explicit Replay(engine::SolverStep&& step) = delete;
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

  /// Restores the state before the step.
  void reset();
  void run();

  const std::vector<ribbon::Cord>& cords() const { return cords_; }
  /// The bodies after the step: see ribbon::RigidBody.
  const std::vector<ribbon::RigidBody>& bodies() const { return bodies_; }
  /// By cord.
  const std::vector<ribbon::CordReport>& reports() const { return reports_; }
  std::span<const ribbon::IslandReport> island_reports() const { return solver_.island_reports(); }
  const ribbon::IslandReport& total() const { return solver_.total(); }
  int islands() const { return solver_.islands(); }
  /// engine::hash_of_positions.
  std::uint64_t hash() const { return engine::hash_of_positions(island_cords_); }
  /// Returns whether the result equals the recorded one bit for bit.
  bool is_as_recorded() const;

 private:
  const engine::SolverStep& step_;
  std::vector<ribbon::Cord> cords_;
  std::vector<ribbon::Weather> media_;
  std::vector<ribbon::RigidBody> bodies_;
  std::vector<ribbon::IslandCord> island_cords_;
  std::vector<ribbon::CordReport> reports_;
  ribbon::DirectSolver solver_;
};

}  // namespace flight
