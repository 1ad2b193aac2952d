#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ribbon/definition.h"
#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/thesis/mesh.h"
#include "ribbon/thesis/thesis_def.h"

namespace ribbon {

struct ThesisParts;

/// Statistics of one step, summed over its substeps; the last three are of the end of the step.
struct StepReport {
  int fem_skipped = 0;      ///< substeps without FEM, because the matrix was not positive definite
  int motion_limited = 0;   ///< points whose motion in a substep was limited
  int self_contacts = 0;    ///< resolved overlaps of the cord with itself
  int circle_contacts = 0;  ///< resolved overlaps with rigid circles
  int tangled_columns = 0;  ///< columns without self-contact, because the cord crosses itself there
  int strained_bars = 0;    ///< bars with a strain above 10 %; in a stiff cord they show that it is not converged
  int turned_over = 0;      ///< inverted triangles
  int energy_gains = 0;  ///< 1 if the energy rose without a cause, by more than a thousandth of itself and of M·g·L;
                         ///< not checked while a driven point, a grip or a kinematic body moves

  bool operator==(const StepReport&) const = default;
  /// Adds the counts of another step.
  StepReport& operator+=(const StepReport& other);
};

/// A cord after Goto 2017, with corrections: FEM bars as an implicit damper, springs that restore the shape, area
/// correction, self-collision and rigid circles, with N substeps per step. A step costs O(w·h³). After the first step
/// it allocates no memory, unless its surroundings have more items than before and than was reserved.
class ThesisCord {
 public:
  /// Creates a cord at rest. Throws DefinitionError if check(def) does. `solver` solves the FEM system; the default is
  /// the banded LDLᵀ.
  explicit ThesisCord(const ThesisDef& def, std::unique_ptr<LinearSolver> solver = std::make_unique<BandedLdlt>());
  ThesisCord(ThesisCord&&) noexcept;
  ThesisCord& operator=(ThesisCord&&) noexcept;
  ~ThesisCord();

  /// Returns the points, connections and triangles, which never change.
  const Mesh& mesh() const;
  /// Returns the definition.
  const ThesisDef& def() const;
  std::span<const Vec2> positions() const;   ///< m, by point index
  std::span<const Vec2> velocities() const;  ///< m/s, by point index
  /// Returns what determines the motion of a point. This and `target` do not check the index.
  PointKind kind(int point) const;
  /// Returns the target of a constrained or operated point, m.
  Vec2 target(int point) const;

  /// Pins a point to `target` [m]. The point moves there in a straight line during the next step and then stays. Throws
  /// DefinitionError for an unknown point or a coordinate beyond ±1e9, as do the next two.
  void constrain(int point, Vec2 target);
  /// Drags a point to `target` in the same way. Call it before each step while dragging.
  void operate(int point, Vec2 target);
  /// Frees a constrained or operated point. It keeps its velocity.
  void release(int point);

  /// Reserves memory for steps with so many items in the surroundings.
  void reserve(std::size_t bodies, std::size_t circles, std::size_t grips);

  /// Sets the velocity of a point, m/s, each component within ±1e9.
  void set_velocity(int point, Vec2 velocity);

  /// Adds a momentum [kg·m/s, each component within ±1e9], distributed evenly over the free points, if any.
  void add_momentum(Vec2 momentum);

  /// Advances the cord by dt seconds, 1e-9 ≤ dt ≤ 1, under `gravity` [m/s²]. Reads the surroundings at the start of the
  /// step, including the impulses that bodies already have, and adds the cord's impulses. Throws DefinitionError,
  /// before anything has moved, for a value out of range.
  StepReport step(double dt, Vec2 gravity, const Surroundings& surroundings = {});

  /// Everything that later steps depend on, except the definition.
  struct State {
    std::vector<Vec2> positions;   ///< m, by point
    std::vector<Vec2> velocities;  ///< m/s, by point
    std::vector<Vec2> targets;     ///< m, by point, of constrained and operated ones
    std::vector<PointKind> kinds;  ///< by point
    bool operator==(const State&) const = default;
  };
  /// Returns the state, for restore.
  State save() const;
  /// Writes the state into an existing object. It allocates nothing if that object held a state of this cord before.
  void save(State& state) const;
  /// Continues from a saved state with the same bits. Throws DefinitionError, and changes nothing, if check_state does.
  void restore(const State& state);
  /// Throws DefinitionError unless the state fits this cord's size, with coordinates within ±1e9 and valid kinds.
  void check_state(const State& state) const;

 private:
  std::unique_ptr<ThesisParts> parts_;
};

}  // namespace ribbon
