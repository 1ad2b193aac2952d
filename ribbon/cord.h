#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/cord_def.h"
#include "ribbon/definition.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/touch.h"
#include "ribbon/vec2.h"

namespace ribbon {

class Elasticity;
class Island;

/// What happened in one step, summed over its substeps. After the first two, counts of what went wrong and was mended,
/// and of what was not.
struct CordReport {
  int stages = 0;        ///< implicit solves: two a substep of TR-BDF2, one of implicit Euler
  int iterations = 0;    ///< Newton steps in them: linear systems solved, each O(points)
  int searches = 0;      ///< stages that full Newton steps did not solve, begun again with a line search
  int fallbacks = 0;     ///< substeps taken again by implicit Euler because a stage had not converged
  int energy_gains = 0;  ///< substeps taken again, by implicit Euler or to a sharper tolerance, because energy had come
                         ///< from nowhere; not looked for while something but hands drives the cord
  int halvings = 0;      ///< substeps of implicit Euler that had not converged either, taken as two
  int impacts = 0;       ///< substeps in which somebody began or ceased to touch, taken by implicit Euler and BDF2
  int posed = 0;  ///< substeps of implicit Euler with contacts that were posed once, for Newton steps did not end
  int cuts = 0;   ///< pieces of these in which something was kept from going through something, or taken back for what
                  ///< it could not have gained, and lost velocity
  int unlocked = 0;     ///< steps in which cells that were inside out were turned back
  int unconverged = 0;  ///< substeps left as they are after all that
  /// What was done, in a unit that is the same on every machine: 1 for each 2 × 2 block of the matrix of a linear
  /// system, taken as 4 a point where that is a cord's own band, and 1 for each pair that was looked at for whether it
  /// touches, or may on its way.
  std::int64_t work = 0;
  // How far from solved the worst of the substeps was left that did not converge; 0 if all did:
  double position_error = 0.0;  ///< m, by which its last linear solve would still move a point
  double force_error = 0.0;     ///< N, that this takes by the inertia of a point

  bool operator==(const CordReport&) const = default;
  /// Adds the counts of another step, and takes the greater of the errors.
  CordReport& operator+=(const CordReport& other);
};

/// A cord that keeps its length, however heavy what hangs on it: all its points are solved at once and exactly, in
/// O(points). A rope is one row of points; a ribbon has more, which shear and squash. A step allocates nothing, and
/// throws DefinitionError, before anything has moved, for a number that is out of its range.
class Cord {
 public:
  /// At rest. Throws DefinitionError where check(def) does.
  explicit Cord(const CordDef& def);
  Cord(Cord&& other) noexcept;
  Cord& operator=(Cord&& other) noexcept;
  ~Cord();

  /// What it was made of; its accuracy is that of set_accuracy.
  const CordDef& def() const { return def_; }
  /// How many points it has.
  int size() const { return def_.points * def_.rows; }
  /// The point i = 0 … points − 1 along the cord, j = 0 … rows − 1 across it, upwards in the initial layout.
  int index(int i, int j) const { return i * def_.rows + j; }
  std::span<const Vec2> positions() const { return positions_; }    ///< m, by index
  std::span<const Vec2> velocities() const { return velocities_; }  ///< m/s, by index
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
  /// Of the cord, its loads and what is attached to it.
  struct Energy {
    double kinetic = 0.0;    ///< J, as the others
    double elastic = 0.0;    ///< of stretched bars and cells by their tensions
    double potential = 0.0;  ///< in gravity and under the loads
    /// J, of all three.
    double total() const { return kinetic + elastic + potential; }
  };
  /// J, in this gravity [m/s²].
  Energy energy(Vec2 gravity) const;

  /// Where a cord is, and how it moves.
  struct Sweep {
    Box box;               ///< m, of its points and of where they are driven to
    double speed2 = 0.0;   ///< m²/s², of the fastest point, squared
    double elastic = 0.0;  ///< J, what it is stretched and bent by; 0 while it sleeps
  };
  /// O(1) after a step of a DirectSolver, until something changes the cord; else O(points).
  Sweep sweep() const { return sweep_ ? *sweep_ : find_sweep(); }
  /// Has `sweep` take no time until something changes the cord.
  void remember_sweep() {
    if (!sweep_) sweep_ = find_sweep();
  }

  /// s, for which a cord that is allowed to has to rest before it sleeps, as b2_timeToSleep.
  static constexpr double time_to_sleep = 0.5;
  /// Whether it slept through the last step (CordDef::allow_sleep). The next one wakes it if what is near it is not as
  /// it was, or awake, a cord of its island among them; what follows here wakes it, too, but for set_accuracy.
  bool is_asleep() const { return asleep_; }
  /// Has it rest for as long again before it sleeps.
  void wake();

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
  /// Has it solved so from the next step on; in an island the sharpest of all holds.
  void set_accuracy(const Accuracy& accuracy);
  /// Reels the links from column `first` to column `last` in or out, until their rest lengths add up to `length` [m],
  /// 1e-3 to 1e3 times what they were made with, at `speed` [m/s, above 0, up to 1e6] in sum. They keep their
  /// proportions. What a winch of that speed does to the load, it does; nothing jumps.
  void reel(int first, int last, double length, double speed);

