#include "ribbon/box2d/step_cords.h"

#include "ribbon/box2d/impulse_report.h"

namespace ribbon::box2d {
namespace {

/// Lists the cords that the direct solver steps.
void list_island_cords(CouplingParts& parts) {
  const StepConditions& conditions = parts.conditions;
  parts.island_cords.clear();
  const bool records_pushes = parts.listener != nullptr && parts.listener->wants_impulses();
  visit_fetched(parts.cords.active(), CordMemory::surroundings, [&](CoupledCord& cord) {
    if (!cord.is_direct() || !cord.enabled) return;
    const Surroundings surroundings{parts.bodies.rigid, cord.circles,           cord.grips,   cord.segments, cord.axles,
                                    conditions.medium,  conditions.medium_time, cord.supports};
    cord.step_index = static_cast<int>(parts.island_cords.size());
    parts.island_cords.push_back({&cord.direct(), surroundings, solver_id(cord.id), records_pushes});
  });
}

/// Stores the reports of the step by cord. Returns whether a cord may be asleep: then its report is empty.
bool take_reports(CouplingParts& parts) {
  std::size_t k = 0;
  bool any_asleep = false;
  visit_fetched(parts.cords.active(), CordMemory::reports, [&](CoupledCord& cord) {
    if (!cord.is_direct() || !cord.enabled) return;
    if (parts.probe) cord.error = parts.probe->error(k, cord.direct());
    cord.report = parts.reports[k++];
    cord.island_report = parts.solver.island_reports()[static_cast<std::size_t>(cord.report.island)];
    const bool is_awake = cord.island_report != IslandReport{};
    if (is_awake) cord.island_total += cord.island_report;
    any_asleep = any_asleep || !is_awake;
  });
  return any_asleep;
}

}  // namespace

void step_thesis(CouplingParts& parts) {
  for (CoupledCord& cord : parts.cords.active()) {
    if (cord.is_direct() || !cord.enabled) continue;
    const Surroundings surroundings{parts.bodies.rigid, cord.circles, cord.grips};
    cord.thesis_report = cord.thesis().step(parts.conditions.dt, parts.conditions.gravity, surroundings);
    cord.thesis_total += cord.thesis_report;
    const auto touches = [&](int body) {
      parts.bodies.entries[static_cast<std::size_t>(body)].thesis_cord = cord.id;
      parts.bodies.rigid[static_cast<std::size_t>(body)].may_sleep = false;  // cords of this solver do not sleep
    };
    for (const RigidCircle& circle : cord.circles) touches(circle.body);
    for (const Grip& grip : cord.grips) touches(grip.body);
  }
}

bool step_direct(CouplingParts& parts) {
  const Vec2 gravity = parts.conditions.gravity;
  const double dt = parts.conditions.dt;
  std::vector<RigidBody>& bodies = parts.bodies.rigid;
  list_island_cords(parts);
  const std::span<const Tie> ties = parts.ties.of_step(parts.cords);
  parts.reports.resize(parts.island_cords.size());
  if (parts.probe) parts.probe->foresee(parts.island_cords, bodies, dt, gravity, ties);
  const SolverInput input{parts.island_cords, bodies, dt, gravity, ties};
  if (parts.watcher != nullptr) parts.watcher->before(input);
  parts.solver.step(parts.island_cords, bodies, dt, gravity, parts.reports, ties);
  if (parts.watcher != nullptr) parts.watcher->after(input, parts.solver.island_reports(), parts.solver.total());
  const bool any_asleep = take_reports(parts);
  const bool records_pushes = !parts.island_cords.empty() && parts.island_cords.front().records_pushes;
  if (records_pushes) report_impulses(parts.cords, parts.fixtures, *parts.listener, parts.impulses);
  return any_asleep;
}

}  // namespace ribbon::box2d
