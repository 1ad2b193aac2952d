#include <algorithm>
#include <cmath>

#include "ribbon/thesis/bar.h"
#include "ribbon/thesis/broad_phase.h"
#include "ribbon/thesis/contact.h"
#include "ribbon/thesis/corrections.h"
#include "ribbon/thesis/tangle.h"
#include "ribbon/thesis/thesis_cord.h"

namespace ribbon {
namespace {

constexpr double max_self_push_in_radii = 0.5;      // per pair; more would throw a crumpled cord apart
constexpr double max_rigid_push_in_radii = 0.5;     // per pair
constexpr double max_grip_pull_in_spacings = 0.25;  // per substep; so a grip that was moved far does not kick its body
constexpr double max_drag_speed_ratio = 2.0;        // speed of a free point over that of the fastest driven point

}  // namespace

/// Goto 2017, Fig. 3.6, with N substeps of dt/N. Inertia is part of every substep: with inertia
/// once a step the cord would freeze as N grows, and with the full dt in each iteration time would run N-fold.
StepReport ThesisCord::step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  check_step(dt, gravity);
  check_bodies(surroundings.bodies);
  check_surroundings(surroundings, surroundings.bodies.size(), mesh_->size());
  begin_step(surroundings);
  const Energy before = energy(gravity, surroundings);
  const double substep_dt = dt / def_.substeps;
  driven_speed_ = 0.0;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (inverse_mass_[p] == 0.0) driven_speed_ = std::max(driven_speed_, length(targets_[p] - step_start_[p]) / dt);
  }
  for (int iteration = 1; iteration <= def_.substeps; ++iteration) {
    substep(iteration, substep_dt, gravity, surroundings);
  }
  report_motions(surroundings);
  report_gain(before, gravity, surroundings);
  report_shape();
  return report_;
}

void ThesisCord::substep(int iteration, double dt, Vec2 gravity, const Surroundings& surroundings) {
  substep_start_ = positions_;
  move_driven_points(iteration);
  predict(dt, gravity, surroundings);
  if (def_.bar_damping > 0.0) deform_by_fem(dt);
  if (def_.spring_stiffness > 0.0) {
    correct_springs(mesh_->connections, def_.spring_stiffness, dt, inverse_mass_, positions_);
  }
  if (!surroundings.grips.empty()) pull_grips(dt, surroundings);
  if (def_.area_stiffness > 0.0) {
    correct_areas(mesh_->triangles, def_.area_floor, def_.area_stiffness, inverse_mass_, positions_);
  }
  if (def_.self_collision) collide_with_itself();
  if (!surroundings.circles.empty()) collide_with_circles(dt, surroundings);
  limit_motion(dt);
  finish_substep(dt, surroundings);
}

void ThesisCord::begin_step(const Surroundings& surroundings) {
  report_ = {};
  step_start_ = positions_;
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

  if (def_.self_collision) {
    self_phase_->begin();
    self_phase_->update(positions_, positions_, own_radii_);
    report_.tangled_columns = find_tangled_columns(*mesh_, positions_, *self_phase_, tangled_);
  }
  if (surroundings.circles.empty()) return;
  reserve(surroundings.bodies.size(), surroundings.circles.size(), surroundings.grips.size());
  circle_phase_->begin();
}

/// Moves constrained and operated points to their targets, in a straight line and evenly over the substeps.
void ThesisCord::move_driven_points(int iteration) {
  const double fraction = static_cast<double>(iteration) / def_.substeps;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (inverse_mass_[p] == 0.0) positions_[p] = step_start_[p] + fraction * (targets_[p] - step_start_[p]);
  }
}

/// P = R + δ·v/(1 + c·δ) + δ²·g. The implicit factor 1/(1 + c·δ) replaces e^{−cδ}: it is equal to first order, positive
/// for any c, and needs no library function whose last bit differs between machines.
void ThesisCord::predict(double dt, Vec2 gravity, const Surroundings& surroundings) {
  const double decay = 1.0 / (1.0 + def_.drag * dt);
  const Vec2 fall = (dt * dt) * gravity;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (inverse_mass_[p] > 0.0) positions_[p] = substep_start_[p] + (dt * decay) * velocities_[p] + fall;
  }
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    BodyMotion& motion = motions_[b];
    if (surroundings.bodies[b].inverse_mass > 0.0) motion.velocity += dt * surroundings.bodies[b].acceleration;
    motion.position += dt * motion.velocity;
    motion.rotation = dt * motion.angular_velocity;
  }
  for (std::size_t k = 0; k < circle_centers_.size(); ++k) {
    const BodyMotion& motion = motions_[index(surroundings.circles[k].body)];
    circle_centers_before_[k] = motion.position - dt * motion.velocity + circle_offsets_[k];
  }
}

