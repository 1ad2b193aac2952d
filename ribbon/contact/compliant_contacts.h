#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/contact/active_contacts.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

/// Forces of each pair by the last linear solve. At the start of a substep the normal forces are the stored ones.
struct ContactForces {
  std::vector<double> normal;            // N, at least 0
  std::vector<double> unlimited_normal;  // N, the same before it is limited: negative if the pair separates
  std::vector<double> friction;          // N

  void reserve(std::size_t pairs);
  void begin_substep(const ContactPairs& pairs);
  /// Returns ½·Σ f²/k, J: the energy of all pairs by their normal forces.
  double energy(const ContactPairs& pairs) const;
};

/// The contacts at a state x, and what their slip is measured from.
struct ContactState {
  const ContactScene& scene;
  const ActiveContacts& active;
  const SlipReference& reference;
  std::span<const Vec2> x;

  AnchorState anchors() const { return active.state(scene.anchors, x); }
};

/// Contacts as a term of the Newton step. A pair in contact has the energy ½·k·depth². Friction is a spring of a tenth
/// of that stiffness, which slips where its force would exceed μ times the normal force (return mapping; Wriggers
/// 2006, 5.2).
class CompliantContacts {
 public:
  /// Stiffness of a contact times dt²/m, with m the mass that may press: at rest a body penetrates by the inverse of it
  /// times the distance that it would fall in a step.
  static constexpr double stiffness_factor = 2e3;
  /// The same for Accuracy::soft_contacts, which need less than half the Newton steps.
  static constexpr double soft_stiffness_factor = 1e2;

  /// Starts a substep. A friction spring near its limit is expected to slip, all others to stick.
  void begin_substep(const ContactPairs& pairs, const ContactForces& forces);
  /// Starts a stage: no contact has slipped yet.
  void begin_stage(const ContactPairs& pairs);
  /// Makes friction stick or slip by the state alone, because what the last solve predicts may lead uphill.
  void forget_predictions();

  /// Adds forces and the positive semidefinite part of the Hessian to a linear system.
  void load(const ContactState& state, const ContactForces& forces, BlockLdlt& matrix, std::span<Vec2> force);
  /// Takes over the solution of a linear system. It has the contacts for which load() was called last.
  void take_solution(const ContactPairs& pairs, const ActiveContacts& active, std::span<const Vec2> step,
                     ContactForces& forces);

  /// Returns the potential, J. Friction is limited by the normal forces of the last linear solve.
  static double potential(const ContactState& state, const ContactForces& forces);
  /// Returns the energy of the penetrations, J.
  static double energy(const ContactPairs& pairs, const ActiveContacts& active);
  /// Returns the friction at a contact that has a normal force [N], N along the tangent.
  static double friction_force(const ContactState& state, const ActiveContact& contact, double normal);
  /// Returns whether forces agree with those of the last linear solve to a thousandth of all forces, or to what moves
  /// a body by `tolerance` [m] in a step.
  static bool are_settled(const ContactState& state, const ContactForces& forces, double tolerance);
  /// Stores the forces and the elongations of friction springs with the pairs; `normal_forces` [N], by pair, replace
  /// those of the depths unless empty.
  static void store(const ContactState& state, std::span<const double> normal_forces, ContactPairs& pairs);

 private:
  /// Friction of a contact in a linear solve.
  struct Friction {
    SlotRow tangent{};
    double force = 0.0;      // N, along the tangent
    double stiffness = 0.0;  // N/m, by which the force changes in the solve
    bool sticks = false;
  };
  void load_normal(const ContactState& state, const ActiveContact& contact, double predicted, BlockLdlt& matrix,
                   std::span<Vec2> force);
  /// Returns whether a contact sticks or slips in the next linear solve, and its row there; at most `max_force` [N].
  Friction friction(const ContactState& state, const ActiveContact& contact, double max_force);

  std::vector<SlotRow> normal_rows_;  // of the active contacts, of the last linear solve
  std::vector<Friction> frictions_;   // the same
  std::vector<char> is_sticking_;     // by pair: it stuck in the last linear solve, below its limit
  std::vector<double> slip_forces_;   // N, by pair: the force while it slipped, 0 if it stuck
  std::vector<int> slip_reversals_;   // by pair, in the stage
};

}  // namespace ribbon
