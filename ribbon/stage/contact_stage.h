#pragma once

#include <span>
#include <vector>

#include "ribbon/stage/newton_solver.h"
#include "ribbon/system/link_lengths.h"

namespace ribbon {

/// One solve of a stage: from where, until when, and the weight of its forces.
struct StageRequest {
  double time;                 ///< s, end of the stage, since the step began
  double q;                    ///< s, see Stage
  std::span<const Vec2> from;  ///< m, positions at the start of the stage
  double time_weight;          ///< s, with which the stage's forces act on the momentum of the substep
  bool euler = false;          ///< the stage is implicit Euler
};

/// Solves a stage near contacts: collision-free Newton steps that reduce the stage's energy. They begin where the stage
/// before ended and go as far as they can towards the guess; what is driven moves along with them.
class ContactStage {
 public:
  void resize(std::size_t slots) { link_lengths_.resize(slots); }
  /// Returns false if it did not converge; the state is then the last iterate.
  bool solve(const StageContext& context, const StageRequest& request, const Stage& stage);

 private:
  /// How one Newton step was taken.
  struct Taken {
    double fraction;  // of the direction; 0 if none reduces the energy
    bool small;       // within the tolerance, and collision-free in full
    bool full;        // it was taken without a search
    bool crawls;      // much less than the collision-free step was taken
  };
  void begin(const StageContext& context, const StageRequest& request);
  void advance_drives(const StageContext& context, const Stage& stage);
  void advance_kinematics(const StageContext& context, std::span<const Vec2> predicted);
  Taken take_step(const StageContext& context, const Stage& stage, double moved, int iteration);
  double search(const StageContext& context, const Stage& stage, double fraction, int iteration);
  bool is_solution(const StageContext& context, const StageRequest& request, const Stage& stage);

  LinkLengths link_lengths_;
  double drive_left_ = 0.0;     // share of the displacement of what is driven that is still to come
  std::vector<double> values_;  // of the energy, in the last iterations
};

}  // namespace ribbon
