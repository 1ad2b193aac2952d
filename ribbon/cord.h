#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/definition.h"
#include "ribbon/elasticity.h"
#include "ribbon/held_body.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// What happened in one step, summed over its substeps. All but the first two count what went wrong and was mended,
/// the last what was not.
struct CordReport {
  int stages = 0;        ///< implicit solves: two a substep of TR-BDF2, one of implicit Euler
  int iterations = 0;    ///< Newton steps in them: linear systems solved, each O(points)
  int searches = 0;      ///< stages that full Newton steps did not solve, begun again with a line search
  int fallbacks = 0;     ///< substeps taken again by implicit Euler because a stage had not converged
  int energy_gains = 0;  ///< substeps taken again, by implicit Euler or to a sharper tolerance, because energy had come
                         ///< from nowhere; not looked for while something drives the cord
  int halvings = 0;      ///< substeps of implicit Euler that had not converged either, taken as two
  int unlocked = 0;      ///< steps in which cells that were inside out were turned back
  int unconverged = 0;   ///< substeps left as they are after all that

  bool operator==(const CordReport&) const = default;
  CordReport& operator+=(const CordReport& other);
};

/// A cord that keeps its length, however heavy what hangs on it: all its points are solved at once and exactly, in
/// O(points). A rope is one row of points; a ribbon has more, which shear and squash. A step allocates nothing and
/// throws nothing.
class Cord {
 public:
  /// At rest. Throws DefinitionError where check(def) does.
  explicit Cord(const CordDef& def);

  const CordDef& def() const { return def_; }
  int size() const { return def_.points * def_.rows; }
  /// The point i = 0 … points − 1 along the cord, j = 0 … rows − 1 across it, upwards in the initial layout.
  int index(int i, int j) const { return i * def_.rows + j; }
  std::span<const Vec2> positions() const { return points(positions_); }    ///< m, by index
  std::span<const Vec2> velocities() const { return points(velocities_); }  ///< m/s, by index
  /// N, of a rope's links or the bars of a ribbon; negative where one is pushed together. Of a ribbon of cells first
  /// those of the cells, column by column, (μ + λ)·area·(|z| − 2) of each [J], then the bars of its spine, if it has
  /// one [N].
  std::span<const double> tensions() const { return tensions_; }
  /// Of this and the next three the caller sees to it that there is such a point, or link.
  PointKind kind(int point) const { return kinds_[slot(point)]; }
  /// Where a constrained or operated point is going, m.
  Vec2 target(int point) const { return targets_[slot(point)]; }
  /// kg, the point's share of the cord and what is attached to it.
  double mass(int point) const { return masses_[slot(point)]; }
  /// The rest length of the link from column i to i + 1, m.
  double rest_length(int i) const { return rest_[slot(i)]; }
  struct Energy {
    double kinetic = 0.0;    ///< J, as the others
    double elastic = 0.0;    ///< of stretched bars and cells by their tensions
    double potential = 0.0;  ///< in gravity and under the loads
    double total() const { return kinetic + elastic + potential; }
  };
  /// J, in this gravity [m/s²].
  Energy energy(Vec2 gravity) const;

  /// Throws DefinitionError unless the cord has a point of that index.
  void check_point(int point) const;

  /// Each of these throws DefinitionError for an unknown point or a number out of range, and then changes nothing.

  /// Attaches a point mass [kg], 0 … 1e12, instead of the one attached before.
  void attach_mass(int point, double mass);
  /// A force on a point [N], each component up to ±1e9, until it is set again.
  void set_load(int point, Vec2 force);
  /// Constrains a point to `target` [m, up to ±1e9], reached evenly in the next step and then kept.
  void constrain(int point, Vec2 target);
  /// The same for a point that somebody drags: call it again to drag on.
  void operate(int point, Vec2 target);
  /// Lets a constrained or operated point go with the velocity it has.
  void release(int point);
  /// Sets a point's velocity, m/s, each component up to ±1e9.
  void set_velocity(int point, Vec2 velocity);
  /// Reels the links from column `first` to column `last` in or out, until their rest lengths add up to `length` [m],
  /// 1e-3 to 1e3 times what they were made with, at `speed` [m/s, above 0, up to 1e6] in sum. They keep their
  /// proportions. What a winch of that speed does to the load, it does; nothing jumps.
  void reel(int first, int last, double length, double speed);

  /// Advances by dt seconds, 0 < dt ≤ 1, under `gravity` [m/s²]. Bodies that hold points of the cord (`grips`, of which
  /// no two have the same body) move with it: each is given the impulses that take it to its velocity at the end of the
  /// step, and is told how far it `moved` and `turned`. Circles are not met yet.
  CordReport step(double dt, Vec2 gravity, const Surroundings& surroundings = {});

  /// Takes the memory for steps with up to this many grips, so that none takes any later; 4 from the start.
  void reserve(std::size_t grips);

  /// What is remembered of a body that held the cord in the last step.
  struct Holder {
    int point = 0;
    Vec2 velocity;
    double turning = 0.0;  // rad/s
    Vec2 acceleration;
    double angular_acceleration = 0.0;
    bool operator==(const Holder&) const = default;
  };

