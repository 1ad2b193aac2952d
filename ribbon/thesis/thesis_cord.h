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

class BroadPhase;

/// What happened in one step, summed over its substeps; the last three, at its end.
struct StepReport {
  int fem_skipped = 0;      ///< substeps whose matrix was not positive definite: springs alone carried on
  int motion_limited = 0;   ///< points held back to the most a point may move in a substep
  int self_contacts = 0;    ///< overlaps of the cord with itself that were resolved
  int circle_contacts = 0;  ///< overlaps with rigid circles that were resolved
  int tangled_columns = 0;  ///< columns whose self-contact rested because the cord crossed itself there
  int strained_bars =
      0;                 ///< bars more than a tenth off their rest length, of a stiff cord a sign that it is not solved
  int turned_over = 0;   ///< triangles that are inside out
  int energy_gains = 0;  ///< 1 if energy has come from nowhere, above a thousandth of what there is and of M·g·L; not
                         ///< looked for while a point, a hand or a body that nothing pushes is moving

  bool operator==(const StepReport&) const = default;
  /// Adds the counts of another step.
  StepReport& operator+=(const StepReport& other);
};

/// A cord after Goto 2017, in the reading that works: FEM bars as an implicit damper, springs for the memory of
/// shape, area correction, self-collision and rigid circles, N substeps a step. A step costs O(w·h³) and, after the
/// first, takes no heap memory as long as its surroundings hold no more than before, or than was reserved.
class ThesisCord {
 public:
  /// Builds the cord at rest. Throws DefinitionError where check(def) does. `solver` solves the FEM's system; the
  /// default is the banded LDLᵀ.
  explicit ThesisCord(const ThesisDef& def, std::unique_ptr<LinearSolver> solver = std::make_unique<BandedLdlt>());
  ThesisCord(ThesisCord&&) noexcept;
  ThesisCord& operator=(ThesisCord&&) noexcept;
  ~ThesisCord();

  /// Its points, connections and triangles; for its life.
  const Mesh& mesh() const { return *mesh_; }
  /// What it was made of.
  const ThesisDef& def() const { return def_; }
  std::span<const Vec2> positions() const { return positions_; }    ///< m, by point index
  std::span<const Vec2> velocities() const { return velocities_; }  ///< m/s, by point index
  /// The caller sees to it that there is such a point, here and in target.
  PointKind kind(int point) const { return kinds_[index(point)]; }
  /// Where a constrained or operated point is going, m.
  Vec2 target(int point) const { return targets_[index(point)]; }

  /// Constrains a point to `target` [m], which it reaches on a straight line in the next step and then keeps.
  /// Throws DefinitionError for an unknown index or a coordinate beyond ±1e9, as the next two do.
  void constrain(int point, Vec2 target);
  /// The same for a point that somebody drags: call it again to drag on.
  void operate(int point, Vec2 target);
  /// Lets a constrained or operated point go with the velocity it has.
  void release(int point);

  /// Takes the memory for steps with up to this much around the cord, so that none takes any later.
  void reserve(std::size_t bodies, std::size_t circles, std::size_t grips);

  /// Sets a point's velocity, m/s, each component up to ±1e9.
  void set_velocity(int point, Vec2 velocity);

  /// Adds momentum [kg·m/s, each component up to ±1e9], spread evenly over the free points; nothing if there is none.
  void add_momentum(Vec2 momentum);

  /// Throws DefinitionError unless the cord has a point of that index.
  void check_point(int point) const;

  /// Advances by dt seconds, 1e-9 ≤ dt ≤ 1, under `gravity` [m/s²]. Reads the surroundings as they are at the start,
  /// with the impulses their bodies have been given so far, and adds the cord's own impulses to them. Throws
  /// DefinitionError, before anything has moved, for a number that is out of its range.
  StepReport step(double dt, Vec2 gravity, const Surroundings& surroundings = {});