/// Goto 2017, section 3.4, Eqs. 3.16–3.19 with the restoring sign and with inertia in the matrix that is solved:
/// U = P − R, F = −K·U on free rows, (K_ff + M/δ²)·U′ = F, P += U′, with K = η/δ for a bar. U is the increment of this
/// substep. So FEM is an implicit damper of the bar lengths; only the springs restore the shape.
void ThesisCord::deform_by_fem(double dt) {
  assemble(dt);
  if (!solver_->solve(*matrix_, force_)) {
    ++report_.fem_skipped;
    return;
  }
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (inverse_mass_[p] > 0.0) positions_[p] += {force_[2 * p], force_[2 * p + 1]};
  }
}

/// Assembles the global matrix and force, Eqs. 3.12–3.15 and 3.17. Directions are those at R, which conserves angular
/// momentum.
void ThesisCord::assemble(double dt) {
  const double k = def_.bar_damping / dt;
  const double inertia = def_.point_mass / (dt * dt);
  matrix_->set_zero();
  for (int row = 0; row < matrix_->size(); ++row) matrix_->row(row)[0] = inertia;
  std::fill(force_.begin(), force_.end(), 0.0);
  for (const Connection& bar : mesh_->connections) {
    const std::size_t a = index(bar.a);
    const std::size_t b = index(bar.b);
    const Vec2 ab = substep_start_[b] - substep_start_[a];
    const double size = length(ab);
    if (size == 0.0) continue;  // it has no direction
    const Vec2 direction = (1.0 / size) * ab;
    const bool free_a = inverse_mass_[a] > 0.0;
    const bool free_b = inverse_mass_[b] > 0.0;
    add_bar_stiffness(*matrix_, bar.a, bar.b, direction, k, free_a, free_b);
    const Vec2 pull = bar_force(direction, k, positions_[a] - substep_start_[a], positions_[b] - substep_start_[b]);
    if (free_a) {
      force_[2 * a] += pull.x;
      force_[2 * a + 1] += pull.y;
    }
    if (free_b) {
      force_[2 * b] -= pull.x;
      force_[2 * b + 1] -= pull.y;
    }
  }
}

/// Pulls each held point and the anchor of its grip together, both in proportion to their inverse masses.
void ThesisCord::pull_grips(double dt, const Surroundings& surroundings) {
  for (std::size_t k = 0; k < surroundings.grips.size(); ++k) {
    const Grip& grip = surroundings.grips[k];
    RigidBody& body = surroundings.bodies[index(grip.body)];
    BodyMotion& motion = motions_[index(grip.body)];
    grip_offsets_[k] += (1.0 / def_.substeps) * grip.travel;
    const Vec2 arm = rotated(motion, grip_offsets_[k]);
    const Vec2 offset = positions_[index(grip.point)] - (motion.position + arm);
    const double size = length(offset);
    if (size == 0.0) continue;
    const Vec2 direction = (1.0 / size) * offset;
    const double turn = cross(arm, direction);
    const double w_point = inverse_mass_[index(grip.point)];
    const double w = w_point + body.inverse_mass + body.inverse_inertia * turn * turn;
    if (w == 0.0) continue;
    const double lambda = std::min(size, max_grip_pull_in_spacings * def_.spacing) / w;
    positions_[index(grip.point)] -= (lambda * w_point) * direction;
    apply_impulse(body, motion, arm, (lambda / dt) * direction, dt);
  }
}

/// Applies an impulse [N·s] at `arm` [m] from the centre of mass: to the motion of the body in this substep, and to the
/// sum of its impulses.
void ThesisCord::apply_impulse(RigidBody& body, BodyMotion& motion, Vec2 arm, Vec2 impulse, double dt) {
  const double twist = cross(arm, impulse);
  motion.velocity += body.inverse_mass * impulse;
  motion.position += (dt * body.inverse_mass) * impulse;
  motion.rotation += dt * body.inverse_inertia * twist;
  body.impulse += impulse;
  body.angular_impulse += twist;
}

