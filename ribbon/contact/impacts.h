#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/contact/active_contacts.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

/// Returns whether what moves with `velocity` [m/s] is at rest in the inertial frame that moves with `frame` [m/s], as
/// far as single precision can tell: targets and bodies have positions of that.
inline bool is_at_rest(Vec2 velocity, Vec2 frame) { return length(velocity - frame) <= 1e-4 * length(frame); }

/// Velocities by slot, m/s and rad/s, before and after a substep. Both contain those of RigidBody::pushed, `pushes`,
/// which is empty if there are none.
struct ImpactVelocities {
  std::span<const Vec2> before, after, pushes;
};

/// The pairs that had a contact force in a substep, their impulses, and their restitution.
class Impacts {
 public:
  void clear();
  /// Starts a substep, or a part of one. Impulses remain.
  void begin_substep(const ContactPairs& pairs);
  /// Returns to the impulses at its start.
  void return_to_start();
  /// Where a pair was hit last.
  struct Place {
    Vec2 normal;  // see Touch
    Vec2 point;   // m, the same
  };
  /// Adds to the impulse of a pair, N·s.
  void record(std::size_t pair, double impulse, const Place& place);
  /// Starts a step: pushes are recorded in it or not.
  void record_pushes(bool wanted) { records_pushes_ = wanted; }
  bool records_pushes() const { return records_pushes_; }
  /// Adds to the whole impulse that the disc of a pair gets, N·s.
  void record_push(std::size_t pair, Vec2 push, const Place& place);
  /// Multiplies all impulses; 0 clears them.
  void scale_impulses(double factor);
  /// N·s.
  double impulse(std::size_t pair) const { return impulses_[pair]; }
  /// Returns what the disc of a pair got, N·s; zero unless pushes are recorded.
  Vec2 push(std::size_t pair) const { return records_pushes_ ? pushes_[pair] : Vec2{}; }
  /// The pair must have been hit.
  const Place& place(std::size_t pair) const { return places_[pair]; }
  bool any() const;
  /// Returns whether any of the pairs contains a kinematic body.
  bool touch_kinematic(const ContactScene& scene) const;
  /// Returns whether any of the pairs contains a kinematic body that is not at rest in the inertial frame that moves
  /// with `frame` [m/s].
  bool touch_moving(const ContactScene& scene, Vec2 frame) const;
  /// Returns whether any of the pairs contains a surface that moves along itself.
  bool touch_belt(const ContactScene& scene) const;

  /// Finds the pairs that approached faster than 0.1 m/s, and those that a push has thrown apart. They become the
  /// active contacts at x. Until end_restitution(), load() gives the step in dt [s] after which each pair separates at
  /// e times the speed of its approach, or not at all if that was below 0.5 m/s; one that was separating before the
  /// push does so as fast as before. Returns whether there are any.
  bool find_restitution(const ContactScene& scene, std::span<const Vec2> x, const ImpactVelocities& velocities,
                        double dt, ActiveContacts& active);
  bool is_restituting() const { return !separations_.empty(); }
  /// Adds springs that open each contact by its separation to a linear system.
  void load(const ContactPairs& pairs, const ActiveContacts& active, const AnchorState& state, BlockLdlt& matrix,
            std::span<Vec2> force) const;
  /// Takes over the solution of that system, if pushes are recorded. `active` has its contacts at `state`.
  void take_restitution(const ContactPairs& pairs, const ActiveContacts& active, const AnchorState& state,
                        std::span<const Vec2> step);
  /// Adds the pushes of a restitution that is this share of the solution, in dt [s].
  void record_restitution(double share, double dt);
  void end_restitution() { separations_.clear(); }

 private:
  static double kinematic_speed(const ContactPair& pair, const Separation& gap, const AnchorState& state);

  struct Push {
    std::size_t pair;
    Vec2 force;  // N, on its disc in the solution
    Place place;
  };

  bool is_hit(std::size_t pair) const { return impulses_[pair] > 0.0; }

  std::vector<double> impulses_;        // N·s, by pair
  std::vector<double> start_impulses_;  // N·s, at the start of the substep
  std::vector<Place> places_;           // by pair
  std::vector<double> separations_;     // m, of the active contacts, during restitution
  bool records_pushes_ = false;
  std::vector<Vec2> pushes_;        // N·s, by pair
  std::vector<Vec2> start_pushes_;  // N·s, at the start of the substep
  std::vector<Push> restitution_;
};

}  // namespace ribbon
