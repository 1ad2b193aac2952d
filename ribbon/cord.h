#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/definition.h"
#include "ribbon/reports.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/touch.h"
#include "ribbon/vec2.h"

namespace ribbon {

class Island;
struct CordParts;

/// A cord that keeps its length under any load: a direct solver computes all its points at once, in O(points). A rope
/// has one row of points; a ribbon has several and resists shear and compression too. A step allocates no memory,
/// unless more bodies and shapes come near than before. It throws DefinitionError for a value out of range, before
/// anything has moved.
///
/// More functions of a cord are in other headers: tensions, energies and reaction forces (cord_forces.h), bounds of its
/// motion (cord_sweep.h), lines for drawing (smooth_line.h), cuts (cut.h), wheels that it runs around (pulley.h).
class Cord {
 public:
  /// Creates a cord at rest. Throws DefinitionError if check(def) does.
  explicit Cord(const CordDef& def);
  /// Creates a cord from its internal parts; for functions of the library, such as `cut`. The first call of `step`
  /// allocates memory.
  explicit Cord(std::unique_ptr<CordParts> parts);
  Cord(Cord&& other) noexcept;
  Cord& operator=(Cord&& other) noexcept;
  ~Cord();

  /// Returns the definition, with the accuracy that set_accuracy set last.
  const CordDef& def() const;
  /// Returns the number of points, columns · rows.
  int size() const;
  /// Returns the index of point (i, j): column i = 0 … points − 1 along the cord, row j = 0 … rows − 1 across it, not
  /// checked. Rows count upwards in the default layout.
  int index(int i, int j) const;
  std::span<const Vec2> positions() const;   ///< m, by index
  std::span<const Vec2> velocities() const;  ///< m/s, by index
  /// Returns what the solver keeps as tensions, for saving and debugging; for a force of any cord call `tension_of`.
  /// They are negative under compression. A rope has one per link [N], a ribbon of bars one per bar [N]. A ribbon of
  /// cells has one entry per cell first, column by column, then one tension per bar along its middle line, if it has
  /// any [N] (see CordDef::cell_stiffness). The entry of a cell is (μ + λ)·area·(|z| − 2) [J], with its Lamé parameters
  /// μ and λ [N/m] and the sum of its principal stretches |z|.
  std::span<const double> tensions() const;
  /// Returns whether a point is free, operated (dragged) or constrained (pinned). This and the next three do not check
  /// the index, as operator[] of a vector does not.
  PointKind kind(int point) const;
  /// Returns the target of a constrained or operated point, m.
  Vec2 target(int point) const;
  /// Returns the mass of a point with what is attached to it, kg.
  double mass(int point) const;
  /// Returns the rest length of the link from column i to column i + 1, m. Reels change it, and hands that slide along
  /// a rope: a point that such a hand takes with it has longer and shorter links beside it.
  double rest_length(int i) const;
  /// Returns the tension above which a link breaks, N. Throws DefinitionError for an unknown link.
  double breaking_force(int link) const;
  /// s, rest time before a cord falls asleep, as b2_timeToSleep.
  static constexpr double time_to_sleep = 0.5;
  /// Returns whether the cord slept during the last step (CordDef::allow_sleep). The next step wakes it if something
  /// near it has changed or is awake, including another cord of its island. The setters below wake it too, except
  /// set_accuracy.
  bool is_asleep() const;
  /// Wakes the cord and restarts its rest time.
  void wake();

  // Each of these throws DefinitionError, and changes nothing, for an unknown point, link or column and for a value out
  // of range.

  /// Attaches a point mass [kg], 0 … 1e12, to a point. It replaces the mass attached before.
  void attach_mass(int point, double mass);
  /// Sets a constant force on a point [N], each component within ±1e9.
  void set_load(int point, Vec2 force);
  /// Pins a point to `target` [m, within ±1e9]. The point moves there at constant velocity during the next step and
  /// then stays. Throws CallError for a point on the wheel of a pulley.
  void constrain(int point, Vec2 target);
  /// Moves a point to `target` as `constrain` does, but as one that is dragged (PointKind::operated), for example by a
  /// pointer. Call it before each step while dragging; the point stays at the last target until it is released.
  void operate(int point, Vec2 target);
  /// Frees a constrained or operated point. It keeps its velocity.
  void release(int point);
  /// Sets the velocity of a point, m/s, each component within ±1e9.
  void set_velocity(int point, Vec2 velocity);
  /// Sets the accuracy from the next step on. Cords that are solved together, because they share a body, are tied or
  /// may touch, all use the most accurate value of each field: TR-BDF2 if one has it, the most substeps, iterations and
  /// work, the smallest tolerance, and soft contacts only if all have them.
  void set_accuracy(const Accuracy& accuracy);
  /// Sets the tension above which the link from column `link` to the next one breaks, N, 0 … infinity: see
  /// CordDef::breaking_force.
  void set_breaking_force(int link, double force);
  /// Changes the rest lengths of the links from column `first` to column `last`, as a winch does, until their sum is
  /// `length` [m], 1e-3 … 1e3 times the sum in the definition. The sum changes at `speed` [m/s, above 0, at most 1e6],
  /// and the links keep their proportions.
  void reel(int first, int last, double length, double speed);

