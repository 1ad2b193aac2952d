#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ribbon/rigid_circle.h"
#include "ribbon/thesis/broad_phase.h"
#include "ribbon/thesis/mesh.h"
#include "ribbon/thesis/thesis_def.h"
#include "ribbon/thesis/thesis_points.h"

namespace ribbon {

/// Motion of a body within a step. Of the RigidBody itself only the impulses change.
struct BodyMotion {
  Vec2 position;            ///< m, of the centre of mass
  Vec2 velocity;            ///< m/s
  double angular_velocity;  ///< rad/s
  double rotation;          ///< rad, in this substep
  double total_rotation;    ///< rad, in all substeps so far

  /// Returns an offset from the centre of mass after the rotation in this substep, to first order.
  Vec2 rotated(Vec2 offset) const { return offset + rotation * perp(offset); }
};

/// Moves the bodies around a cord in a step, with their circles and with the anchors of their grips. All functions of a
/// step get the same surroundings. The definition and the mesh must outlive it.
class BodyMotions {
 public:
  BodyMotions(const ThesisDef& def, const Mesh& mesh) : def_(&def), mesh_(&mesh) {}

  /// Reserves memory for steps with so many items in the surroundings.
  void reserve(std::size_t bodies, std::size_t circles, std::size_t grips);

  /// Starts a step: bodies have the impulses that they got before.
  void begin_step(const Surroundings& surroundings);
  /// Moves the bodies by their velocities and accelerations in a substep.
  void predict(double dt, const Surroundings& surroundings);
  /// Pulls each held point and the anchor of its grip together, both in proportion to their inverse masses.
  void pull_grips(ThesisPoints& points, double dt, const Surroundings& surroundings);
  /// Goto 2017, section 3.7: rigid circles against triangles by the same test and response as in 3.6; both sides move.
  /// Returns the number of contacts.
  int collide_with_circles(ThesisPoints& points, double dt, const Surroundings& surroundings);
  /// Ends a substep: finds the angular velocities, and rotates the offsets of circles and anchors.
  void finish_substep(double dt, const Surroundings& surroundings);
  /// Writes the displacement of each body that holds the cord.
  void report_motions(const Surroundings& surroundings) const;

  /// Returns the motions, by index of the body.
  std::span<const BodyMotion> motions() const { return motions_; }

 private:
  const ThesisDef* def_;
  const Mesh* mesh_;
  std::optional<BroadPhase> broad_phase_;  // exists from the first circle on
  std::vector<BodyMotion> motions_;
  std::vector<Vec2> circle_offsets_;
  std::vector<Vec2> circle_centers_;
  std::vector<Vec2> circle_centers_before_;
  std::vector<double> circle_radii_;
  std::vector<Vec2> grip_offsets_;
};

}  // namespace ribbon
