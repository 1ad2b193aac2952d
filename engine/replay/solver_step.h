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
#include "ribbon/tie.h"
#include "ribbon/vec2.h"
#include "ribbon/weather.h"

namespace engine {

/// A text does not contain a valid step. The message has the location of the fault and what is accepted.
class SolverStepError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One step of the direct solver: the whole input of ribbon::DirectSolver::step and its outcome.
struct SolverStep {
  /// A cord before the step, with its surroundings.
  struct Cord {
    ribbon::CordDef def;
    ribbon::Cord::State state;
    std::vector<ribbon::RigidCircle> circles;
    std::vector<ribbon::RigidSegment> segments;
    std::vector<ribbon::Grip> grips;
    std::vector<ribbon::Axle> axles;
    std::vector<ribbon::Support> supports;
    std::uint64_t id = 0;  ///< IslandCord::id
    int medium = -1;       ///< index into media; −1 for none
    double time = 0.0;     ///< s, see Surroundings::time
  };
  /// The outcome when the step was recorded, to compare with a repetition.
  struct Outcome {
    std::string why;              ///< why it was recorded, in words
    std::int64_t work = 0;        ///< IslandReport::work of all islands
    int unconverged = 0;          ///< unconverged substeps of all islands
    std::uint64_t positions = 0;  ///< hash_of_positions of the cords
  };

  double dt = 0.0;                        ///< s
  ribbon::Vec2 gravity;                   ///< m/s²
  std::vector<ribbon::RigidBody> bodies;  ///< referred to by all cords
  std::vector<Cord> cords;                ///< in the order of the solver
  std::vector<ribbon::Tie> ties;          ///< of these cords
  /// What flows around the cords. A medium that is not a Weather cannot be recorded: a uniform one is, like it at the
  /// middle point of the cord. Then a repetition has other bits.
  std::vector<ribbon::WeatherDef> media;
  Outcome outcome;
};

/// Copies the input of the solver. Allocates only if `step` never held as much before.
void capture(const ribbon::box2d::SolverInput& input, SolverStep& step);

/// Returns a hash of the positions and velocities of all points.
std::uint64_t hash_of_positions(std::span<const ribbon::IslandCord> cords);

/// Throws SolverStepError unless the solver accepts the step: all numbers are in range, each state fits its definition,
/// all bodies, cords and points referred to exist, and the ids of the cords are unique.
void check(const SolverStep& step);

/// Returns the step as JSON with exact numbers: the shortest digits that read back as the same bits, and texts for
/// numbers that are not finite.
std::string to_text(const SolverStep& step);
/// Reads what to_text returned. Throws SolverStepError, with a message that begins with `where`, if the text is not a
/// step, has another version, has a missing or unknown field, or fails check().
SolverStep read_solver_step(std::string_view text, const std::string& where);

/// Reads a file of up to 256 MiB. Throws like read_solver_step.
SolverStep load_solver_step(const std::string& path);
/// Writes a file, or removes it if it cannot be written completely. With `is_new` it does not overwrite: it returns
/// false if the file exists. Throws SolverStepError.
bool save_solver_step(const SolverStep& step, const std::string& path, bool is_new = false);

}  // namespace engine
