#pragma once

#include <limits>
#include <span>
#include <vector>

#include "ribbon/thesis_def.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// What a cord of one row of points is made of.
struct RopeDef {
  int points = 51;       ///< along the cord, 2 … 1,000,000
  double length = 10.0;  ///< m, at rest, 1e-6 … 1e6, in equal links
  double mass = 1.0;     ///< kg, of the whole cord, 1e-9 … 1e9; half a link's share stands at either end of it
  /// EA [N]: tension a unit of strain, 1e-6 … 1e18; infinity, the default, for a cord that does not stretch.
  double stretch_stiffness = std::numeric_limits<double>::infinity();
  int substeps = 1;         ///< a step, 1 … 4096: the error falls with their square
  double tolerance = 1e-3;  ///< m, 1e-12 … 1: a Newton step that moves no point further is the last
  int max_iterations = 8;   ///< Newton steps a stage, 1 … 1000, before the step is taken again by implicit Euler

  /// Initial positions, as many as points; empty lays the cord out straight from the origin along +x.
  std::vector<Vec2> positions;
  /// Points constrained to where they start, by index.
  std::vector<int> pins;
};

/// Throws DefinitionError at the first field that is out of its range.
void check(const RopeDef& def);

/// What happened in one step, summed over its substeps.
struct RopeReport {
  int iterations = 0;   ///< Newton steps: linear solves, each O(points)
  int fallbacks = 0;    ///< substeps that did not converge and were taken again by implicit Euler
  int unconverged = 0;  ///< of those, the ones that did not converge either: taken as they are
};

/// A cord that does not stretch, however heavy what hangs on it: bars of stiffness EA or none at all, solved exactly
/// and at once along the cord in O(points). TR-BDF2 (Hosea & Shampine 1996), second order and L-stable; a step after
/// which something was constrained, released or moved is taken by SDIRK2 (Alexander 1977), of the same order, which
/// needs no acceleration from before. A step allocates nothing and throws nothing.
class Rope {
 public:
  /// Throws DefinitionError where check(def) does.
  explicit Rope(const RopeDef& def);

  const RopeDef& def() const { return def_; }
  std::span<const Vec2> positions() const { return positions_; }    ///< m
  std::span<const Vec2> velocities() const { return velocities_; }  ///< m/s
  /// N, by link; negative where a link is pushed together.
  std::span<const double> tensions() const { return tensions_; }
  /// kg, the point's share of the cord and what is attached to it.
  double mass(int point) const { return masses_[index(point)]; }

  /// Attaches a point mass [kg], 0 … 1e12, instead of the one attached before. Throws DefinitionError for an unknown
  /// index or a mass out of range.
  void attach_mass(int point, double mass);
  /// Constrains a point to `target` [m], reached evenly in the next step and then kept; throws DefinitionError for an
  /// unknown index or a coordinate beyond ±1e9.
  void constrain(int point, Vec2 target);
  /// Lets a constrained point go with the velocity it has.
  void release(int point);
  /// Sets a point's velocity, m/s, each component up to ±1e9.
  void set_velocity(int point, Vec2 velocity);

  /// Advances by dt seconds, 0 < dt ≤ 1, under `gravity` [m/s²].
  RopeReport step(double dt, Vec2 gravity);

  /// All that a later step depends on but for the definition.
  struct State {
    std::vector<Vec2> positions;
    std::vector<Vec2> velocities;
    std::vector<Vec2> accelerations;
    std::vector<Vec2> targets;
    std::vector<double> masses;
    std::vector<double> tensions;
    std::vector<char> constrained;
    bool restart = true;
    bool operator==(const State&) const = default;
  };
  State save() const;
  /// Continues from a saved state, to the same bits. Throws DefinitionError if it is of another size.
  void restore(const State& state);

 private:
  /// What the elimination keeps of a link for the substitution: how its tension and its further end follow from the
  /// step δb of the end before it, λ = tension + slope·δb, δa = shift + turn·δb.
  struct Link {
    double tension;
    Vec2 slope;
    Vec2 shift;
    Vec2 turn_x;  // the first row of the matrix, and
    Vec2 turn_y;  // the second
  };

  static std::size_t index(int point) { return static_cast<std::size_t>(point); }
  void check_point(int point) const;
  bool is_constrained(std::size_t point) const { return constrained_[point] != 0; }

  void substep(double dt, RopeReport& report);
  bool tr_bdf2(double dt, RopeReport& report);
  bool sdirk2(double dt, RopeReport& report);
  bool implicit_euler(double dt, RopeReport& report);
  bool solve_stage(double q, int max_iterations, RopeReport& report);
  double newton_step(double q);
  void place_constrained(double fraction);
  void accept(double q, std::span<const Vec2> velocity_guess);

  RopeDef def_;
  double link_length_;  // m
  double compliance_;   // link_length / EA, m/N

  std::vector<Vec2> positions_;
  std::vector<Vec2> velocities_;
  std::vector<Vec2> accelerations_;
  std::vector<Vec2> targets_;
  std::vector<double> masses_;
  std::vector<double> tensions_;
  std::vector<char> constrained_;
  bool restart_ = true;

  Vec2 gravity_;
  std::vector<Vec2> starts_;      // of constrained points at the start of the step
  std::vector<Vec2> predicted_;   // x̃ of the stage
  std::vector<Vec2> x0_, v0_;     // at the start of the substep
  std::vector<Vec2> x1_, v1_;     // after its first stage
  std::vector<Vec2> velocity_;    // ṽ of the stage: v = ṽ + q·a
  std::vector<double> tension0_;  // at the start of the substep
  std::vector<Link> links_;
};

}  // namespace ribbon