  /// Advances by dt seconds, 1e-9 ≤ dt ≤ 1, under `gravity` [m/s²]. Bodies that hold points of the cord (`grips`, of
  /// which no two have the same body) move with it: each is given the impulses that take it to its velocity at the end
  /// of the step, and is told how far it `moved` and `turned`, and so are bodies whose circles and segments touch it.
  CordReport step(double dt, Vec2 gravity, const Surroundings& surroundings = {});

  /// Takes the memory for steps with up to this many grips, so that none takes any later; 4 from the start.
  void reserve(std::size_t grips);

  /// Contacts of the last step with what the step's surroundings gave an id.
  std::span<const Touch> touches() const { return touches_; }

  /// What is remembered of a body that held the cord in the last step.
  struct Holder {
    int point = 0;                      ///< the cord's, by index
    Vec2 velocity;                      ///< m/s, of its centre of mass at the end of the step
    double turning = 0.0;               ///< rad/s, at the same time
    Vec2 acceleration;                  ///< m/s²
    double angular_acceleration = 0.0;  ///< rad/s²
    int grip = 0;                       ///< which of the step's grips
    Vec2 pull{};                        ///< N, on the body
    double slid = 0.0;                  ///< columns, by which the grip slipped along the cord
    bool operator==(const Holder&) const = default;
  };
  /// Those of bodies that are pushed, in the last step, by the point that they hold.
  std::span<const Holder> holders() const { return holders_; }

  /// All that a later step depends on but for the definition.
  struct State {
    std::vector<Vec2> positions;       ///< m, by point
    std::vector<Vec2> velocities;      ///< m/s, by point
    std::vector<Vec2> accelerations;   ///< m/s², by point
    std::vector<Vec2> targets;         ///< m, by point: of those that are driven
    std::vector<PointKind> kinds;      ///< by point
    std::vector<double> masses;        ///< kg, by point, with what is attached
    std::vector<Vec2> loads;           ///< N, by point; empty as long as there never was one
    std::vector<double> tensions;      ///< see Cord::tensions
    std::vector<double> rest;          ///< m, rest lengths by link
    std::vector<double> rest_targets;  ///< m, by link, where a reel takes it; empty as long as nothing was ever reeled
    std::vector<double> rest_speeds;   ///< m/s, by link, how fast; the same
    std::vector<char> unlocked;     ///< by cell, if the cord declares area stiffness: 1 while it is being turned back
    std::vector<Holder> holders;    ///< see Cord::holders
    std::vector<Touch> touches;     ///< see Cord::touches
    bool touch_changed = false;     ///< in the last step
    double ledger = 0.0;            ///< J, see CordReport::energy_gains
    double balance = 0.0;           ///< J, lost since it was made, or gained if negative
    bool damping_apart = false;     ///< the tensions are without damping
    bool restart = true;            ///< the accelerations are not those of this state
    double rested = 0.0;            ///< s, for which it has rested, up to time_to_sleep
    bool asleep = false;            ///< see Cord::is_asleep
    std::uint64_t still_among = 0;  ///< a number for what it rested among, 0 if that moved
    bool operator==(const State&) const = default;
  };
  /// What to go on from later.
  State save() const;
  /// The same into a state that is there already: one that has held this cord's before takes no memory.
  void save(State& state) const;
  /// Continues from a saved state, to the same bits. Throws DefinitionError where check_state does, and then changes
  /// nothing.
  void restore(const State& state);
  /// Throws DefinitionError unless the state is one of a cord of this size and these terms, with numbers that a cord
  /// can have.
  void check_state(const State& state) const;

 private:
  friend class Island;

  static std::size_t slot(int i) { return static_cast<std::size_t>(i); }
  std::size_t count() const { return targets_.size(); }
  void set_damping_apart();
  void put_damping_back();
  void drive(int point, Vec2 target, PointKind kind);
  void disturb();
  void fall_asleep();
  bool is_winding() const { return !rest_targets_.empty() && rest_ != rest_targets_; }
  double own_mass(std::size_t point) const;
  Sweep find_sweep() const;

  CordDef def_;
  std::unique_ptr<Elasticity> elasticity_;

  std::vector<Vec2> positions_;
  std::vector<Vec2> velocities_;
  std::vector<Vec2> accelerations_;
  std::vector<Vec2> targets_;
  std::vector<PointKind> kinds_;
  std::vector<double> own_masses_;  // kg, without what was attached
  std::vector<double> masses_;      // kg
  std::vector<Vec2> loads_;
  std::vector<double> tensions_;
  std::vector<double> rest_;          // m, of each link
  std::vector<double> rest_targets_;  // m, where a reel is taking it
  std::vector<double> rest_speeds_;   // m/s, how fast
  double ledger_ = 0.0;               // J, of the energy guard: lost lately, or gained if negative
  double balance_ = 0.0;              // J, the same since it was made
  std::vector<Holder> holders_;
  std::vector<Touch> touches_;
  bool touch_changed_ = false;     // in the last step
  bool damping_apart_ = false;     // tensions_ are the elastic ones alone, for velocities may be changed
  bool restart_ = true;            // accelerations_ are not those of this state
  std::optional<Sweep> sweep_;     // of this state, if it was found
  double rested_ = 0.0;            // s, for which it has rested,
  bool asleep_ = false;            // in the last step,
  std::uint64_t still_among_ = 0;  // among what: see State

  std::vector<double> rest_start_, rest_end_;  // of this step, while something is reeled
  std::vector<int> outline_;                   // points around which the cord is touched, in order
  std::unique_ptr<Island> alone_;              // for steps by itself
};

}  // namespace ribbon
