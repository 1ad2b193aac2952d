#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ribbon/box2d/step_watcher.h"
#include "ribbon/cord.h"
#include "ribbon/cord_def.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/vec2.h"

namespace engine {

/// A text that holds no step that could be taken. The sentence says where it is wrong, and what is accepted.
class SolverStepError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One step of the direct solver: all that ribbon::DirectSolver::step is given, and what came of it.
struct SolverStep {
  /// A cord as it is before the step, and what it alone meets.
  struct Cord {
    ribbon::CordDef def;
    ribbon::Cord::State state;
    std::vector<ribbon::RigidCircle> circles;
    std::vector<ribbon::RigidSegment> segments;
    std::vector<ribbon::Grip> grips;
    std::uint64_t id = 0;  ///< IslandCord::id
  };
  /// What the step did when it was recorded, to see whether it does so again.
  struct Outcome {
    std::string why;              ///< what it was recorded for, in words
    std::int64_t work = 0;        ///< CordReport::work, of all islands
    int unconverged = 0;          ///< substeps, of all islands
    std::uint64_t positions = 0;  ///< hash_of_positions of its cords
  };

  double dt = 0.0;                        ///< s
  ribbon::Vec2 gravity;                   ///< m/s²
  std::vector<ribbon::RigidBody> bodies;  ///< that all cords refer to
  std::vector<Cord> cords;                ///< in the order in which they are solved
  Outcome outcome;
};

/// Copies what the solver is about to be given. A step that has held the same before takes no memory.
void capture(const ribbon::box2d::SolverInput& input, SolverStep& step);

/// Of where the points of the cords are and how fast they move: the same for the same bits alone.
std::uint64_t hash_of_positions(std::span<const ribbon::IslandCord> cords);

/// Throws SolverStepError unless the solver can take the step: every number in its range, every state one of its
/// definition, every body and point that something refers to there, no two cords with the same id.
void check(const SolverStep& step);

/// JSON, with all numbers exact: doubles by the shortest digits that read back as the same bits, what is not finite as
/// a text.
std::string to_text(const SolverStep& step);
/// Reads it back. Throws SolverStepError, whose sentence begins with `where`, for what is no such text, has another
/// version, lacks a field or has one too many, or holds what check refuses.
SolverStep read_solver_step(std::string_view text, const std::string& where);

/// The same from a file of up to 256 MiB.
SolverStep load_solver_step(const std::string& path);
/// The same into a file, which is not there afterwards if it cannot be written whole. With `is_new` only where there
/// is none of that name yet; returns false where there is. Throws SolverStepError.
bool save_solver_step(const SolverStep& step, const std::string& path, bool is_new = false);

}  // namespace engine