  /// All that a later step depends on but for the definition.
  struct State {
    std::vector<Vec2> positions;
    std::vector<Vec2> velocities;
    std::vector<Vec2> accelerations;
    std::vector<Vec2> targets;
    std::vector<PointKind> kinds;
    std::vector<double> masses;
    std::vector<Vec2> loads;  // empty as long as there never was one
    std::vector<double> tensions;
    std::vector<double> rest;
    std::vector<double> rest_targets;  // these two empty as long as nothing was ever reeled
    std::vector<double> rest_speeds;
    std::vector<char> unlocked;  // by cell, if the cord declares area stiffness
    std::vector<Holder> holders;
    double ledger = 0.0;         ///< J, see CordReport::energy_gains
    bool damping_apart = false;  ///< the tensions are without damping
    bool restart = true;         ///< the accelerations are not those of this state
    bool operator==(const State&) const = default;
  };
  State save() const;
  /// Continues from a saved state, to the same bits. Throws DefinitionError if it is of another size, or has a number
  /// that no cord can have.
  void restore(const State& state);

 private:
  void check_state(const State& state) const;
  static std::size_t slot(int i) { return static_cast<std::size_t>(i); }
  std::size_t count() const { return targets_.size(); }
  template <typename T>
  std::span<T> points(std::vector<T>& all) const {
    return std::span(all).first(count());
  }
  template <typename T>
  std::span<const T> points(const std::vector<T>& all) const {
    return std::span(all).first(count());
  }
  std::size_t center(std::size_t held) const { return count() + 2 * held; }
  std::size_t angle(std::size_t held) const { return count() + 2 * held + 1; }
  void set_slots(std::size_t bodies);
  void set_damping_apart();
  void put_damping_back();
  Energy total_energy() const;
  void drive(int point, Vec2 target, PointKind kind);
  double own_mass(std::size_t point) const;

  void begin_step(double dt, Vec2 gravity, const Surroundings& surroundings);
  void find_tolerance();
  void drive_points(double dt);
  void take_hold(double dt, const Surroundings& surroundings);
  void add_holder(const Grip& grip, const RigidBody& body);
  void wind(double dt);
  void finish_step(double dt, const Surroundings& surroundings, CordReport& report);
  void let_go(double dt, const Surroundings& surroundings);
  void damp_deformation();

  void substep(double start, double dt, CordReport& report);
  void begin_substep();
  void return_to_start();
  bool second_order(double start, double dt, const Energy& before, CordReport& report);
  bool gained_energy(const Energy& before, double tolerated);
  void account(const Energy& before);
  double energy_scale(const Energy& energy) const;
  bool tr_bdf2(double start, double dt, CordReport& report);
  bool sdirk2(double start, double dt, CordReport& report);
  bool implicit_euler(double start, double dt, CordReport& report);
  bool damped_substep(double start, double dt, const Energy& before, CordReport& report);
  bool halves(double start, double dt, int depth, int most_iterations, CordReport& report);

  bool solve_stage(double time, double q, CordReport& report);
  void place_driven(double time);
  void add_drag(double q);
  double furthest() const;
  bool newton_step(Stage& stage);
  void move(std::span<Vec2> x, double share) const;
  void close_arms(std::span<Vec2> x) const;
  bool full_steps(Stage& stage, CordReport& report);
  bool searched_steps(Stage& stage, CordReport& report);
  double merit(const Stage& stage, std::span<const Vec2> x);

  CordDef def_;
  std::unique_ptr<Elasticity> elasticity_;

  // Of the points; and behind them, in the order of held_, two slots of each body that holds one: its centre of mass,
  // and (φ, 0) of the angle it has turned by in the step. The integrators make no difference between them.
  std::vector<Vec2> positions_;
  std::vector<Vec2> velocities_;
  std::vector<Vec2> accelerations_;
  std::vector<Vec2> targets_;
  std::vector<PointKind> kinds_;
  std::vector<double> masses_;
  std::vector<Vec2> loads_;
  std::vector<double> tensions_;
  std::vector<double> rest_;          // m, of each link
  std::vector<double> rest_targets_;  // m, where a reel is taking it
  std::vector<double> rest_speeds_;   // m/s, how fast
  double ledger_ = 0.0;               // J, of the energy guard: lost lately, or gained if negative
  std::vector<Holder> holders_;
  bool damping_apart_ = false;  // tensions_ are the elastic ones alone, for velocities may be changed
  bool restart_ = true;         // accelerations_ are not those of this state

  // The step's own: nothing below outlives one.
  Vec2 gravity_;
  double step_dt_ = 0.0;
  double tolerance_ = 0.0;        // m, of this step
  double least_tolerance_ = 0.0;  // m
  bool driven_ = false;           // something moves or turns the cord that the energy guard does not know
  bool winding_ = false;          // a reel changes rest lengths
  bool arriving_ = false;         // and stops
  bool unlocking_ = false;
  Energy energy_after_;
  double weight_scale_ = 0.0;   // J, M·g·L
  std::vector<HeldBody> held_;  // by point, ascending
  std::vector<HeldStep> held_steps_;
  std::vector<CarriedLoad> carried_;
  std::vector<char> constrained_;
  std::vector<Vec2> starts_, drives_;          // of driven points: where the step found them, and their velocity
  std::vector<double> rest_start_, rest_end_;  // while something is reeled
  std::vector<Vec2> x0_, v0_;                  // at the start of the substep
  std::vector<double> tension0_;
  std::vector<Vec2> x_start_, v_start_;  // the same, while it is taken by halves
  std::vector<double> tension_start_;
  std::vector<Vec2> x1_, v1_;               // after its first stage
  std::vector<Vec2> predicted_, velocity_;  // x̃ and ṽ of the stage
  std::vector<Vec2> guess_;                 // where the stage's Newton steps begin
  std::vector<double> tension_guess_;
  std::vector<double> inertia_;
  std::vector<Vec2> force_;
  std::vector<Vec2> direction_, trial_;
  std::vector<double> next_;
  std::vector<double> most_tensions_;
};

}  // namespace ribbon