  /// Advances the cord by dt seconds, 1e-9 ≤ dt ≤ 1, under `gravity` [m/s²]. Bodies that hold the cord (`grips`) or
  /// touch it are solved with it, and a Medium in the surroundings acts on it. The step adds the
  /// impulses of the cord to each body's `impulse` and `angular_impulse`, which give it its velocity at the end of the
  /// step, and writes the displacement of those that hold the cord to `moved` and `turned`. You move the bodies, as a
  /// Coupling does. O(points) for each Newton step.
  IslandReport step(double dt, Vec2 gravity, const Surroundings& surroundings = {});

  /// Reserves memory for steps with up to this many grips; initially for 4.
  void reserve(std::size_t grips);
  /// Frees the memory that `step` needs, which is most of a rope's. A cord that a DirectSolver or a coupling steps does
  /// not need it, because these have their own. The next call of `step` allocates it again.
  void free_solver();

  /// Returns the contacts of the last step, ordered by the id of what the cord touched: a circle, an edge, another cord
  /// or itself. A contact with another cord is listed by the cord whose point touches.
  std::span<const Touch> touches() const;

  /// State of a body that held the cord in the last step.
  struct Holder {
    int point = 0;                      ///< index of the point that it held
    Vec2 velocity;                      ///< m/s, of its centre of mass at the end of the step
    double turning = 0.0;               ///< rad/s, angular velocity at the end of the step
    Vec2 acceleration;                  ///< m/s²
    double angular_acceleration = 0.0;  ///< rad/s²
    int grip = 0;                       ///< index of its grip in the step
    Vec2 pull{};                        ///< N, force of the cord on the body
    double slid = 0.0;                  ///< columns, by which the grip got along the cord as it slipped
    bool slips = false;                 ///< it slipped
    bool operator==(const Holder&) const = default;
  };
  /// Returns the bodies that held the cord in the last step, ordered by point. A static or kinematic body that holds
  /// the cord at a point is not among them: it drives the point, as a pin does.
  std::span<const Holder> holders() const;

  /// Everything that later steps depend on, except the definition.
  struct State {
    std::vector<Vec2> positions;          ///< m, by point
    std::vector<Vec2> velocities;         ///< m/s, by point
    std::vector<Vec2> accelerations;      ///< m/s², by point
    std::vector<Vec2> targets;            ///< m, by point, of constrained and operated ones
    std::vector<PointKind> kinds;         ///< by point
    std::vector<double> masses;           ///< kg, by point, with attached masses
    std::vector<Vec2> loads;              ///< N, by point; empty until set_load is first called
    std::vector<Vec2> medium_forces;      ///< N, by point, of a Medium at the end of the last step; empty if none acted
    std::vector<double> tensions;         ///< see Cord::tensions
    std::vector<double> rest;             ///< m, rest lengths by link
    std::vector<double> rest_targets;     ///< m, by link, goal of the reel; empty until reel is first called
    std::vector<double> rest_speeds;      ///< m/s, by link, speed of the reel; the same
    std::vector<double> breaking_forces;  ///< N, by link; empty until set_breaking_force is first called
    std::vector<Pulley> pulleys;          ///< ordered along the cord
    std::vector<char> unlocked;           ///< by cell, if area stiffness is declared: 1 while it is turned back
    std::uint64_t family = 0;        ///< id of the cord that it is a piece of, however often that was cut; 0 for none
    std::uint64_t joined_first = 0;  ///< id of the cord that it was cut from at its first column; 0 for none
    std::uint64_t joined_last = 0;   ///< the same at its last column; see follow_cut
    bool split = false;              ///< it was cut along a row, and touches no other piece of its cord
    std::vector<Holder> holders;     ///< see Cord::holders
    std::vector<Touch> touches;      ///< see Cord::touches
    bool touch_changed = false;      ///< a contact began or ended in the last step
    /// Share of its unexplained penetrations that the next step removes, and of what it draws hands that are beside it
    /// back by, above 0, at most 1. It is less after steps that were taken back.
    double depenetration_share = 1.0;
    /// 1 after a step in which Newton's method has failed; 2 to 16 if it is left out in the next 1 to 15 steps.
    int newton_pause = 0;
    double regainable_energy = 0.0;       ///< J, energy that later substeps may gain back
    double energy_drift = 0.0;            ///< J, lost since the cord was created; negative if gained
    bool damping_excluded = false;        ///< the tensions are those of the elastic part only
    bool restart = true;                  ///< the next step does not use the accelerations
    double rest_time = 0.0;               ///< s, rest time so far, up to time_to_sleep
    bool asleep = false;                  ///< see Cord::is_asleep
    std::uint64_t surroundings_hash = 0;  ///< hash of its surroundings at rest; 0 if they moved
    bool operator==(const State&) const = default;
  };
  /// Returns the state, for restore.
  State save() const;
  /// Writes the state into an existing object. It allocates nothing if that object held a state of this cord before.
  void save(State& state) const;
  /// Continues from a saved state with the same bits. Throws DefinitionError, and changes nothing, unless the state
  /// fits this cord's size and terms and all its values are in range.
  void restore(const State& state);

  /// Returns the internal parts of the cord, for the solver.
  CordParts& parts() { return *parts_; }
  const CordParts& parts() const { return *parts_; }  ///< the same, unchangeable

 private:
  std::unique_ptr<CordParts> parts_;
  // For steps by itself. Null after free_solver, and at first if the cord was made of its parts.
  std::unique_ptr<Island> island_;
};

/// Throws DefinitionError unless the state fits the cord's size and terms and all its values are in range.
void check_state(const Cord& cord, const Cord::State& state);

}  // namespace ribbon