/// Goto 2017, section 3.6: the circle of each point against the triangles that are not its own. Tangled columns have no
/// contact with each other.
void ThesisCord::collide_with_itself() {
  self_phase_->update(positions_, positions_, own_radii_);
  const auto is_tangled = [this](int point) { return tangled_[index(mesh_->column(point))] != 0; };
  const double max_push = max_self_push_in_radii * def_.radius;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    for (const int triangle : self_phase_->near(p)) {
      if (self_phase_->is_own(p, triangle)) continue;
      if (is_tangled(static_cast<int>(p)) && is_tangled(mesh_->triangles[index(triangle)].a)) continue;
      const Circle circle{positions_[p], substep_start_[p], def_.radius, static_cast<int>(p)};
      const auto contact = find_contact(*mesh_, mesh_->triangles[index(triangle)], positions_, circle);
      if (!contact) continue;
      const double lambda = push_apart(*contact, inverse_mass_[p], max_push, inverse_mass_, positions_);
      positions_[p] += (lambda * inverse_mass_[p]) * contact->direction;
      ++report_.self_contacts;
    }
  }
}

/// Goto 2017, section 3.7: rigid circles against triangles by the same test and response; both sides move.
void ThesisCord::collide_with_circles(double dt, const Surroundings& surroundings) {
  const auto center = [&](std::size_t k) {
    const BodyMotion& motion = motions_[index(surroundings.circles[k].body)];
    return motion.position + rotated(motion, circle_offsets_[k]);
  };
  for (std::size_t k = 0; k < circle_centers_.size(); ++k) circle_centers_[k] = center(k);
  circle_phase_->update(positions_, circle_centers_, circle_radii_);
  for (std::size_t k = 0; k < circle_centers_.size(); ++k) {
    const auto body_index = index(surroundings.circles[k].body);
    RigidBody& body = surroundings.bodies[body_index];
    BodyMotion& motion = motions_[body_index];
    for (const int triangle : circle_phase_->near(k)) {
      const Circle circle{center(k), circle_centers_before_[k], circle_radii_[k]};
      const auto contact = find_contact(*mesh_, mesh_->triangles[index(triangle)], positions_, circle);
      if (!contact) continue;
      const Vec2 arm = rotated(motion, circle_offsets_[k]);
      const double turn = cross(arm, contact->direction);
      const double w_circle = body.inverse_mass + body.inverse_inertia * turn * turn;
      const double lambda =
          push_apart(*contact, w_circle, max_rigid_push_in_radii * circle_radii_[k], inverse_mass_, positions_);
      apply_impulse(body, motion, arm, (lambda / dt) * contact->direction, dt);
      ++report_.circle_contacts;
    }
  }
}

/// Limits the displacement of free points in a substep to a spacing, or to twice that of the fastest driven point.
/// Without a limit, self-contact under a yank feeds on itself. A point whose displacement is not finite does not move.
void ThesisCord::limit_motion(double dt) {
  const double limit = std::max(def_.spacing, max_drag_speed_ratio * driven_speed_ * dt);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    const Vec2 motion = positions_[p] - substep_start_[p];
    if (inverse_mass_[p] == 0.0 || dot(motion, motion) <= limit * limit) continue;
    const double displacement = length(motion);
    positions_[p] =
        std::isfinite(displacement) ? substep_start_[p] + (limit / displacement) * motion : substep_start_[p];
    ++report_.motion_limited;
  }
}

void ThesisCord::finish_substep(double dt, const Surroundings& surroundings) {
  const double inverse_dt = 1.0 / dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) velocities_[p] = inverse_dt * (positions_[p] - substep_start_[p]);
  for (BodyMotion& motion : motions_) {
    motion.angular_velocity = inverse_dt * motion.rotation;
    motion.total_rotation += motion.rotation;
  }
  const auto rotate = [&](Vec2& offset, int body) {
    const double size = length(offset);
    const Vec2 turned = rotated(motions_[index(body)], offset);
    const double stretched = length(turned);
    if (stretched > 0.0) offset = (size / stretched) * turned;  // keeps the length of the offset
  };
  for (std::size_t k = 0; k < circle_offsets_.size(); ++k) rotate(circle_offsets_[k], surroundings.circles[k].body);
  for (std::size_t k = 0; k < grip_offsets_.size(); ++k) rotate(grip_offsets_[k], surroundings.grips[k].body);
}

void ThesisCord::report_motions(const Surroundings& surroundings) const {
  for (const Grip& grip : surroundings.grips) {
    RigidBody& body = surroundings.bodies[index(grip.body)];
    body.moved = motions_[index(grip.body)].position - body.position;
    body.turned = motions_[index(grip.body)].total_rotation;
  }
}

}  // namespace ribbon
