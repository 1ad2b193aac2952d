#include "ribbon/thesis/thesis_report.h"

#include <algorithm>
#include <cmath>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double max_strain = 0.1;       // of a bar that is not counted as strained
constexpr double tolerated_gain = 1e-3;  // relative to the kinetic and elastic energy plus M·(g·L + speed_scale²)
constexpr double speed_scale = 1e-3;     // m/s

double length_of(const Connection& bar, const std::vector<Vec2>& x) { return length(x[at(bar.b)] - x[at(bar.a)]); }

/// Returns whether a driven point, a kinematic body or a grip does work.
bool is_driven(const ThesisPoints& points, const Surroundings& surroundings) {
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    if (points.inverse_mass[p] == 0.0 && !(points.targets[p] == points.step_start[p])) return true;
  }
  const auto moves = [](const RigidBody& body) {
    return body.inverse_mass == 0.0 && (!(body.velocity == Vec2{}) || body.angular_velocity != 0.0);
  };
  const auto travels = [](const Grip& grip) { return !(grip.travel == Vec2{}); };
  return std::any_of(surroundings.bodies.begin(), surroundings.bodies.end(), moves) ||
         std::any_of(surroundings.grips.begin(), surroundings.grips.end(), travels);
}

}  // namespace

ThesisEnergy energy(const ThesisParts& cord, Vec2 gravity, const Surroundings& surroundings) {
  const ThesisDef& def = cord.def;
  const ThesisPoints& points = cord.points;
  ThesisEnergy sum;
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    sum.kinetic_and_elastic += 0.5 * def.point_mass * dot(points.velocities[p], points.velocities[p]);
    sum.potential -= def.point_mass * dot(gravity, points.positions[p]);
  }
  for (const Connection& bar : cord.mesh.connections) {
    const double stretch = length_of(bar, points.positions) - bar.rest_length;
    sum.kinetic_and_elastic += 0.5 * def.spring_stiffness * stretch * stretch;
  }
  const auto motions = cord.bodies.motions();
  for (std::size_t b = 0; b < motions.size(); ++b) {
    const RigidBody& body = surroundings.bodies[b];
    const BodyMotion& motion = motions[b];
    if (body.inverse_mass == 0.0) continue;
    sum.kinetic_and_elastic += 0.5 * dot(motion.velocity, motion.velocity) / body.inverse_mass;
    sum.potential -= dot(body.acceleration, motion.position) / body.inverse_mass;
    if (body.inverse_inertia == 0.0) continue;
    sum.kinetic_and_elastic += 0.5 * motion.angular_velocity * motion.angular_velocity / body.inverse_inertia;
  }
  return sum;
}

void report_gain(const ThesisParts& cord, const ThesisEnergy& before, Vec2 gravity, const Surroundings& surroundings,
                 StepReport& report) {
  if (is_driven(cord.points, surroundings)) return;
  const ThesisDef& def = cord.def;
  const double mass = def.point_mass * cord.mesh.size();
  const double scale = mass * (length(gravity) * def.spacing * (def.w - 1) + speed_scale * speed_scale);
  const double tolerated = tolerated_gain * (scale + before.kinetic_and_elastic);
  if (!(energy(cord, gravity, surroundings).total() - before.total() <= tolerated)) report.energy_gains = 1;
}

void report_shape(const ThesisParts& cord, StepReport& report) {
  const std::vector<Vec2>& x = cord.points.positions;
  for (const Connection& bar : cord.mesh.connections) {
    if (!(std::abs(length_of(bar, x) - bar.rest_length) <= max_strain * bar.rest_length)) ++report.strained_bars;
  }
  for (const Triangle& triangle : cord.mesh.triangles) {
    const Vec2 a = x[at(triangle.a)];
    if (!(cross(x[at(triangle.b)] - a, x[at(triangle.c)] - a) >= 0.0)) ++report.turned_over;
  }
}

}  // namespace ribbon