  /// What a replay or a saved game has to keep; the rest follows from the definition.
  struct State {
    std::vector<Vec2> positions;   ///< m, by point
    std::vector<Vec2> velocities;  ///< m/s, by point
    std::vector<Vec2> targets;     ///< m, by point: of those that are driven
    std::vector<PointKind> kinds;  ///< by point
    bool operator==(const State&) const = default;
  };
  /// What to go on from later.
  State save() const { return {positions_, velocities_, targets_, kinds_}; }
  /// The same into a state that is there already: one that has held this cord's before takes no memory.
  void save(State& state) const;
  /// Continues from a saved state, to the same bits. Throws DefinitionError where check_state does, and then changes
  /// nothing.
  void restore(const State& state);
  /// Throws DefinitionError unless the state is one of a cord of this size, with coordinates within ±1e9 and kinds of
  /// points that there are.
  void check_state(const State& state) const;

 private:
  static std::size_t index(int point) { return static_cast<std::size_t>(point); }
  void drive(int point, Vec2 target, PointKind kind);
  void set_kind(int point, PointKind kind);

  void begin_step(const Surroundings& surroundings);
  void substep(int iteration, double dt, Vec2 gravity, const Surroundings& surroundings);
  void move_driven_points(int iteration);
  void predict(double dt, Vec2 gravity, const Surroundings& surroundings);
  void deform_by_fem(double dt);
  void assemble(double dt);
  void pull_grips(double dt, const Surroundings& surroundings);
  void collide_with_itself();
  void collide_with_circles(double dt, const Surroundings& surroundings);
  void limit_motion(double dt);
  void finish_substep(double dt, const Surroundings& surroundings);
  void report_motions(const Surroundings& surroundings) const;
  // thesis_report.cpp:
  struct Energy {
    double moving = 0.0;     // J, kinetic and elastic
    double potential = 0.0;  // J
    double total() const { return moving + potential; }
  };
  Energy energy(Vec2 gravity, const Surroundings& surroundings) const;
  bool is_driven(const Surroundings& surroundings) const;
  void report_gain(const Energy& before, Vec2 gravity, const Surroundings& surroundings);
  void report_shape();

  /// A body's motion within the step; its owner's copy stays as it was but for the impulse.
  struct BodyMotion {
    Vec2 position;
    Vec2 velocity;
    double angular_velocity;
    double turned;      // rad, in this substep
    double turned_all;  // rad, in the substeps before
  };
  Vec2 reach(const BodyMotion& body, Vec2 offset) const { return offset + body.turned * perp(offset); }
  void push_body(RigidBody& body, BodyMotion& motion, Vec2 arm, Vec2 impulse, double dt);

  ThesisDef def_;
  std::unique_ptr<Mesh> mesh_;  // at a fixed address: the broad phases point to it
  std::unique_ptr<LinearSolver> solver_;

  std::vector<Vec2> positions_;
  std::vector<Vec2> velocities_;
  std::vector<Vec2> targets_;  // of driven points
  std::vector<PointKind> kinds_;
  std::vector<double> inverse_mass_;  // 1/kg, 0 for driven points

  std::vector<Vec2> before_;  // R of Eq. 3.16: positions at the start of the substep
  std::vector<Vec2> starts_;  // of driven points at the start of the step
  std::unique_ptr<BandedMatrix> matrix_;
  std::vector<double> force_;  // N, then U′ in m

  std::unique_ptr<BroadPhase> self_phase_;  // if the cord declares self-collision
  std::vector<double> own_radii_;
  std::vector<char> tangled_;                 // by column: 1 where the cord crosses itself in this step
  std::unique_ptr<BroadPhase> circle_phase_;  // made when the first circle comes near
  std::vector<BodyMotion> motions_;
  std::vector<Vec2> circle_offsets_;
  std::vector<Vec2> circle_centers_;
  std::vector<Vec2> circle_centers_before_;
  std::vector<double> circle_radii_;
  std::vector<Vec2> grip_offsets_;
  double driven_speed_ = 0.0;  // m/s, the fastest driven point in this step

  StepReport report_;
};

}  // namespace ribbon
