#pragma once

#include <algorithm>

#include "ribbon/collision/motion_bounds.h"
#include "ribbon/contact/contacts.h"
#include "ribbon/cord_forces.h"
#include "ribbon/island/energy_guard.h"
#include "ribbon/stage/stage_solver.h"
#include "ribbon/stage/step_work.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// What a step of an island works on.
struct StepContext {
  IslandState& state;
  Contacts& contacts;
  MotionBounds& bounds;
  StageSolver& stages;
  EnergyGuard& guard;
  StepWork& work;

  /// Begins a substep, or a part of one, at `time` [s] since the step began.
  void begin_substep(double time, double dt) const {
    guard.discard_measurement();
    state.begin_substep(time, dt);
    if (contacts.empty()) return;
    contacts.scene.anchors.place_kinematics(time);
    contacts.begin_substep(state.positions, (time + dt) / state.dt);
  }
  /// Returns to the start of the substep.
  void return_to_start() const {
    guard.discard_measurement();
    contacts.scene.anchors.place_kinematics(state.start.time);
    contacts.impacts.return_to_start();
    state.return_to_start();
  }
  /// Counts a substep that is kept although it did not converge, with the residuals of the island, and of each member
  /// that did not.
  void report_unconverged(double position_error, double force_error) const {
    IslandReport& report = work.report;
    ++report.unconverged;
    report.position_error = std::max(report.position_error, position_error);
    report.force_error = std::max(report.force_error, force_error);
    for (Member& member : state.members) {
      if (member.last_correction > state.tolerance) {
        member.report.position_error = std::max(member.report.position_error, member.last_correction);
      }
      report.position_error = std::max(report.position_error, member.last_correction);
    }
  }
  /// Returns the total energy at the start of a substep. While something drives the island there is nothing to compare.
  CordEnergy energy_before() const { return state.driven ? CordEnergy{} : EnergyGuard::total_energy(state, contacts); }
  /// Returns whether a part of a step has gained energy and is therefore no solution.
  bool gained_energy(const CordEnergy& before, double tolerated) const {
    return !state.turning_cells && guard.gained_energy(state, contacts, before, tolerated);
  }
};

}  // namespace ribbon
