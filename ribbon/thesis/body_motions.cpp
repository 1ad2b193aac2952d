#include "ribbon/thesis/body_motions.h"

#include <algorithm>

#include "ribbon/linear/index.h"
#include "ribbon/thesis/contact.h"

namespace ribbon {
namespace {

constexpr double max_grip_pull_in_spacings = 0.25;  // per substep; so a grip that was moved far does not kick its body

/// Applies an impulse [N·s] at `arm` [m] from the centre of mass: to the motion of the body in this substep, and to the
/// sum of its impulses.
void apply_impulse(RigidBody& body, BodyMotion& motion, Vec2 arm, Vec2 impulse, double dt) {
  const double twist = cross(arm, impulse);
  motion.velocity += body.inverse_mass * impulse;
  motion.position += (dt * body.inverse_mass) * impulse;
  motion.rotation += dt * body.inverse_inertia * twist;
  body.impulse += impulse;
  body.angular_impulse += twist;
}

}  // namespace

void BodyMotions::reserve(std::size_t bodies, std::size_t circles, std::size_t grips) {
  motions_.reserve(bodies);
  circle_offsets_.reserve(circles);
  circle_radii_.reserve(circles);
  circle_centers_.reserve(circles);
  circle_centers_before_.reserve(circles);
  grip_offsets_.reserve(grips);
  if (circles == 0) return;
  if (!broad_phase_) broad_phase_.emplace(*mesh_, false);
  broad_phase_->reserve(circles);
}

void BodyMotions::begin_step(const Surroundings& surroundings) {
  motions_.clear();
  for (const RigidBody& body : surroundings.bodies) {
    motions_.push_back({body.position, body.velocity + body.inverse_mass * body.impulse,
                        body.angular_velocity + body.inverse_inertia * body.angular_impulse, 0.0, 0.0});
  }
  circle_offsets_.clear();
  circle_radii_.clear();
  for (const RigidCircle& circle : surroundings.circles) {
    circle_offsets_.push_back(circle.offset);
    circle_radii_.push_back(circle.radius);
  }
  circle_centers_.resize(surroundings.circles.size());
  circle_centers_before_.resize(surroundings.circles.size());
  grip_offsets_.clear();
  for (const Grip& grip : surroundings.grips) grip_offsets_.push_back(grip.offset);
  if (surroundings.circles.empty()) return;
  reserve(surroundings.bodies.size(), surroundings.circles.size(), surroundings.grips.size());
  broad_phase_->begin();
}

void BodyMotions::predict(double dt, const Surroundings& surroundings) {
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    BodyMotion& motion = motions_[b];
    if (surroundings.bodies[b].inverse_mass > 0.0) motion.velocity += dt * surroundings.bodies[b].acceleration;
    motion.position += dt * motion.velocity;
    motion.rotation = dt * motion.angular_velocity;
  }
  for (std::size_t k = 0; k < circle_centers_.size(); ++k) {
    const BodyMotion& motion = motions_[at(surroundings.circles[k].body)];
    circle_centers_before_[k] = motion.position - dt * motion.velocity + circle_offsets_[k];
  }
}

void BodyMotions::pull_grips(ThesisPoints& points, double dt, const Surroundings& surroundings) {
  for (std::size_t k = 0; k < surroundings.grips.size(); ++k) {
    const Grip& grip = surroundings.grips[k];
    RigidBody& body = surroundings.bodies[at(grip.body)];
    BodyMotion& motion = motions_[at(grip.body)];
    grip_offsets_[k] += (1.0 / def_->substeps) * grip.travel;
    const Vec2 arm = motion.rotated(grip_offsets_[k]);
    const Vec2 offset = points.positions[at(grip.point)] - (motion.position + arm);
    const double size = length(offset);
    if (size == 0.0) continue;
    const Vec2 direction = (1.0 / size) * offset;
    const double turn = cross(arm, direction);
    const double w_point = points.inverse_mass[at(grip.point)];
    const double w = w_point + body.inverse_mass + body.inverse_inertia * turn * turn;
    if (w == 0.0) continue;
    const double lambda = std::min(size, max_grip_pull_in_spacings * def_->spacing) / w;
    points.positions[at(grip.point)] -= (lambda * w_point) * direction;
    apply_impulse(body, motion, arm, (lambda / dt) * direction, dt);
  }
}

int BodyMotions::collide_with_circles(ThesisPoints& points, double dt, const Surroundings& surroundings) {
  const auto center = [&](std::size_t k) {
    const BodyMotion& motion = motions_[at(surroundings.circles[k].body)];
    return motion.position + motion.rotated(circle_offsets_[k]);
  };
  for (std::size_t k = 0; k < circle_centers_.size(); ++k) circle_centers_[k] = center(k);
  broad_phase_->update(points.positions, circle_centers_, circle_radii_);
  int contacts = 0;
  for (std::size_t k = 0; k < circle_centers_.size(); ++k) {
    const std::size_t index = at(surroundings.circles[k].body);
    RigidBody& body = surroundings.bodies[index];
    BodyMotion& motion = motions_[index];
    for (const int triangle : broad_phase_->near(k)) {
      const Circle circle{center(k), circle_centers_before_[k], circle_radii_[k]};
      const auto contact = find_contact(*mesh_, mesh_->triangles[at(triangle)], points.positions, circle);
      if (!contact) continue;
      const Vec2 arm = motion.rotated(circle_offsets_[k]);
      const double turn = cross(arm, contact->direction);
      const double w_circle = body.inverse_mass + body.inverse_inertia * turn * turn;
      const double lambda =
          push_apart(*contact, w_circle, max_push_in_radii * circle_radii_[k], points.inverse_mass, points.positions);
      apply_impulse(body, motion, arm, (lambda / dt) * contact->direction, dt);
      ++contacts;
    }
  }
  return contacts;
}

void BodyMotions::finish_substep(double dt, const Surroundings& surroundings) {
  const double inverse_dt = 1.0 / dt;
  for (BodyMotion& motion : motions_) {
    motion.angular_velocity = inverse_dt * motion.rotation;
    motion.total_rotation += motion.rotation;
  }
  const auto rotate = [&](Vec2& offset, int body) {
    const double size = length(offset);
    const Vec2 turned = motions_[at(body)].rotated(offset);
    const double stretched = length(turned);
    if (stretched > 0.0) offset = (size / stretched) * turned;  // keeps the length of the offset
  };
  for (std::size_t k = 0; k < circle_offsets_.size(); ++k) rotate(circle_offsets_[k], surroundings.circles[k].body);
  for (std::size_t k = 0; k < grip_offsets_.size(); ++k) rotate(grip_offsets_[k], surroundings.grips[k].body);
}

void BodyMotions::report_motions(const Surroundings& surroundings) const {
  for (const Grip& grip : surroundings.grips) {
    RigidBody& body = surroundings.bodies[at(grip.body)];
    body.moved = motions_[at(grip.body)].position - body.position;
    body.turned = motions_[at(grip.body)].total_rotation;
  }
}

}  // namespace ribbon
