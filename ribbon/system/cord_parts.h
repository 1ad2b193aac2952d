#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "ribbon/cord_sweep.h"
#include "ribbon/elastic/elasticity.h"

namespace ribbon {

/// How far a cord runs through a groove in the step, if its points there would not be enough.
struct WheelReach {
  double before = 0.0;    ///< m, towards its last point
  double after = 0.0;     ///< m, towards its first one
  bool blocks = false;    ///< it cannot run so far
  int motor_changes = 0;  ///< times that its motor or brake was found to act otherwise than assumed
};

/// What a Cord consists of: the solver works on it directly. Whatever else changes a cord goes through Cord, which
/// checks values.
struct CordParts {
  static constexpr int max_newton_pause = 16;  // of Cord::State::newton_pause

  explicit CordParts(const CordDef& cord_def);
  /// Becomes a new cord of its definition, which was changed, in the same memory. A rope without bending stiffness
  /// allocates nothing if it had as many points at any time since `reserve`.
  void renew();
  /// Reserves memory for everything that a cord with its number of points may have.
  void reserve();

  std::size_t size() const { return state.positions.size(); }
  bool is_reeling() const { return !state.rest_targets.empty() && state.rest != state.rest_targets; }
  /// Returns whether the rest lengths of this step are those of overstretched links; see system/overstretch.h.
  bool is_overstretched() const { return !own_rest_start.empty(); }
  /// Returns whether it collides with other cords.
  bool meets_cords() const { return def.cord_contact || (def.self_contact && state.family != 0); }
  /// Returns whether it is a piece of the same cord as another.
  bool is_piece_with(const CordParts& other) const { return state.family != 0 && state.family == other.state.family; }
  /// Returns whether it collides with that other cord. Pieces of one cord do so if the cord collided with itself, but
  /// not those of a cut along a row, whose edges lie in each other.
  bool meets(const CordParts& other) const {
    if (is_piece_with(other)) return def.self_contact && !state.split && !other.state.split;
    return def.cord_contact && other.def.cord_contact;
  }
  /// Returns the positions, and the velocities whose damping the tensions include.
  Motion motion_of_tensions() const;
  /// Returns the mass that a point has more because a hand near it has changed the rest lengths of its links, kg (see
  /// island/rings.h); 0 for a ribbon, and for a rope that was reeled, of which they do not tell.
  double mass_by_ring(std::size_t point) const;
  /// Returns the energies under `gravity` [m/s²].
  CordEnergy energy(Vec2 gravity) const;
  /// Returns the tension of a link, N; see tension_of.
  double tension(std::size_t link) const;
  /// Returns the force that moves a driven point as it moves; see reaction().
  Vec2 holding_force(std::size_t point, Vec2 gravity) const;
  /// Returns box, highest speed and elastic energy; see CordSweep. O(points).
  CordSweep find_sweep() const;
  /// Stores them until the cord is changed.
  void remember_sweep();

  /// Call it after a change from outside: the next step uses no stored results, and the cord is awake.
  void disturb();
  void wake();
  /// Puts the cord to sleep: stops what is left of its motion.
  void fall_asleep();
  /// Takes the damping part out of the tensions. That part jumps with a velocity that is set from outside; the elastic
  /// part does not.
  void exclude_damping();
  /// Adds the damping part of the current velocities again.
  void include_damping();
  /// Leaves the links at and on the wheels of pulleys to these. Call it when points have moved over a wheel.
  void leave_out_links_on_wheels();
  /// Returns whether a link is left to a wheel.
  bool is_on_wheel(std::size_t link) const { return !on_wheels.empty() && on_wheels[link] != 0; }

  std::optional<CordSweep> sweep;  // of this state, if it is known; first, because resting cords are asked for it
  CordDef def;
  std::unique_ptr<Elasticity> elasticity;
  Cord::State state;               // `unlocked` is empty: the elasticity stores it
  std::vector<double> own_masses;  // kg, by point, without attached masses
  // m, rest lengths by link at the start and at the end of the step; empty until something is reeled or overstretched.
  std::vector<double> rest_start, rest_end;
  std::vector<double> own_rest_start, own_rest_end;  // the same without overstretched links; empty if none is
  std::vector<char> on_wheels;                       // by link: 1 if it is left to a wheel; empty without pulleys
  std::vector<WheelReach> reaches;                   // by pulley, in a step
  bool has_rings = false;                            // in a step: its wheels are rings, see island/rings.h
  std::vector<int> outline;                          // the points around which the cord can be touched, in order

 private:
  void start();
};

}  // namespace ribbon
