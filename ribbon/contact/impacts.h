#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/contact/active_contacts.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

/// The pairs that had a contact force in a substep, their impulses, and their restitution.
class Impacts {
 public:
  void clear();
  /// Starts a substep: no pair has had a force yet. Impulses remain, because a substep may be a part of another.
  void begin_substep(const ContactPairs& pairs);
  /// Adds to the impulse of a pair, N·s.
  void record(std::size_t pair, double impulse);
  /// Starts a step: pushes are recorded in it or not.
  void record_pushes(bool wanted) { records_pushes_ = wanted; }
  bool records_pushes() const { return records_pushes_; }
  /// An impulse on the disc of a pair, and where it acted last.
  struct Push {
    Vec2 impulse;  // N·s
    Vec2 normal;   // see Touch
    Vec2 point;    // m, the same
  };
  /// Adds to the impulse that the disc of a pair gets.
  void record_push(std::size_t pair, const Push& push);
  /// Multiplies all impulses; 0 clears them.
  void scale_impulses(double factor);
  /// N·s.
  double impulse(std::size_t pair) const { return impulses_[pair]; }
  /// What the disc of a pair got. Pushes must be recorded.
  const Push& push(std::size_t pair) const { return pushes_[pair]; }
  bool any() const;
  /// Returns whether any of the pairs contains a kinematic body.
  bool touch_kinematic(const ContactScene& scene) const;

  /// Finds the pairs that approached faster than 0.1 m/s, by velocities `before` and `after` the substep, by slot. They
  /// become the active contacts at x. Until end_restitution(), load() gives the step in dt [s] after which each pair
  /// separates at e times the speed of its approach, or not at all if that was below 0.5 m/s. Returns whether there are
  /// any.
  bool find_restitution(const ContactScene& scene, std::span<const Vec2> x, std::span<const Vec2> before,
                        std::span<const Vec2> after, double dt, ActiveContacts& active);
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

  std::vector<char> is_hit_;         // by pair
  std::vector<double> impulses_;     // N·s, by pair
  std::vector<double> separations_;  // m, of the active contacts, during restitution
  bool records_pushes_ = false;
  std::vector<Push> pushes_;                               // by pair
  std::vector<std::pair<std::size_t, Push>> restitution_;  // pairs, and what their discs get in the solution, in N
};

}  // namespace ribbon
