#include <algorithm>
#include <cmath>

#include "ribbon/thesis/corrections.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/thesis/thesis_parts.h"
#include "ribbon/thesis/thesis_report.h"

// The step of the thesis's method.

namespace ribbon {
namespace {

constexpr double max_drag_speed_ratio = 2.0;  // speed of a free point over that of the fastest driven point

/// Returns the maximum displacement of a free point in a substep: a spacing, or twice that of the fastest driven point.
/// Without a limit, self-contact under a yank feeds on itself.
double motion_limit(const ThesisPoints& points, double spacing, double dt, double substep_dt) {
  double driven_speed = 0.0;
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    if (points.inverse_mass[p] > 0.0) continue;
    driven_speed = std::max(driven_speed, length(points.targets[p] - points.step_start[p]) / dt);
  }
  return std::max(spacing, max_drag_speed_ratio * driven_speed * substep_dt);
}

/// Moves constrained and operated points to their targets, in a straight line and evenly over the substeps.
void move_driven_points(ThesisPoints& points, double fraction) {
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    if (points.inverse_mass[p] > 0.0) continue;
    points.positions[p] = points.step_start[p] + fraction * (points.targets[p] - points.step_start[p]);
  }
}

/// P = R + δ·v/(1 + c·δ) + δ²·g. The implicit factor 1/(1 + c·δ) replaces e^{−cδ}: it is equal to first order, positive
/// for any c, and needs no library function whose last bit differs between machines.
void predict(ThesisPoints& points, double drag, double dt, Vec2 gravity) {
  const double decay = 1.0 / (1.0 + drag * dt);
  const Vec2 fall = (dt * dt) * gravity;
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    if (points.inverse_mass[p] == 0.0) continue;
    points.positions[p] = points.substep_start[p] + (dt * decay) * points.velocities[p] + fall;
  }
}

/// Limits the displacements of free points in a substep. A point whose displacement is not finite does not move.
/// Returns the number of limited points.
int limit_motion(ThesisPoints& points, double limit) {
  int limited = 0;
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    const Vec2 start = points.substep_start[p];
    const Vec2 motion = points.positions[p] - start;
    if (points.inverse_mass[p] == 0.0 || dot(motion, motion) <= limit * limit) continue;
    const double displacement = length(motion);
    points.positions[p] = std::isfinite(displacement) ? start + (limit / displacement) * motion : start;
    ++limited;
  }
  return limited;
}

void find_velocities(ThesisPoints& points, double dt) {
  const double inverse_dt = 1.0 / dt;
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    points.velocities[p] = inverse_dt * (points.positions[p] - points.substep_start[p]);
  }
}

/// One of the N substeps. `fraction` is the part of the step that is over at its end.
struct Substep {
  double fraction;
  double dt;            // s
  double motion_limit;  // m
};

void advance(ThesisParts& cord, const Substep& substep, Vec2 gravity, const Surroundings& surroundings,
             StepReport& report) {
  const ThesisDef& def = cord.def;
  const double dt = substep.dt;
  ThesisPoints& points = cord.points;
  BodyMotions& bodies = cord.bodies;
  points.substep_start = points.positions;
  move_driven_points(points, substep.fraction);
  predict(points, def.drag, dt, gravity);
  bodies.predict(dt, surroundings);
  if (cord.fem && !cord.fem->deform(points, dt)) ++report.fem_skipped;
  if (def.spring_stiffness > 0.0) {
    correct_springs(cord.mesh.connections, def.spring_stiffness, dt, points.inverse_mass, points.positions);
  }
  if (!surroundings.grips.empty()) bodies.pull_grips(points, dt, surroundings);
  if (def.area_stiffness > 0.0) {
    correct_areas(cord.mesh.triangles, def.area_floor, def.area_stiffness, points.inverse_mass, points.positions);
  }
  if (cord.self_collision) report.self_contacts += cord.self_collision->collide(points);
  if (!surroundings.circles.empty()) report.circle_contacts += bodies.collide_with_circles(points, dt, surroundings);
  report.motion_limited += limit_motion(points, substep.motion_limit);
  find_velocities(points, dt);
  bodies.finish_substep(dt, surroundings);
}

}  // namespace

/// Goto 2017, Fig. 3.6, with N substeps of dt/N. Inertia is part of every substep: with inertia
/// once a step the cord would freeze as N grows, and with the full dt in each iteration time would run N-fold.
StepReport ThesisCord::step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  ThesisParts& cord = *parts_;
  check_step(dt, gravity);
  check_bodies(surroundings.bodies);
  check_surroundings(surroundings, surroundings.bodies.size(), cord.mesh.size());
  if (surroundings.medium != nullptr) {
    throw DefinitionError("medium is set; accepted is none, because the thesis's solver knows no wind and water");
  }
  StepReport report;
  cord.points.step_start = cord.points.positions;
  cord.bodies.begin_step(surroundings);
  if (cord.self_collision) report.tangled_columns = cord.self_collision->begin_step(cord.points);
  const ThesisEnergy before = energy(cord, gravity, surroundings);
  const int substeps = cord.def.substeps;
  const double substep_dt = dt / substeps;
  const double limit = motion_limit(cord.points, cord.def.spacing, dt, substep_dt);
  for (int k = 1; k <= substeps; ++k) {
    advance(cord, {static_cast<double>(k) / substeps, substep_dt, limit}, gravity, surroundings, report);
  }
  cord.bodies.report_motions(surroundings);
  report_gain(cord, before, gravity, surroundings, report);
  report_shape(cord, report);
  return report;
}

}  // namespace ribbon
