#include <algorithm>
#include <cmath>

#include "ribbon/thesis/thesis_cord.h"

// The checks of a step: energy, strain and inverted triangles.

namespace ribbon {
namespace {

constexpr double max_strain = 0.1;       // of a bar that is not counted as strained
constexpr double tolerated_gain = 1e-3;  // relative to the kinetic and elastic energy plus M·(g·L + speed_scale²)
constexpr double speed_scale = 1e-3;     // m/s

}  // namespace

/// Returns the energy of the cord and of the bodies, as they move in this step.
ThesisCord::Energy ThesisCord::energy(Vec2 gravity, const Surroundings& surroundings) const {
  Energy sum;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    sum.kinetic_and_elastic += 0.5 * def_.point_mass * dot(velocities_[p], velocities_[p]);
    sum.potential -= def_.point_mass * dot(gravity, positions_[p]);
  }
  for (const Connection& bar : mesh_->connections) {
    const double stretch = length(positions_[index(bar.b)] - positions_[index(bar.a)]) - bar.rest_length;
    sum.kinetic_and_elastic += 0.5 * def_.spring_stiffness * stretch * stretch;
  }
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    const RigidBody& body = surroundings.bodies[b];
    const BodyMotion& motion = motions_[b];
    if (body.inverse_mass == 0.0) continue;
    sum.kinetic_and_elastic += 0.5 * dot(motion.velocity, motion.velocity) / body.inverse_mass;
    sum.potential -= dot(body.acceleration, motion.position) / body.inverse_mass;
    if (body.inverse_inertia == 0.0) continue;
    sum.kinetic_and_elastic += 0.5 * motion.angular_velocity * motion.angular_velocity / body.inverse_inertia;
  }
  return sum;
}

/// Returns whether a driven point, a kinematic body or a grip does work.
bool ThesisCord::is_driven(const Surroundings& surroundings) const {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (inverse_mass_[p] == 0.0 && !(targets_[p] == step_start_[p])) return true;
  }
  const auto moves = [](const RigidBody& body) {
    return body.inverse_mass == 0.0 && (!(body.velocity == Vec2{}) || body.angular_velocity != 0.0);
  };
  const auto travels = [](const Grip& grip) { return !(grip.travel == Vec2{}); };
  return std::any_of(surroundings.bodies.begin(), surroundings.bodies.end(), moves) ||
         std::any_of(surroundings.grips.begin(), surroundings.grips.end(), travels);
}

void ThesisCord::report_gain(const Energy& before, Vec2 gravity, const Surroundings& surroundings) {
  if (is_driven(surroundings)) return;
  const double mass = def_.point_mass * mesh_->size();
  const double scale = mass * (length(gravity) * def_.spacing * (def_.w - 1) + speed_scale * speed_scale);
  const double tolerated = tolerated_gain * (scale + before.kinetic_and_elastic);
  if (!(energy(gravity, surroundings).total() - before.total() <= tolerated)) report_.energy_gains = 1;
}

void ThesisCord::report_shape() {
  for (const Connection& bar : mesh_->connections) {
    const double size = length(positions_[index(bar.b)] - positions_[index(bar.a)]);
    if (!(std::abs(size - bar.rest_length) <= max_strain * bar.rest_length)) ++report_.strained_bars;
  }
  for (const Triangle& triangle : mesh_->triangles) {
    const Vec2 a = positions_[index(triangle.a)];
    if (!(cross(positions_[index(triangle.b)] - a, positions_[index(triangle.c)] - a) >= 0.0)) ++report_.turned_over;
  }
}

}  // namespace ribbon
