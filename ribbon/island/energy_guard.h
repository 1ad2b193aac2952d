#pragma once

#include "ribbon/contact/contacts.h"
#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// Watches the energy of an island. A substep may regain what recent substeps lost. Rounding and the tolerance may add
/// a little more, which must be lost again before more is gained. That bounds the gain of a cord that nothing drives.
/// Where all that drives moves with one velocity, energy is measured in the inertial frame in which it rests.
class EnergyGuard {
 public:
  using Energy = CordEnergy;
  /// Gain of a substep that is tolerated, as a share of the scene's energy.
  static constexpr double tolerated_gain = 5e-4;

  /// Reads the energies that the cords may regain and have lost.
  void begin_step(const IslandState& state);
  /// Finds the frame in which what drives the island rests, if there is one. Its bodies are known.
  static void find_frame(IslandState& state, const Contacts& contacts);
  /// Finds the scale of the scene's potential energy; its bodies are known.
  void find_scale(const IslandState& state);
  /// Writes what the cords may regain and have lost back to them.
  void store(const IslandState& state) const;

  /// Begins a step of which the slots are loaded: stores its energy, if something was pushed.
  void begin_pushes(IslandState& state);
  /// Ends the pushes (RigidBody::pushed): takes their parts out of the velocities, and with them the energy that they
  /// have given the island: the work f·Δx, which nothing has lost.
  void end_pushes(IslandState& state) const;

  /// Returns the total energy in that frame. Contacts are evaluated at the current positions.
  static Energy total_energy(IslandState& state, Contacts& contacts);
  /// Returns whether the island has to follow something that moves otherwise than in one frame, or that it touched
  /// since the substep began.
  static bool is_moved(const IslandState& state, const Contacts& contacts);
  /// Returns whether something changes the energy by an amount that is not known: what drives the island otherwise than
  /// in one frame or, since the substep began, what it touched.
  static bool is_driven(const IslandState& state, const Contacts& contacts);
  /// Returns whether a medium may change it too.
  static bool is_pushed(const IslandState& state, const Contacts& contacts) {
    return state.in_medium || is_driven(state, contacts);
  }
  /// Stores the energy at the end of the substep, unless something pushes the island. Once a substep, or a part of it
  /// that is kept. It takes what gained_energy() has measured last, unless that was discarded.
  void measure(IslandState& state, Contacts& contacts);
  /// Call it when the state has changed since gained_energy() measured it.
  void discard_measurement() { is_measured_ = false; }
  /// Measures, and returns whether the energy has risen since `before` by more than the work of grips, what may be
  /// regained and `tolerated` [share of the scene's energy]. Near contacts the larger one of the last two counts.
  /// Returns false while something drives the island.
  bool gained_energy(IslandState& state, Contacts& contacts, const Energy& before, double tolerated);
  /// The last resort for a substep that is not solved, or in which Newton's method turned cells back: takes the energy
  /// that came from nowhere out of the velocities. Returns what they do not have, as a share of the scene's energy.
  double remove_spurious_energy(IslandState& state, Contacts& contacts, const Energy& before);
  /// The same for a solved substep of implicit Euler, which may gain where contacts begin. It takes out no more than
  /// the motion has gained: what the tolerance leaves as tension in a stiff cord, implicit Euler damps by itself. It
  /// takes what gained_energy() has measured last.
  void remove_spurious_motion(IslandState& state, Contacts& contacts, const Energy& before);
  /// Ends a substep: updates what may be regained and what was lost, and slows down what has gained too much in all.
  /// Nothing, where something pushes the island.
  void account(IslandState& state, const Contacts& contacts, const Energy& before);

 private:
  static Energy energy_without_contacts(IslandState& state);
  void measure_once(IslandState& state, Contacts& contacts);
  bool is_gain(const IslandState& state, const Contacts& contacts, const Energy& before, double tolerated) const;
  double scale(const Energy& energy) const;

  double regainable_ = 0.0;    // J, lost in recent substeps; negative if gained
  double drift_ = 0.0;         // J, lost since the cords were created; negative if gained
  double weight_scale_ = 0.0;  // J, M·g·L, and so for loads
  Energy after_;
  bool is_measured_ = false;  // after_ is the energy of the state
  double unpushed_ = 0.0;     // J, at the start of the step, with pushed bodies where they were pushed
  double known_work_ = 0.0;   // J, in the step so far, if something was pushed
  bool was_pushed_ = false;   // in the step: something changed the energy by an amount that is not known
};

}  // namespace ribbon
