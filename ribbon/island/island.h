#pragma once

#include <span>

#include "ribbon/collision/candidate_finder.h"
#include "ribbon/collision/motion_bounds.h"
#include "ribbon/contact/contacts.h"
#include "ribbon/cord.h"
#include "ribbon/island/energy_guard.h"
#include "ribbon/island/integrators.h"
#include "ribbon/island/linearised_step.h"
#include "ribbon/island/restitution.h"
#include "ribbon/island/rings.h"
#include "ribbon/island/step_context.h"
#include "ribbon/island/substeps.h"
#include "ribbon/island_cord.h"
#include "ribbon/stage/stage_solver.h"
#include "ribbon/stage/step_work.h"
#include "ribbon/system/island_state.h"
#include "ribbon/system/tie_groups.h"

namespace ribbon {

/// The step of the direct solver: cords that are solved together, because they hold the same bodies, are tied or may
/// touch each other. It stores no state between steps, only memory.
class Island {
 public:
  /// Advances the cords by dt seconds. The surroundings of all of them refer to `bodies`, the `tied` points, group by
  /// group, to the cords. Writes the report of cords[k] to reports[k].
  IslandReport step(std::span<const IslandCord> cords, std::span<const TiedPoint> tied, std::span<RigidBody> bodies,
                    double dt, Vec2 gravity, std::span<CordReport> reports);
  /// Reserves memory for steps of a cord with up to this many grips.
  void reserve(const CordParts& cord, std::size_t grips);

 private:
  /// What the memory of a step depends on.
  struct Sizes {
    std::size_t slots = 0;
    std::size_t tensions = 0;
    std::size_t grips = 0;

    bool operator==(const Sizes&) const = default;
  };

  StepContext context() { return {state_, contacts_, bounds_, stages_, guard_, work_}; }
  void begin_attempt(std::span<const IslandCord> cords, std::span<const TiedPoint> tied, ApartTies apart);
  bool truncates(bool linearised) const;
  bool take_substeps(bool linearised);
  void store_newton_pause(bool linearised);
  void end_step();
  void store_touches();
  void write_reports(std::span<CordReport> reports) const;
  void resize(std::size_t slots, std::size_t tensions);

  IslandState state_;
  Rings rings_;
  CandidateFinder candidates_;
  MotionBounds bounds_;
  Contacts contacts_;
  StageSolver stages_;
  EnergyGuard guard_;
  StepWork work_;
  bool pausing_newton_ = false;  // in this step
  Sizes sizes_;                  // of all arrays
  Substeps substeps_;
  LinearisedStep linearised_step_;
  Restitution restitution_;
};

}  // namespace ribbon
